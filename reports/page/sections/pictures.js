// The sequence of pictures becomes a stage. What is shown is kept in the address behind #, so that a link or a reload
// shows the same.
const root = document.documentElement;
window.addEventListener('error', (event) => { root.dataset.scriptError = event.message; });
const startStage = () => {
  const form = document.querySelector('.choosers');
  if (!form || !document.querySelector('.stage')) return;
  const stages = [...document.querySelectorAll('.stage')];
  const radios = (name) => [...form.querySelectorAll('input[type=radio]')].filter((input) => input.name === name);
  const chosen = (name) => radios(name).find((input) => input.checked)?.value ?? '';
  const choose = (name, value) => {
    const input = radios(name).find((other) => other.value === value && !other.disabled);
    if (input) input.checked = true;
    return Boolean(input);
  };
  const ofView = (kind) => kind === 'truth' || kind === 'noise' || kind === 'depth';
  let held = false;

  const current = () => {
    const view = chosen('view');
    return {
      view,
      cell: chosen(`cell-${view}`),
      kind: chosen('kind'),
      compare: chosen('compare'),
      cut: form.elements.cut.value,
      actual: form.elements.actual.checked,
    };
  };

  const find = (stage, kind, cell) => [...stage.querySelectorAll('figure')].find(
    (figure) => figure.dataset.kind === kind && figure.dataset.cell === (ofView(kind) ? '' : cell));

  const show = () => {
    const state = current();
    for (const set of form.querySelectorAll('.methods')) set.hidden = set.dataset.view !== state.view;
    form.querySelector('.cut').hidden = state.compare !== 'swipe';
    for (const stage of stages) {
      stage.hidden = stage.dataset.view !== state.view;
      if (stage.hidden) continue;
      const figures = stage.querySelector('.figures');
      const truth = find(stage, 'truth', '');
      // A method without a filter has no raw picture of its own: its output is it.
      const picture = find(stage, state.kind, state.cell) ?? find(stage, 'output', state.cell) ?? truth;
      for (const figure of figures.children) figure.classList.remove('shown', 'over', 'truth-side');
      picture.classList.add('shown');
      const swiping = state.compare === 'swipe' && picture !== truth;
      const beside = state.compare === 'beside' && picture !== truth;
      if (beside) truth.classList.add('shown', 'truth-side');
      if ((swiping || held) && picture !== truth && !beside) truth.classList.add('over');
      figures.classList.toggle('swiping', swiping && !held);
      figures.classList.toggle('beside', beside);
      figures.classList.toggle('actual', state.actual);
      figures.style.setProperty('--cut', held || !swiping ? '100%' : `${state.cut}%`);
      root.dataset.shown = `${picture.dataset.kind} ${picture.dataset.cell}`.trim();
    }
    root.dataset.view = state.view;
    root.dataset.compare = state.compare;
    root.dataset.held = String(held);
  };

  const remember = () => {
    const { view, cell, kind, compare, cut, actual } = current();
    const entries = new URLSearchParams({ view, cell, kind, compare });
    if (compare === 'swipe') entries.set('cut', cut);
    if (actual) entries.set('actual', '1');
    history.replaceState(null, '', `#${entries}`);
  };

  const recall = () => {
    const entries = new URLSearchParams(location.hash.slice(1));
    if (!entries.has('view')) return;
    choose('view', entries.get('view'));
    choose(`cell-${chosen('view')}`, entries.get('cell') ?? '');
    choose('kind', entries.get('kind') ?? '');
    choose('compare', entries.get('compare') ?? '');
    if (entries.has('cut')) form.elements.cut.value = entries.get('cut');
    form.elements.actual.checked = entries.has('actual');
  };

  const update = () => { show(); remember(); };
  form.addEventListener('change', update);
  form.addEventListener('input', update);
  form.addEventListener('submit', (event) => event.preventDefault());
  window.addEventListener('hashchange', () => { recall(); show(); });

  // Keys: 1-9 methods, T or Shift holds the truth, F one pixel for one. Not while writing or with other modifiers.
  const onStage = () => {
    const box = form.closest('.stage-layout').getBoundingClientRect();
    return box.top < innerHeight && box.bottom > 0;
  };
  const hold = (on) => { if (held !== on) { held = on; show(); } };
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || !onStage()) return;
    if (event.key === 'Shift' || event.key === 't' || event.key === 'T') {
      hold(true);
    } else if (event.key === 'f' || event.key === 'F') {
      form.elements.actual.checked = !form.elements.actual.checked;
      update();
    } else if (/^[1-9]$/.test(event.key)) {
      const input = radios(`cell-${chosen('view')}`)[Number(event.key) - 1];
      if (input && !input.disabled) { input.checked = true; update(); }
    }
  });
  addEventListener('keyup', (event) => {
    if (event.key === 'Shift' || event.key === 't' || event.key === 'T') hold(false);
  });
  addEventListener('blur', () => hold(false));

  // A drag over the picture moves the cut of a swipe; a pointer reads the visibility under it from the 8-bit pictures.
  const pixels = new Map();
  const visibilityAt = (figure, x, y) => {
    const image = figure?.querySelector('img');
    if (!image) return null;
    image.loading = 'eager';  // a picture that is not shown would never load
    if (!image.complete || !image.naturalWidth) return null;
    let context = pixels.get(image);
    if (!context) {
      const canvas = document.createElement('canvas');
      canvas.width = image.naturalWidth;
      canvas.height = image.naturalHeight;
      context = canvas.getContext('2d', { willReadFrequently: true });
      context.drawImage(image, 0, 0);
      if (pixels.size >= 4) pixels.delete(pixels.keys().next().value);
      pixels.set(image, context);
    }
    return context.getImageData(x, y, 1, 1).data[0] / 255;
  };

  const probe = (stage, event) => {
    const image = event.target.closest('.frame')?.querySelector('img');
    const text = stage.querySelector('.probe');
    if (!image?.naturalWidth) return;
    const box = image.getBoundingClientRect();
    const part = (event.clientX - box.left) / box.width;
    const x = Math.min(image.naturalWidth - 1, Math.max(0, Math.floor(part * image.naturalWidth)));
    const down = (event.clientY - box.top) / box.height;
    const y = Math.min(image.naturalHeight - 1, Math.max(0, Math.floor(down * image.naturalHeight)));
    const state = current();
    const truth = visibilityAt(find(stage, 'truth', ''), x, y);
    const output = visibilityAt(find(stage, 'output', state.cell), x, y);
    const parts = [`pixel ${x}, ${y}`];
    if (truth !== null) parts.push(`truth ${truth.toFixed(2)}`);
    if (output !== null) parts.push(`output ${output.toFixed(2)}`);
    if (truth !== null && output !== null) {
      const error = output - truth;
      parts.push(`error ${error < 0 ? '−' : '+'}${Math.abs(error).toFixed(2)}`);
    }
    text.textContent = `${parts.join('   ')}   (from 8-bit pictures)`;
    if (state.compare === 'swipe' && event.buttons === 1) {
      form.elements.cut.value = String(Math.round(part * 100));
      update();
    }
  };
  for (const stage of stages) {
    stage.querySelector('.probe').hidden = false;
    stage.addEventListener('pointermove', (event) => probe(stage, event));
    stage.addEventListener('pointerdown', (event) => {
      if (current().compare === 'swipe' && event.target.closest('.frame')) {
        event.preventDefault();
        probe(stage, event);
      }
    });
  }

  form.hidden = false;
  root.classList.add('scripted');
  recall();
  show();
  root.dataset.ready = 'true';
};
startStage();
