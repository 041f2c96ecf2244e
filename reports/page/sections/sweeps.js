// Curves of error over cost, one for each method, with the Pareto front on top. The table beneath says the same.
const costs = { ms: 'Cost, ms', relative: 'Cost, fixed passes', fetches: 'Fetches a pixel' };
const errors = { error: 'RMSE', noisy: 'RMSE with the truth’s noise', fitted: 'RMSE after the best fit' };

// One x axis for all curves: the union of their costs, with gaps that lines span.
const aligned = (curves, cost, error) => {
  const points = curves.map((curve) => curve.points.filter((p) => p[cost] > 0 && p[error] > 0));
  const xs = [...new Set(points.flat().map((p) => p[cost]))].sort((a, b) => a - b);
  const column = (list) => {
    const byCost = new Map();
    for (const p of list) byCost.set(p[cost], Math.min(p[error], byCost.get(p[cost]) ?? Infinity));
    return xs.map((x) => byCost.get(x) ?? null);
  };
  const front = [];
  for (const p of points.filter((list, i) => !curves[i].bound).flat().sort((a, b) => a[cost] - b[cost] || a[error] - b[error])) {
    if (!front.length || p[error] < front[front.length - 1][error]) front.push(p);
  }
  return [xs, ...points.map(column), column(front)];
};

const picker = (name, choices, chosen, onChange) => {
  const select = make('select', '');
  for (const [value, text] of Object.entries(choices)) select.add(new Option(text, value, value === chosen, value === chosen));
  select.addEventListener('change', () => onChange(select.value));
  return make('label', '', `${name} `, select);
};

// The intervals of the medians, across.
const drawIntervals = (chart, curves, error) => {
  const { ctx, bbox } = chart;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.setLineDash([]);
  ctx.lineWidth = uPlot.pxRatio;
  curves.forEach((curve, i) => {
    if (!chart.series[i + 1].show) return;
    ctx.strokeStyle = seriesLook(i).stroke;
    for (const point of curve.points.filter((p) => p.ms_low > 0 && p[error] > 0)) {
      const y = chart.valToPos(point[error], 'y', true);
      ctx.beginPath();
      ctx.moveTo(chart.valToPos(point.ms_low, 'x', true), y);
      ctx.lineTo(chart.valToPos(point.ms_high, 'x', true), y);
      ctx.stroke();
    }
  });
  ctx.restore();
};

const startChart = (place) => {
  const data = JSON.parse(place.querySelector('script').textContent);
  const has = (key) => data.curves.some((curve) => curve.points.some((p) => p[key] > 0));
  const offered = (choices) => Object.fromEntries(Object.entries(choices).filter(([key]) => has(key)));
  const chosen = { cost: 'ms', error: 'error' };
  const near = (chart, low, high) => [low / 1.1, high * 1.1];
  // With the intervals of the times, which are drawn too.
  const ends = data.curves.flatMap((curve) => curve.points.flatMap((p) => [p.ms_low, p.ms_high])).filter((ms) => ms > 0);
  const nearIntervals = (chart, low, high) => near(chart, Math.min(low, ...ends), Math.max(high, ...ends));
  const options = () => {
    const series = data.curves.map((curve, i) => {
      const look = seriesLook(i);
      return { ...look, label: curve.label, spanGaps: true, points: { show: true, size: 7, fill: look.stroke } };
    });
    const front = { label: 'Pareto front', stroke: pageColour('ink'), width: 1, dash: [6, 4], spanGaps: true, points: { show: false } };
    return {
      legend: { live: false },
      scales: { x: { time: false, distr: 3, range: chosen.cost === 'ms' ? nearIntervals : near }, y: { distr: 3, range: near } },
      axes: [logAxis(costs[chosen.cost]), logAxis(errors[chosen.error], { size: 70 })],
      series: [{ label: costs[chosen.cost] }, ...series, front],
      hooks: { draw: chosen.cost === 'ms' ? [(chart) => drawIntervals(chart, data.curves, chosen.error)] : [] },
    };
  };
  const canvas = make('div', '');
  const draw = () => {
    const fresh = make('div', '');
    canvas.replaceChildren(fresh);
    showChart(fresh, options, aligned(data.curves, chosen.cost, chosen.error));
  };
  const controls = make('p', '',
    picker('Across', offered(costs), chosen.cost, (value) => { chosen.cost = value; draw(); }), ' ',
    picker('up', offered(errors), chosen.error, (value) => { chosen.error = value; draw(); }));
  place.append(controls, canvas);
  draw();
};
whenBuilt('sweeps', (section) => {
  for (const place of section.querySelectorAll('.sweep-chart')) {
    if (place.querySelector('script').textContent.includes('"at"')) startChart(place);
  }
});
