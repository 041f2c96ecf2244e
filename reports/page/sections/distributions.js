// Histograms on a logarithmic axis, since most pixels are near 0, and cumulative curves; one hue and dash for each method.
const percentText = (value) => (value >= 1 || value === 0 ? String(Math.round(value)) : String(Number(value.toPrecision(1))));

// Curves of more methods than this hide one another: then only so many are drawn at first, the closest methods, and a click
// on a name in the legend draws another.
const mostCurves = 10;
const firstCurves = 6;

// The legend holds the shares at the error under the pointer, or at `rest` while there is none.
function curveChart(element, { scales, axes, mapped, rest }) {
  const { low, step, series } = chartData(element);
  const positions = Array.from(series[0].shares, (share, i) => Number((low + i * step).toFixed(6)));
  const nearest = positions.reduce((best, at, i) => (Math.abs(at - rest) < Math.abs(positions[best] - rest) ? i : best), 0);
  const data = [positions, ...series.map(({ shares }) => shares.map((share) => mapped(share * 100)))];
  showChart(element, () => ({
    cursor: { drag: { x: true, y: false } },
    scales: scales(positions),
    axes: axes(),
    series: [{ label: 'error', value: (chart, value, i, at) => numberText(positions[at ?? nearest], 3) },
      ...series.map(({ name, shares }, i) => ({ label: name, ...seriesLook(i), points: { show: false },
        show: series.length <= mostCurves || i < firstCurves,
        value: (chart, value, k, at) => `${numberText(shares[at ?? nearest] * 100, 2)} %` }))],
  }), data);
}

whenBuilt('distributions', (section) => {
  for (const element of section.querySelectorAll('.histogram-chart')) {
    curveChart(element, {
      scales: () => ({ x: { time: false, range: [-0.6, 0.6] }, y: { distr: 3, range: [0.01, 100] } }),
      axes: () => [chartAxis('output − truth'), chartAxis('% of the pixels', { size: 60,
        values: (chart, splits) => splits.map((value) => (Number.isInteger(Math.log10(value)) ? percentText(value) : '')) })],
      mapped: (percent) => (percent > 0 ? percent : null),
      rest: 0,
    });
  }
  for (const element of section.querySelectorAll('.cumulative-chart')) {
    curveChart(element, {
      scales: () => ({ x: { time: false, range: [0, 0.6] }, y: { range: [0, 100] } }),
      axes: () => [chartAxis('size of the error'), chartAxis('% of the pixels', { size: 60 })],
      mapped: (percent) => percent,
      rest: 0.1,
    });
  }
});
