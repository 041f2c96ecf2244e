// What the stage shows is kept in the address behind #, so that a link or a reload shows the same. `at=x,y,width,height`
// shows a region of the image, in pixels; `pixel=x,y` inspects one.
const addressNames = ['view', 'cell', 'picture', 'mode', 'against', 'cut', 'mix', 'rate', 'range'];

function stageAddress(stage) {
  const { choice, viewport } = stage;
  const entries = new URLSearchParams();
  for (const name of addressNames) {
    const control = stage.form.elements[name];
    if (control instanceof HTMLElement && (control.closest('[hidden]') || control.value === control.dataset.usual)) continue;
    entries.set(name, String(choice[name]));
  }
  if (choice.gray) entries.set('gray', '1');
  if (viewport.zoom > 1) {
    entries.set('zoom', [viewport.zoom, viewport.x, viewport.y].map((value) => value.toPrecision(5)).join());
  }
  if (stage.pinned) entries.set('pixel', `${stage.pinned.x},${stage.pinned.y}`);
  return `#${entries}`;
}

// The command that makes what the stage shows: the view's truth alone, one cell, or, where it shows several, the whole run.
function stageCommand(stage) {
  const { view, cell, choice } = stage;
  if (!cell || (choice.mode === 'alone' && choice.picture === 'noise')) return view.truthCommand;
  const shows = modes[choice.mode];
  return shows === modes.all || (shows !== modes.alone && choice.against) ? stageData.command : cellCommand(cell.id);
}

// True where the address is one of the stage's; what it names wrongly is left as it is.
function followAddress(stage) {
  const entries = new URLSearchParams(location.hash.slice(1));
  if (!entries.has('view')) return false;
  const { elements } = stage.form;
  stage.choose('view', entries.get('view'));
  stage.choose(`cell-${stage.view.key}`, entries.get('cell') ?? '');
  for (const name of ['picture', 'mode']) stage.choose(name, entries.get(name) ?? '');
  stage.fillAgainst(elements.against, stage.view.key);
  for (const name of ['cut', 'mix', 'rate', 'range', 'against']) {
    const value = entries.get(name);
    const { options } = elements[name];
    if (value !== null && (!options || [...options].some((option) => option.value === value))) elements[name].value = value;
  }
  elements.gray.checked = entries.has('gray');
  stage.update();
  const numbers = (name) => (entries.get(name) ?? '').split(',').map(Number);
  const [x, y, width, height] = numbers('at');
  const [zoom, u, v] = numbers('zoom');
  const [column, row] = numbers('pixel');
  if (width > 0 && height > 0) {
    stage.viewport.showRegion({ x, y, width, height }, ...stage.frame);
    stage.pin({ x: Math.floor(x + width / 2), y: Math.floor(y + height / 2) });
  } else if (zoom >= 1 && Number.isFinite(u) && Number.isFinite(v)) {
    Object.assign(stage.viewport, { zoom, x: u, y: v });
    stage.viewport.settle(...stage.frame);
  } else {
    stage.viewport.reset();
  }
  if (entries.has('pixel') && column >= 0 && row >= 0 && column < stage.view.width && row < stage.view.height) {
    stage.pin({ x: Math.floor(column), y: Math.floor(row) });
  }
  return true;
}

// The latest state is written when a burst of changes is over: browsers refuse more than about a hundred in ten seconds.
// What the stage shows at first is not written, so that a page that is loaded again opens at its top.
function useAddress(stage) {
  let waiting = 0;
  let written = '';
  stage.listeners.push(() => {
    const address = stageAddress(stage);
    written ||= address;
    clearTimeout(waiting);
    if (address === written) return;
    waiting = setTimeout(() => {
      written = address;
      history.replaceState(null, '', address);
    }, 250);
  });
  const follow = () => {
    if (followAddress(stage)) stage.element.scrollIntoView({ behavior: 'instant' });
  };
  addEventListener('hashchange', follow);
  queueMicrotask(follow);
  document.addEventListener('click', (event) => {
    const link = event.target.closest?.('a[href^="#view="]');
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    showOnStage(link.getAttribute('href'));
  });
}

// Leads to the stage, also where the address names already what it shows.
function showOnStage(address) {
  if (location.hash === address) dispatchEvent(new HashChangeEvent('hashchange'));
  else location.hash = address;
}

function chooseStageView(key) {
  const input = [...document.querySelectorAll('.choosers input[name=view]')].find(({ value }) => value === key);
  if (!input) return;
  input.checked = true;
  // A stage that is not in sight yet reads its form when it is.
  if (document.querySelector('.panes')?.childElementCount) input.dispatchEvent(new Event('change', { bubbles: true }));
}
