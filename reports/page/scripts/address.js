// What the stage shows is kept in the address behind #, so that a link or a reload shows the same. `at=x,y,width,height`
// shows a region of the image, in pixels.
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
  return `#${entries}`;
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
  if (width > 0 && height > 0) {
    stage.viewport.showRegion({ x, y, width, height }, ...stage.frame);
    stage.inspect({ x: Math.floor(x + width / 2), y: Math.floor(y + height / 2) });
  } else if (zoom >= 1 && Number.isFinite(u) && Number.isFinite(v)) {
    Object.assign(stage.viewport, { zoom, x: u, y: v });
    stage.viewport.settle(...stage.frame);
  } else {
    stage.viewport.reset();
  }
  return entries.has('at');
}

// The latest state is written when a burst of changes is over: browsers refuse more than about a hundred in ten seconds.
function useAddress(stage) {
  let waiting = 0;
  stage.listeners.push(() => {
    clearTimeout(waiting);
    waiting = setTimeout(() => history.replaceState(null, '', stageAddress(stage)), 250);
  });
  addEventListener('hashchange', () => {
    if (followAddress(stage)) stage.element.scrollIntoView();
  });
}
