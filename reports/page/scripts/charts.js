// Charts are uPlot's. What all of them share: the width of their place, the page's colours in both schemes, and series that
// differ by dash as well as by hue (Okabe, Ito, Color Universal Design, 2008).
const seriesHues = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#8a6d3b'];
const seriesDashes = [[], [7, 4], [2, 3], [10, 3, 2, 3]];

function pageColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

function seriesLook(i) {
  return { stroke: seriesHues[i % seriesHues.length], width: 2,
    dash: seriesDashes[Math.floor(i / seriesHues.length) % seriesDashes.length] };
}

function chartAxis(label, more = {}) {
  const line = { stroke: pageColour('line'), width: 1 };
  return { label, stroke: pageColour('ink'), grid: line, ticks: line, font: '13px system-ui, sans-serif',
    labelFont: '13px system-ui, sans-serif', labelSize: 22, ...more };
}

// 1, 2 and 5 of every decade, or 1 alone where there is no room for all their numbers; where that leaves fewer than three,
// even steps.
const roomForNumber_px = 40;

function logSplits(chart, axis, low, high) {
  const decades = (digits) => {
    const splits = [];
    for (let power = Math.floor(Math.log10(low)); 10 ** power <= high; power += 1) {
      splits.push(...digits.map((digit) => digit * 10 ** power).filter((value) => value >= low && value <= high));
    }
    return splits;
  };
  const { width, height } = chart.bbox;
  const room_px = (chart.axes[axis].side % 2 === 0 ? width : height) / uPlot.pxRatio;
  const all = decades([1, 2, 5]);
  const splits = all.length * roomForNumber_px > room_px ? decades([1]) : all;
  if (splits.length >= 3) return splits;
  if (all.length > splits.length && splits.length === 2) return splits;
  const decade = 10 ** Math.floor(Math.log10((high - low) / 3));
  const step = [5, 2, 1].map((digit) => digit * decade).find((size) => size <= (high - low) / 3);
  const even = [];
  for (let i = Math.ceil(low / step); i * step <= high; i += 1) even.push(i * step);
  return even;
}

function logAxis(label, more = {}) {
  return chartAxis(label, { splits: logSplits, filter: (chart, splits) => splits,
    values: (chart, splits) => splits.map((value) => String(Number(value.toPrecision(2)))), ...more });
}

// `options()` is asked anew when the colour scheme changes. Charts are made when they come near the window.
function showChart(element, options, data) {
  let chart = null;
  const size = () => ({ width: element.clientWidth, height: Math.round(Math.min(420, Math.max(300, element.clientWidth * 0.5))) });
  const build = () => {
    chart?.destroy();
    chart = new uPlot({ ...size(), ...options() }, data, element);
  };
  const seen = new IntersectionObserver((entries) => {
    if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
    seen.disconnect();
    build();
    new ResizeObserver(() => { if (chart.width !== element.clientWidth) chart.setSize(size()); }).observe(element);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', build);
  }, { rootMargin: '400px' });
  seen.observe(element);
}

// The JSON that a section put after the chart's place.
function chartData(element) {
  return JSON.parse(element.parentElement.querySelector('script[type="application/json"]').textContent);
}
