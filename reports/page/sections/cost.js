// Run time against error: points with bars for the spread, names beside them, and a step line along the Pareto front.
function drawBarsAndNames(chart, points) {
  const { ctx, bbox } = chart;
  const ratio = uPlot.pxRatio;
  const least = ({ ms, spread }) => Math.max(ms - spread, ms / 10);
  const at = (ms, error) => [chart.valToPos(ms, 'x', true), chart.valToPos(error, 'y', true)];
  const bars = points.map((point) => {
    const { ms, spread, error, low = error, high = error } = point;
    const [[x, y], [left, bottom], [right, top]] = [at(ms, error), at(least(point), low), at(ms + spread, high)];
    return { x, y, left, right, top, bottom };
  });
  // Names keep off points and other names, and off the bars and the steps of the front where there is room.
  const dots = bars.map(({ x, y }) => ({ left: x - 5 * ratio, right: x + 5 * ratio, top: y - 5 * ratio, bottom: y + 5 * ratio }));
  const stroke = (x0, y0, x1, y1) => ({ left: Math.min(x0, x1) - ratio, right: Math.max(x0, x1) + ratio,
    top: Math.min(y0, y1) - ratio, bottom: Math.max(y0, y1) + ratio });
  const front = bars.filter((bar, i) => points[i].front);
  const strokes = [...bars.flatMap(({ x, y, left, right, top, bottom }) => [stroke(left, y, right, y), stroke(x, top, x, bottom)]),
    ...front.slice(1).flatMap(({ x, y }, i) => [stroke(front[i].x, front[i].y, x, front[i].y), stroke(x, front[i].y, x, y)])];
  ctx.save();
  ctx.font = `${13 * ratio}px system-ui, sans-serif`;
  ctx.textAlign = 'left';
  ctx.textBaseline = 'middle';
  ctx.strokeStyle = ctx.fillStyle = pageColour('ink');
  ctx.lineWidth = ratio;
  const line = (x0, y0, x1, y1) => { ctx.beginPath(); ctx.moveTo(x0, y0); ctx.lineTo(x1, y1); ctx.stroke(); };
  bars.forEach(({ x, y, left, right, top, bottom }, i) => {
    line(left, y, right, y);
    line(x, top, x, bottom);
    const { label } = points[i];
    const width = ctx.measureText(label).width;
    const gap = 9 * ratio;
    const places = [];
    for (const beside of [x - width / 2, x + gap / 2, x - gap / 2 - width]) {
      places.push([beside, y - 1.5 * gap], [beside, y + 1.5 * gap], [beside, top - gap], [beside, bottom + gap]);
    }
    places.push([right + gap, y], [left - gap - width, y]);
    const boxes = places.map(([from, middle]) => ({ left: from, right: from + width, top: middle - 7 * ratio, bottom: middle + 7 * ratio }))
      .filter((box) => box.left >= bbox.left && box.right <= bbox.left + bbox.width && box.top >= bbox.top && box.bottom <= bbox.top + bbox.height);
    const freeOf = (taken) => (box) => !taken.some((other) => box.left < other.right && box.right > other.left
      && box.top < other.bottom && box.bottom > other.top);
    const box = boxes.find(freeOf([...dots, ...strokes])) ?? boxes.find(freeOf(dots));
    if (!box) return;
    dots.push(box);
    ctx.fillText(label, box.left, (box.top + box.bottom) / 2);
  });
  ctx.restore();
}

for (const element of document.querySelectorAll('.cost-chart')) {
  const points = chartData(element);
  const presets = new Set(points.map(({ preset }) => preset));
  for (const point of points) if (presets.size > 1) point.label = `${point.label}, ${point.preset}`;
  const times = points.map(({ ms }) => ms);
  const largest = Math.max(...points.map(({ error, high }) => high ?? error));
  const data = [times, points.map(({ error, front }) => (front ? error : null)),
    points.map(({ error, front, bound }) => (front || bound ? null : error)), points.map(({ error, bound }) => (bound ? error : null))];
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
      { paths: () => null, points: dot(pageColour('strong-line')) },
      { paths: () => null, points: { ...dot(pageColour('strong-line')), size: 6, width: 1 } }],
      hooks: { draw: [(chart) => drawBarsAndNames(chart, points)] },
    };
  };
  showChart(element, options, data);
}
