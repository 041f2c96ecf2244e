// Curves of error over cost, one for each method, with the Pareto front on top. The table beneath says the same.
const hues = [210, 25, 130, 350, 265, 50, 180, 310, 90, 235];
const costs = { ms: 'Cost, ms', relative: 'Cost, fixed passes', fetches: 'Fetches a pixel' };
const errors = { error: 'RMSE', raw: 'RMSE, raw', fitted: 'RMSE after the best fit' };

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
  for (const p of points.flat().sort((a, b) => a[cost] - b[cost] || a[error] - b[error])) {
    if (!front.length || p[error] < front[front.length - 1][error]) front.push(p);
  }
  return [xs, ...points.map(column), column(front)];
};

const picker = (name, choices, chosen, onChange) => {
  const label = document.createElement('label');
  label.textContent = `${name} `;
  const select = document.createElement('select');
  for (const [value, text] of Object.entries(choices)) select.add(new Option(text, value, value === chosen, value === chosen));
  select.addEventListener('change', () => onChange(select.value));
  label.append(select);
  return label;
};

const startChart = (place) => {
  const data = JSON.parse(place.querySelector('script').textContent);
  const has = (key) => data.curves.some((curve) => curve.points.some((p) => p[key] > 0));
  const offered = (choices) => Object.fromEntries(Object.entries(choices).filter(([key]) => has(key)));
  const shown = { cost: 'ms', error: 'error' };
  const canvas = document.createElement('div');
  let plot = null;
  const draw = () => {
    plot?.destroy();
    const colour = getComputedStyle(place).color;
    const axis = (label) => ({ label, stroke: colour, grid: { stroke: 'rgba(128,128,128,.25)' }, ticks: { stroke: colour } });
    const series = data.curves.map((curve, i) => {
      const stroke = `hsl(${hues[i % hues.length]} 70% ${i < hues.length ? 45 : 65}%)`;
      return { label: curve.label, stroke, width: 1.5, spanGaps: true, points: { show: true, size: 7, fill: stroke } };
    });
    plot = new uPlot({
      width: Math.max(place.clientWidth, 280),
      height: 380,
      scales: { x: { time: false, distr: 3 }, y: { distr: 3 } },
      axes: [axis(costs[shown.cost]), { ...axis(errors[shown.error]), size: 70 }],
      series: [{ label: costs[shown.cost] }, ...series, { label: 'Pareto front', stroke: colour, width: 1, dash: [6, 4], spanGaps: true, points: { show: false } }],
    }, aligned(data.curves, shown.cost, shown.error), canvas);
  };
  const controls = document.createElement('p');
  controls.append(
    picker('Across', offered(costs), shown.cost, (value) => { shown.cost = value; draw(); }), ' ',
    picker('up', offered(errors), shown.error, (value) => { shown.error = value; draw(); }));
  place.append(controls, canvas);
  draw();
  window.addEventListener('resize', () => plot.setSize({ width: Math.max(place.clientWidth, 280), height: 380 }));
};
for (const place of document.querySelectorAll('.sweep-chart')) {
  if (place.querySelector('script').textContent.includes('"at"')) startChart(place);
}
