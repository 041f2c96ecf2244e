// Run time against error: points with bars for the spread, names beside them, and a step line along the Pareto front.
function drawBarsAndNames(chart, points) {
  const { ctx, bbox } = chart;
  const ratio = uPlot.pxRatio;
  const least = ({ ms, spread }) => Math.max(ms - spread, ms / 10);
  const taken = points.map((point) => {
    const [x0, x1] = [least(point), point.ms + point.spread].map((ms) => chart.valToPos(ms, 'x', true));
    const y = chart.valToPos(point.error, 'y', true);
    return { left: x0 - 5 * ratio, right: x1 + 5 * ratio, top: y - 5 * ratio, bottom: y + 5 * ratio };
  });
  ctx.save();
  ctx.font = `${13 * ratio}px system-ui, sans-serif`;
  ctx.textAlign = 'left';
  ctx.textBaseline = 'middle';
  ctx.strokeStyle = ctx.fillStyle = pageColour('ink');
  ctx.lineWidth = ratio;
  const line = (x0, y0, x1, y1) => { ctx.beginPath(); ctx.moveTo(x0, y0); ctx.lineTo(x1, y1); ctx.stroke(); };
  for (const point of points) {
    const [x, y] = [chart.valToPos(point.ms, 'x', true), chart.valToPos(point.error, 'y', true)];
    line(chart.valToPos(least(point), 'x', true), y, chart.valToPos(point.ms + point.spread, 'x', true), y);
    if (point.low !== undefined) line(x, chart.valToPos(point.low, 'y', true), x, chart.valToPos(point.high, 'y', true));
    const width = ctx.measureText(point.label).width;
    const gap = 9 * ratio;
    const beyond = chart.valToPos(point.ms + point.spread, 'x', true) + gap;
    const places = [[x - width / 2, y - 1.5 * gap], [x, y - 1.5 * gap], [x - width, y - 1.5 * gap],
      [x - width / 2, y + 1.5 * gap], [x, y + 1.5 * gap], [x - width, y + 1.5 * gap], [beyond, y]];
    const boxes = places.map(([left, middle]) => ({ left, right: left + width, top: middle - 7 * ratio, bottom: middle + 7 * ratio }));
    const free = (box) => box.left >= bbox.left && box.right <= bbox.left + bbox.width && box.top >= bbox.top
      && box.bottom <= bbox.top + bbox.height && !taken.some((other) => box.left < other.right && box.right > other.left
        && box.top < other.bottom && box.bottom > other.top);
    const at = boxes.find(free);
    if (!at) continue;
    taken.push(at);
    ctx.fillText(point.label, at.left, (at.top + at.bottom) / 2);
  }
  ctx.restore();
}

for (const element of document.querySelectorAll('.cost-chart')) {
  const points = chartData(element);
  const presets = new Set(points.map(({ preset }) => preset));
  for (const point of points) if (presets.size > 1) point.label = `${point.label}, ${point.preset}`;
  const times = points.map(({ ms }) => ms);
  const largest = Math.max(...points.map(({ error, high }) => high ?? error));
  const data = [times, points.map(({ error, front }) => (front ? error : null)),
    points.map(({ error, front }) => (front ? null : error))];
  const options = () => {
    const dot = (colour) => ({ show: true, size: 9, width: 2, stroke: colour, fill: pageColour('paper') });
    return {
      legend: { show: false },
      cursor: { drag: { x: false, y: false }, points: { show: false } },
      scales: { x: { time: false, distr: 3, range: (chart, low, high) => [low / 1.6, high * 1.9] },
        y: { range: [0, largest * 1.15] } },
      axes: [logAxis('AO and filter, ms'),
        chartAxis(element.dataset.metric, { size: 60 })],
      series: [{}, { paths: uPlot.paths.stepped({ align: 1 }), stroke: pageColour('accent'), width: 2, spanGaps: true,
        points: { ...dot(pageColour('accent')), fill: pageColour('accent') } },
      { paths: () => null, points: dot(pageColour('strong-line')) }],
      hooks: { draw: [(chart) => drawBarsAndNames(chart, points)] },
    };
  };
  showChart(element, options, data);
}
