(() => {
'use strict';
const { views, contestants, order, cells: rows } = JSON.parse(document.getElementById('index-data').textContent);
const numberText = (value, decimals) => (value === null ? '–' : value.toFixed(decimals).replace('-', '−'));
const cells = rows.map(([view, contestant, error, low, high, bias, rank, ms, fetches, link, failure]) =>
  ({ view: views[view], contestant, error, low, high, bias, rank, ms, fetches, link, failure, name: contestants[contestant].name,
    words: `${views[view].scene}/${views[view].view} ${contestants[contestant].name}`.toLowerCase() }));
const form = document.querySelector('.filters');
const step = 200;
let limit = step;
let sorting = { column: null, descending: false };

function make(tag, className, ...children) {
  const element = document.createElement(tag);
  if (className) element.className = className;
  element.append(...children);
  return element;
}

// Ranked contestants stand first, in their order; of the others those with most cells.
function contestantsInOrder() {
  const counts = contestants.map((_, i) => cells.filter(({ contestant, error }) => contestant === i && error !== null).length);
  const others = contestants.map((_, i) => i).filter((i) => !order.includes(i));
  return [...order, ...others.sort((a, b) => counts[b] - counts[a] || contestants[a].name.localeCompare(contestants[b].name))];
}

// The root of the mean square over the cells of each contestant on each scene.
function sceneErrors() {
  const sums = new Map();
  for (const { view, contestant, error } of cells) {
    if (error === null) continue;
    const key = `${contestant} ${view.scene}`;
    const [sum, count] = sums.get(key) ?? [0, 0];
    sums.set(key, [sum + error * error, count + 1]);
  }
  return (contestant, scene) => {
    const [sum, count] = sums.get(`${contestant} ${scene}`) ?? [0, 0];
    return count ? Math.sqrt(sum / count) : null;
  };
}

function picture(view) {
  return view?.picture ? Object.assign(make('img'), { src: view.picture, alt: '', loading: 'lazy' }) : '';
}

function buildMatrix(scenes) {
  const errorOf = sceneErrors();
  const all = contestantsInOrder();
  const largest = Math.max(...all.flatMap((i) => scenes.map((scene) => errorOf(i, scene) ?? 0)), 1e-9);
  const head = make('tr', '', Object.assign(make('th', 'text', 'Method, preset, filter'), { scope: 'col' }),
    ...scenes.map((scene) => Object.assign(make('th', '', picture(views.find((view) => view.scene === scene && view.picture)), scene), { scope: 'col' })));
  const lines = all.map((i) => make('tr', '', Object.assign(make('th', '', contestants[i].name), { scope: 'row' }),
    ...scenes.map((scene) => {
      const error = errorOf(i, scene);
      if (error === null) return make('td', 'none', '–');
      const button = Object.assign(make('button', '', numberText(error, 4)), { type: 'button', title: `${contestants[i].name} on ${scene}` });
      button.style.setProperty('--share', `${Math.round(45 * error / largest)}%`);
      button.addEventListener('click', () => {
        Object.assign(form.elements.scene, { value: scene });
        Object.assign(form.elements.contestant, { value: String(i) });
        form.elements.only.value = form.elements.text.value = '';
        showCells();
        document.getElementById('cells').scrollIntoView();
      });
      return make('td', '', button);
    })));
  document.querySelector('.matrix').append(make('thead', '', head), make('tbody', '', ...lines));
}

const linked = (cell) => (cell.link ? Object.assign(make('a', '', cell.name), { href: cell.link }) : cell.name);
const columns = [
  { title: '', cell: ({ view }) => picture(view) },
  { title: 'Scene', text: true, by: ({ view }) => `${view.scene}/${view.view}`, cell: ({ view }) => `${view.scene}/${view.view}` },
  { title: 'Method, preset, filter', head: true, by: ({ name }) => name, cell: linked },
  { title: 'Rank', by: ({ rank }) => (Number.parseInt(rank, 10) || null), cell: ({ rank }) => rank || '–' },
  { title: 'debiased RMSE', by: ({ error }) => error, cell: ({ error }) => numberText(error, 4) },
  { title: '95 %', by: ({ low, high }) => (low === null ? null : high - low), cell: ({ low, high }) => (low === null ? '–' : `${numberText(low, 4)} to ${numberText(high, 4)}`) },
  { title: 'Bias', by: ({ bias }) => bias, cell: ({ bias }) => numberText(bias, 4) },
  { title: 'AO and filter, ms', by: ({ ms }) => ms, cell: ({ ms }) => numberText(ms, 1) },
  { title: 'Fetches', by: ({ fetches }) => fetches, cell: ({ fetches }) => numberText(fetches, 1) },
  { title: 'Size', by: ({ view }) => view.size, cell: ({ view }) => view.size },
  { title: 'R, m', by: ({ view }) => Number(view.radius), cell: ({ view }) => view.radius },
];

function wanted() {
  const { scene, contestant, only, text } = Object.fromEntries(new FormData(form));
  const words = text.toLowerCase();
  return cells.filter((cell) => (!scene || cell.view.scene === scene) && (!contestant || cell.contestant === Number(contestant))
    && (!words || cell.words.includes(words)) && (only !== 'failed' || cell.failure) && (only !== 'first' || /^1\b/.test(cell.rank)));
}

function sorted(list) {
  const { column, descending } = sorting;
  if (!column) return list;
  const keyed = list.map((cell) => [column.by(cell), cell]);
  const compare = (a, b) => (typeof a === 'string' ? a.localeCompare(b) : a - b);
  // What has no number stands last either way.
  return keyed.sort(([a], [b]) => (a === null || b === null ? (a === null) - (b === null) : descending ? compare(b, a) : compare(a, b))).map(([, cell]) => cell);
}

function rowOf(cell) {
  return make('tr', cell.failure ? 'failed' : '', ...columns.map(({ title, text, head, cell: show }) => {
    if (cell.failure && title === 'debiased RMSE') return Object.assign(make('td', 'text reason', make('strong', '', 'failed: '), cell.failure), { colSpan: 5 });
    if (cell.failure && ['95 %', 'Bias', 'AO and filter, ms', 'Fetches'].includes(title)) return null;
    const element = make(head ? 'th' : 'td', text ? 'text' : '', show(cell));
    if (head) element.scope = 'row';
    return element;
  }).filter(Boolean));
}

function showCells() {
  const list = sorted(wanted());
  document.querySelector('.cells tbody').replaceChildren(...list.slice(0, limit).map(rowOf));
  form.querySelector('output').textContent = `${Math.min(limit, list.length)} of ${list.length} cells are shown`;
  document.querySelector('.more').hidden = list.length <= limit;
}

function buildHeads() {
  document.querySelector('.cells thead tr').append(...columns.map((column) => {
    const th = Object.assign(make('th', column.text || column.head ? 'text' : ''), { scope: 'col' });
    if (!column.by) {
      th.append(make('span', 'visually-hidden', 'Picture'));
      return th;
    }
    const button = Object.assign(make('button', '', column.title), { type: 'button' });
    button.addEventListener('click', () => {
      sorting = { column, descending: sorting.column === column && !sorting.descending };
      for (const other of document.querySelectorAll('.cells th[aria-sort]')) other.removeAttribute('aria-sort');
      th.setAttribute('aria-sort', sorting.descending ? 'descending' : 'ascending');
      showCells();
    });
    th.append(button);
    return th;
  }));
}

const scenes = [...new Set(views.map(({ scene }) => scene))].sort((a, b) => a.localeCompare(b));
form.elements.scene.append(...scenes.map((scene) => new Option(scene, scene)));
form.elements.contestant.append(...contestantsInOrder().map((i) => new Option(contestants[i].name, String(i))));
form.addEventListener('input', () => { limit = step; showCells(); });
form.addEventListener('submit', (event) => event.preventDefault());
document.querySelector('.more').addEventListener('click', () => { limit += step; showCells(); });
buildHeads();
buildMatrix(scenes);
showCells();
document.documentElement.dataset.interactive = performance.now().toFixed(0);
})();
