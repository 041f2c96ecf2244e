const { views, contestants, order, cells: rows } = JSON.parse(document.getElementById('index-data').textContent);
const numberText = (value, decimals) => (value === null ? '–' : value.toFixed(decimals).replace('-', '−'));
const cells = rows.map(([view, contestant, error, low, high, bias, rank, ms, fetches, link, failure, light]) =>
  ({ view: views[view], contestant, error, low, high, bias, rank, ms, fetches, link, failure, light, name: contestants[contestant].name,
    words: `${views[view].scene}/${views[view].view} ${contestants[contestant].name}`.toLowerCase() }));
const form = document.querySelector('.filters');
const step = 200;
let limit = step;
let cellColumns = null;  // of the table of cells, once it has a place
let sorting = { column: null, descending: false };

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

// The shorter list stands across, the longer one down.
function buildMatrix(scenes) {
  const errorOf = sceneErrors();
  const methods = contestantsInOrder();
  const largest = Math.max(...methods.flatMap((i) => scenes.map((scene) => errorOf(i, scene) ?? 0)), 1e-9);
  const cellOf = (i, scene) => {
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
  };
  const headOf = (scope, ...content) => Object.assign(make('th', '', ...content), { scope });
  const methodList = { title: 'Method, preset, filter', all: methods, head: (scope, i) => headOf(scope, contestants[i].name) };
  const sceneList = { title: 'Scene', all: scenes,
    head: (scope, scene) => headOf(scope, picture(views.find((view) => view.scene === scene && view.picture)), make('span', '', scene)) };
  const isSceneAcross = scenes.length <= methods.length;
  const [across, down] = isSceneAcross ? [sceneList, methodList] : [methodList, sceneList];
  const corner = headOf('col', down.title);
  corner.className = 'text';
  const lines = down.all.map((row) => make('tr', '', down.head('row', row),
    ...across.all.map((column) => (isSceneAcross ? cellOf(row, column) : cellOf(column, row)))));
  document.querySelector('.matrix').append(make('thead', '', make('tr', '', corner, ...across.all.map((column) => across.head('col', column)))),
    make('tbody', '', ...lines));
}

const linked = (cell) => (cell.link ? Object.assign(make('a', '', cell.name), { href: cell.link }) : cell.name);
const columns = [
  { title: '', keep: 4, cell: ({ view }) => picture(view) },
  { title: 'Scene', keep: 3, text: true, by: ({ view }) => `${view.scene}/${view.view}`, cell: ({ view }) => `${view.scene}/${view.view}` },
  { title: 'Method, preset, filter', head: true, by: ({ name }) => name, cell: linked },
  { title: 'Rank', keep: 2, by: ({ rank }) => (Number.parseInt(rank, 10) || null), cell: ({ rank }) => rank || '–' },
  { title: 'RMSE, debiased', keep: 0, by: ({ error }) => error, cell: ({ error }) => numberText(error, 4) },
  { title: '95 %', by: ({ low, high }) => (low === null ? null : high - low), cell: ({ low, high }) => (low === null ? '–' : `${numberText(low, 4)} to ${numberText(high, 4)}`) },
  { title: 'Bias', by: ({ bias }) => bias, cell: ({ bias }) => numberText(bias, 4) },
  { title: 'AO and filter, ms', by: ({ ms }) => ms, cell: ({ ms }) => numberText(ms, 1) },
  { title: 'Fetches', by: ({ fetches }) => fetches, cell: ({ fetches }) => numberText(fetches, 1) },
  ...cells.some(({ light }) => light) ? [{ title: 'Light, error in %', keep: 5, by: ({ light }) => light?.[0] ?? null,
    cell: ({ light }) => (light ? make('span', '', numberText(light[0], 1), make('span', 'unit', `${light[1]}, ${light[2]}`)) : '–') }] : [],
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
    if (cell.failure && title === 'RMSE, debiased') return Object.assign(make('td', 'text reason', make('strong', '', 'failed: '), cell.failure), { colSpan: 5 });
    if (cell.failure && ['95 %', 'Bias', 'AO and filter, ms', 'Fetches'].includes(title)) return null;
    const element = make(head ? 'th' : 'td', text ? 'text' : '', show(cell));
    if (head) element.scope = 'row';
    return element;
  }).filter(Boolean));
}

function showCells() {
  const list = sorted(wanted());
  document.querySelector('.cells tbody').replaceChildren(...list.slice(0, limit).map(rowOf));
  cellColumns?.apply();
  form.querySelector('output').textContent = `${Math.min(limit, list.length)} of ${list.length} cells are shown`;
  document.querySelector('.more').hidden = list.length <= limit;
}

function buildHeads() {
  document.querySelector('.cells thead tr').append(...columns.map((column) => {
    const th = Object.assign(make('th', column.text || column.head ? 'text' : ''), { scope: 'col' });
    if ('keep' in column) th.dataset.keep = column.keep;
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
cellColumns = useColumns(document).find(({ table }) => table.classList.contains('cells'));
document.documentElement.dataset.interactive = performance.now().toFixed(0);
