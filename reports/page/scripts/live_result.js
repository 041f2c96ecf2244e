const liveErrorRange = 0.5;

// Modes of a measured cell beside the usual ones; what cannot be chosen here is not drawn here.
function modesText({ parameters: { resolution, normals, precision } }) {
  const text = resolution ? `, resolution ${resolution}` : '';
  const odd = [...(resolution && resolution !== 'half' ? ['resolution'] : []), ...(normals ? [`normals ${normals}`] : []),
    ...(precision ? [`precision ${precision}`] : [])];
  return odd.length > 0 ? `${text} (not drawn here: ${odd.join(', ')})` : text;
}

// What a live setting gives: numbers beside the measured ones, pictures, and the setting's names elsewhere.
class LiveResult {
  // `run` is {seed, methodsDir}, of the run that made the page.
  constructor(element, run) {
    this.element = element;
    this.run = run;
    this.previewNote = '';
    this.shown = this.find('[name=shown]');
    fillCaption(this.find('.live-error-caption'), {
      title: 'Signed error', text: 'Live result minus truth. Red is too bright: occlusion is missing. Blue is too dark.',
      bars: [{ map: 'blueRed', unit: 'output − truth', ticks: [`${signedText(-liveErrorRange, 1)} too dark`, '0',
        `${signedText(liveErrorRange, 1)} too bright`] }],
      keys: [{ colour: signColours.invalid, text: 'not compared' }],
    });
    this.shown.addEventListener('change', () => this.paintVisibility());
    this.find('.live-pictures').addEventListener('pointermove', (event) => this.probe(event));
    for (const button of element.querySelectorAll('[data-does=copy]')) {
      const field = document.getElementById(button.dataset.of);
      button.addEventListener('click', () => copyText(field.value, button, field));
    }
    this.find('[data-does=download]').addEventListener('click', () => {
      downloadText(`${element.shown.method.id}-live.json`, `${this.find('#live-preset-text').value}\n`);
    });
  }

  find(selector) {
    return this.element.querySelector(selector);
  }

  setBusy(busy) {
    for (const place of ['.live-results', '.live-status']) this.find(place).setAttribute('aria-busy', String(busy));
  }

  // What is going on, for those who wait.
  say(text) {
    this.find('.live-status').textContent = `${this.previewNote}${text}`;
  }

  // A picture of fewer pixels, without numbers, until the full one is there.
  preview(view, output) {
    this.element.preview = { ...view, output };  // for scripts that drive the page
    this.previewNote = `This is a preview of ${view.width}×${view.height} pixels. `;
    this.say('The full picture follows …');
    if (this.shown.value === 'live') paintVisibility(this.find('.live-output'), view, (i) => output[i]);
  }

  // Forgets what an earlier view showed.
  setView(stageView) {
    const { width, height } = stageView;
    Object.assign(this, { stageView, truth: null, noise: null, output: null, previewNote: '' });
    Object.assign(this.find('.live-error'), { width, height });
    this.find('.live-errors tbody').replaceChildren();
  }

  // Both are imageValues().
  setTruth(truth, noise) {
    Object.assign(this, { truth, noise });
  }

  // What the run measured where the setting started from; undefined where it measured nothing.
  setCell(cell) {
    this.cell = cell;
  }

  show(setting, output, elapsed_ms) {
    const { view } = setting;
    const { stageView } = this;
    const errors = liveErrors(output, this.truth, this.noise, view.noise_floor_rmse);
    this.output = output;
    this.previewNote = '';
    this.element.shown = { ...setting, output, errors };  // for scripts that drive the page
    this.showErrors(errors);
    const odd = errors.nonfinite > 0 ? ` ${errors.nonfinite} pixels are NaN or infinite and left out.` : '';
    this.say(`RMSE ${numberText(errors.rmse, 4)} over ${errors.count} valid pixels `
      + `(the page keeps the truth in steps of 1/${Math.round(1 / stageView.images.truth.step)}), `
      + `drawn and read back in ${elapsed_ms.toFixed(0)} ms here.${odd}`);
    this.paintVisibility();
    paintError(this.find('.live-error'), view, output, this.truth, this.noise, liveErrorRange);
    this.find('#live-preset-text').value = presetText(setting);
    this.find('#live-command-text').value = commandText(setting, this.run);
    this.find('.live-filter-note').hidden = !losesFilterValues(setting);
  }

  showErrors(errors) {
    const rows = [['Live', errors]];
    if (this.cell) rows.push([`As measured, ${this.cell.preset}, filter ${this.cell.filter}${modesText(this.cell)}`, this.cell]);
    const largest = {};
    for (const id of ['rmse', 'rmse_debiased', 'bias']) largest[id] = Math.max(...rows.map(([, row]) => Math.abs(row[id] ?? 0)));
    this.find('.live-errors tbody').replaceChildren(...rows.map(([name, row]) => {
      const head = make('th', 'text', name);
      head.scope = 'row';
      return make('tr', '', head, ...errorCells(row, largest));
    }));
  }

  async paintVisibility() {
    const { stageView, truth, output } = this;
    const stored = stageView.cells.find(({ id }) => id === this.cell?.id)?.images?.output;
    this.find('[value=stored]').disabled = !stored;
    if (!stored && this.shown.value === 'stored') this.shown.value = 'live';
    if (!output) return;
    const { at } = { live: { at: (i) => output[i] }, truth }[this.shown.value] ?? await imageValues(stored);
    if (this.output === output) paintVisibility(this.find('.live-output'), stageView, at);
  }

  probe({ target, clientX, clientY }) {
    if (!(target instanceof HTMLCanvasElement) || !this.output) return;
    const { width, height } = this.stageView;
    const box = target.getBoundingClientRect();
    const placeIn = (part, size) => Math.min(Math.max(Math.floor(part * size), 0), size - 1);
    const x = placeIn((clientX - box.left) / box.width, width);
    const y = placeIn((clientY - box.top) / box.height, height);
    const i = x + y * width;
    const truth = this.truth.at(i);
    const error = Number.isNaN(this.noise.at(i)) ? 'not compared' : `error ${signedText(this.output[i] - truth, 4)}`;
    this.find('.live-probe').textContent =
      `Pixel ${x}, ${y}: live ${numberText(this.output[i], 4)}, truth ${numberText(truth, 4)}, ${error}`;
  }
}
