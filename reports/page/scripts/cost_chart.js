// Run time against error: points with bars for the spread, names beside them, and a step line along the Pareto front.

// Where a name may stand: over, under and beside its point, nearest first, then farther off; only places within the chart.
function namePlaces({ x, y, left, right, top, bottom }, width, ratio, bbox) {
  const gap = 9 * ratio;
  const places = [];
  for (const beside of [x - width / 2, x + gap / 2, x - gap / 2 - width]) {
    places.push([beside, y - 1.5 * gap], [beside, y + 1.5 * gap], [beside, top - gap], [beside, bottom + gap]);
  }
  places.push([right + gap, y], [left - gap - width, y]);
  for (let away = 3; away <= 15; away += 1) {
    for (const beside of [x - width / 2, x + gap, x - gap - width]) places.push([beside, y + away * gap], [beside, y - away * gap]);
  }
  return places.map(([from, middle]) => ({ left: from, right: from + width, top: middle - 7 * ratio, bottom: middle + 7 * ratio }))
    .filter((box) => box.left >= bbox.left && box.right <= bbox.left + bbox.width && box.top >= bbox.top && box.bottom <= bbox.top + bbox.height);
}

// A thin line to a name that stands far from its point.
function drawLeader(ctx, { x, y }, box, ratio) {
  const to = [Math.min(Math.max(x, box.left), box.right), box.top > y ? box.top : box.bottom];
  if (Math.hypot(to[0] - x, to[1] - y) < 20 * ratio) return;
  ctx.save();
  ctx.strokeStyle = pageColour('strong-line');
  ctx.beginPath();
  ctx.moveTo(x, y);
  ctx.lineTo(...to);
  ctx.stroke();
  ctx.restore();
}

// The bars of each point, in pixels of the canvas.
function barsOf(chart, points) {
  const at = (ms, error) => [chart.valToPos(ms, 'x', true), chart.valToPos(error, 'y', true)];
  return points.map(({ ms, spread, error, low = error, high = error }) => {
    const [[x, y], [left, bottom], [right, top]] = [at(ms, error), at(Math.max(ms - spread, ms / 10), low), at(ms + spread, high)];
    return { x, y, left, right, top, bottom };
  });
}

// Names keep off points and other names. They keep off the bars and the steps of the front too where that does not lead them
// farther than this from their point.
const strokeWorth_px = 40;

function drawNames(ctx, bars, points, ratio, bbox) {
  const dots = bars.map(({ x, y }) => ({ left: x - 5 * ratio, right: x + 5 * ratio, top: y - 5 * ratio, bottom: y + 5 * ratio }));
  const stroke = (x0, y0, x1, y1) => ({ left: Math.min(x0, x1) - ratio, right: Math.max(x0, x1) + ratio,
    top: Math.min(y0, y1) - ratio, bottom: Math.max(y0, y1) + ratio });
  const front = bars.filter((bar, i) => points[i].front);
  const drawn = bars.filter((bar, i) => !points[i].bare);
  const strokes = [...drawn.flatMap(({ x, y, left, right, top, bottom }) => [stroke(left, y, right, y), stroke(x, top, x, bottom)]),
    ...front.slice(1).flatMap(({ x, y }, i) => [stroke(front[i].x, front[i].y, x, front[i].y), stroke(x, front[i].y, x, y)])];
  bars.forEach((bar, i) => {
    const { label } = points[i];
    if (!label) return;
    const boxes = namePlaces(bar, ctx.measureText(label).width, ratio, bbox);
    const meets = (box, taken) => taken.some((other) => box.left < other.right && box.right > other.left
      && box.top < other.bottom && box.bottom > other.top);
    const away = ({ left, right, top, bottom }) => Math.hypot(Math.max(left - bar.x, bar.x - right, 0), Math.max(top - bar.y, bar.y - bottom, 0));
    const cost = (box) => away(box) + (meets(box, strokes) ? strokeWorth_px * ratio : 0);
    const [box] = boxes.filter((one) => !meets(one, dots)).sort((a, b) => cost(a) - cost(b));
    if (!box) return;
    dots.push(box);
    drawLeader(ctx, bar, box, ratio);
    ctx.fillText(label, box.left, (box.top + box.bottom) / 2);
  });
}

function drawBarsAndNames(chart, points) {
  const { ctx, bbox } = chart;
  const ratio = uPlot.pxRatio;
  const bars = barsOf(chart, points);
  ctx.save();
  ctx.font = `${13 * ratio}px system-ui, sans-serif`;
  ctx.textAlign = 'left';
  ctx.textBaseline = 'middle';
  ctx.strokeStyle = ctx.fillStyle = pageColour('ink');
  ctx.lineWidth = ratio;
  const line = (x0, y0, x1, y1) => { ctx.beginPath(); ctx.moveTo(x0, y0); ctx.lineTo(x1, y1); ctx.stroke(); };
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  bars.forEach(({ x, y, left, right, top, bottom }, i) => {
    if (points[i].bare) return;
    line(left, y, right, y);
    line(x, top, x, bottom);
  });
  ctx.restore();
  drawNames(ctx, bars, points, ratio, bbox);
  ctx.restore();
}

// A dot, or a place near it, shows its name under the pointer, and on a click its picture on the stage, where there is one.
const dotReach_px = 14;

function answerPointer(chart, points, view) {
  const clickable = document.querySelector('.stage') !== null;
  const nearest = (event) => {
    const { left, top } = chart.over.getBoundingClientRect();
    const away = ({ ms, error }) => Math.hypot(chart.valToPos(ms, 'x') - event.clientX + left, chart.valToPos(error, 'y') - event.clientY + top);
    const [point] = [...points].sort((a, b) => away(a) - away(b));
    return point && away(point) <= dotReach_px ? point : null;
  };
  chart.over.addEventListener('mousemove', (event) => {
    const point = nearest(event);
    chart.over.style.cursor = point && clickable ? 'pointer' : '';
    chart.over.title = point ? `${point.name}: ${numberText(point.ms, 2)} ms, ${numberText(point.error, 4)}` : '';
  });
  chart.over.addEventListener('click', (event) => {
    const point = nearest(event);
    if (point && clickable) showOnStage(`#${new URLSearchParams({ view, cell: point.cell, picture: 'error', mode: 'beside' })}`);
  });
}

const roomForName_px = 35;  // of a chart's width

// A brief chart leaves out bounds, has names and bars for the methods on the front alone, and a logarithmic axis of errors,
// so that one poor method does not press all others together.
function startCostChart(element, { brief = false } = {}) {
  const all = chartData(element);
  // Where there is no room for all names the front has some, and the others show theirs under the pointer. Names leave out
  // presets where they tell nothing.
  const crowded = all.length * roomForName_px > element.clientWidth;
  const named = all.filter(({ front }) => front || !(brief || crowded));
  const ambiguous = ({ label, cell }) => named.some((other) => other.label === label && other.cell !== cell);
  const points = (brief ? all.filter(({ bound }) => !bound) : all).map((point) => {
    const name = `${point.label}, ${point.preset}`;
    return { ...point, name, bare: brief && !point.front, label: !named.includes(point) ? '' : ambiguous(point) ? name : point.label };
  });
  if (points.length === 0) return;
  const largest = Math.max(...points.map(({ error, high }) => high ?? error));
  // The points' own ends: uPlot would put a single point into the middle of decades.
  const around = (name, below, above) => {
    const values = points.map((point) => point[name]);
    return () => [Math.min(...values) / below, Math.max(...values) * above];
  };
  const series = (shown) => points.map((point) => (shown(point) ? point.error : null));
  const data = [points.map(({ ms }) => ms), series(({ front }) => front), series(({ front, bound }) => !front && !bound), series(({ bound }) => bound)];
  const options = () => {
    const dot = (colour) => ({ show: true, size: 9, width: 2, stroke: colour, fill: pageColour('paper') });
    return {
      legend: { show: false },
      cursor: { drag: { x: false, y: false }, points: { show: false } },
      scales: { x: { time: false, distr: 3, range: around('ms', 1.6, 1.9) },
        y: brief ? { distr: 3, range: around('error', 2.4, 1.2) } : { range: [0, largest * 1.15] } },
      axes: [logAxis('AO and filter, ms'), (brief ? logAxis : chartAxis)(element.dataset.metric, { size: 60 })],
      series: [{}, { paths: uPlot.paths.stepped({ align: 1 }), stroke: pageColour('accent'), width: 2, spanGaps: true,
        points: { ...dot(pageColour('accent')), fill: pageColour('accent') } },
      { paths: () => null, points: dot(pageColour('strong-line')) },
      { paths: () => null, points: { ...dot(pageColour('strong-line')), size: 6, width: 1 } }],
      hooks: { draw: [(chart) => drawBarsAndNames(chart, points)], ready: [(chart) => answerPointer(chart, points, element.dataset.view)] },
    };
  };
  showChart(element, options, data);
}
