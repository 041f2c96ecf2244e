// The stage's keys. They work while the stage is in sight and nothing is being written; arrows only where they would not
// move something else, on the panes. The help is made from this table.
const stageKeys = [
  { keys: '1 … 9', text: 'choose a method', test: (key) => /^[1-9]$/.test(key),
    act: (stage, key) => { stage.radios(`cell-${stage.view.key}`)[Number(key) - 1]?.click(); } },
  { keys: '← →', text: 'step through the methods (on the pictures)', test: (key) => /^Arrow(Left|Right)$/.test(key),
    onPanes: true, act: (stage, key) => stage.step(`cell-${stage.view.key}`, key === 'ArrowRight' ? 1 : -1) },
  { keys: '↑ ↓', text: 'step through what is shown (on the pictures)', test: (key) => /^Arrow(Up|Down)$/.test(key),
    onPanes: true, act: (stage, key) => stage.step('picture', key === 'ArrowDown' ? 1 : -1) },
  { keys: 'M', text: 'next way of comparing', test: (key) => key === 'm', act: (stage) => stage.step('mode', 1) },
  { keys: 'V', text: 'next view', test: (key) => key === 'v', act: (stage) => stage.step('view', 1) },
  { keys: 'Shift', text: 'hold to see the truth', test: (key) => key === 'Shift', act: (stage) => stage.hold(true) },
  { keys: 'Space', text: 'change what blinks, by hand (on the pictures)', test: (key) => key === ' ', onPanes: true,
    act: (stage) => {
      stage.blink.running = false;
      stage.blink.set(0);
      stage.blink.change();
    } },
  { keys: '+ −', text: 'zoom', test: (key) => /^[+=-]$/.test(key),
    act: (stage, key) => stage.zoomBy(key === '-' ? 1 / 1.5 : 1.5) },
  { keys: 'W A S D', text: 'inspect the neighbouring pixel', test: (key) => /^[wasd]$/.test(key), act: moveInspected },
  { keys: 'P', text: 'one pixel for one', test: (key) => key === 'p', act: (stage) => stage.zoomToPixels() },
  { keys: 'F', text: 'fit', test: (key) => key === 'f', act: (stage) => stage.viewport.reset() },
  { keys: 'R', text: 'reset the stage', test: (key) => key === 'r', act: (stage) => resetStage(stage) },
  { keys: '?', text: 'this help', test: (key) => key === '?', act: (stage) => showHelp(stage) },
];

// Steps from the inspected pixel, or from what is amid, and keeps it in sight.
function moveInspected(stage, key) {
  const { view, viewport } = stage;
  const from = stage.pixel ?? { x: Math.floor(viewport.x * view.width), y: Math.floor(viewport.y * view.height) };
  const step = { w: [0, -1], a: [-1, 0], s: [0, 1], d: [1, 0] }[key];
  const held = (value, size) => Math.min(Math.max(value, 0), size - 1);
  const pixel = { x: held(from.x + step[0], view.width), y: held(from.y + step[1], view.height) };
  const [w, h] = stage.frame;
  const place = viewport.placeIn(w, h, view);
  const [px, py] = [place.left + (pixel.x + 0.5) * place.scale, place.top + (pixel.y + 0.5) * place.scale];
  if (px < 0 || py < 0 || px > w || py > h) viewport.moveBy(w / 2 - px, h / 2 - py, w, h, view);
  stage.pin(pixel);
}

function resetStage(stage) {
  stage.form.reset();
  stage.pixel = stage.pinned = null;
  stage.blink.showsTop = false;
  stage.viewport.reset();
  stage.update();
}

function showHelp(stage) {
  stage.element.querySelector('dialog').showModal();
}

function useKeys(stage) {
  const inSight = () => {
    const { top, bottom } = stage.element.getBoundingClientRect();
    return top < innerHeight && bottom > 0;
  };
  const writing = (target) => target.closest?.('input:not([type=radio], [type=checkbox]), select, textarea, dialog, .uplot');
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || !inSight() || writing(event.target)) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const entry = stageKeys.find(({ test }) => test(key));
    if (!entry || (entry.onPanes && !stage.panesBox.contains(event.target))) return;
    if (entry.onPanes) event.preventDefault();
    if (!event.repeat || !['Shift', '?'].includes(key)) entry.act(stage, key);
  });
  addEventListener('keyup', (event) => { if (event.key === 'Shift') stage.hold(false); });
  addEventListener('blur', () => stage.hold(false));
  stage.element.querySelector('.key-table tbody').append(...stageKeys.map(({ keys, text }) => {
    const head = make('th', '', make('kbd', '', keys));
    head.scope = 'row';
    return make('tr', '', head, make('td', '', text));
  }));
}
