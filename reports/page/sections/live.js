const details = document.querySelector('details.live');
const errorRange = 0.5;

// One view, one method with its parameters, one filter with its own: drawn anew after every change.
class LiveBench {
  constructor(index) {
    this.index = index;
    this.form = details.querySelector('.live-controls');
    this.runner = new LiveRunner(index.contract);
    this.setting = { border: 'far' };
    this.changed = false;
    this.drawing = false;
    this.runner.live.canvas.addEventListener('webglcontextlost', () => {
      showFailure('The graphics driver gave up, perhaps for too many samples. Load the page again to go on.');
    });
    fillCaption(details.querySelector('.live-error-caption'), {
      title: 'Signed error', text: 'Live result minus truth. Red is too bright: occlusion is missing. Blue is too dark.',
      bars: [{ map: 'blueRed', unit: 'output − truth', ticks: [`${signedText(-errorRange, 1)} too dark`, '0',
        `${signedText(errorRange, 1)} too bright`] }],
      keys: [{ colour: signColours.invalid, text: 'not compared' }],
    });
    this.fill('view', stageData.views.map(({ key }) => [key, key]));
    this.fill('method', index.methods.map(({ id, label }) => [id, label]));
    this.fill('filter', index.filters.map(({ id, label }) => [id, label]));
    this.listen();
  }

  fill(name, entries) {
    this.form.elements[name].replaceChildren(...entries.map(([value, text]) => new Option(text, value)));
  }

  listen() {
    const { elements } = this.form;
    const does = {
      view: () => this.chooseView(elements.view.value), method: () => this.chooseMethod(elements.method.value),
      preset: () => this.choosePreset(elements.preset.value), filter: () => this.chooseFilter(elements.filter.value),
      blur: () => this.chooseFilter(elements.blur.checked ? elements.filter.value : 'none'),
      border: () => {
        this.setting.border = elements.border.value;
        this.request();
      },
    };
    for (const [name, act] of Object.entries(does)) elements[name].addEventListener('change', act);
    this.form.addEventListener('submit', (event) => event.preventDefault());
    details.querySelector('[name=shown]').addEventListener('change', () => this.paintShown());
    details.addEventListener('click', ({ target }) => {
      const { does: what, of } = target.dataset ?? {};
      if (what === 'reset') this.choosePreset(elements.preset.value);
      if (what === 'copy') copyText(document.getElementById(of), target);
      if (what === 'download') downloadText(`${this.setting.method.id}-live.json`, `${presetText(this.setting)}\n`);
    });
    details.querySelector('.live-pictures').addEventListener('pointermove', (event) => this.probe(event));
  }

  async chooseView(key) {
    const view = this.index.views[key];
    details.querySelector('.live-results').setAttribute('aria-busy', 'true');
    this.stageView = stageData.views.find((other) => other.key === key);
    const { truth, noise } = this.stageView.images;
    const [inputs, ...images] = await Promise.all([unpackedInputs(view), imageValues(truth), imageValues(noise)]);
    [this.truth, this.noise] = images;
    this.runner.setView(view, inputs);
    this.setting.view = view;
    this.output = null;
    this.chooseMethod(this.setting.method?.id ?? view.cells[0]?.method ?? this.index.methods[0].id);
  }

  chooseMethod(id) {
    const method = this.index.methods.find((other) => other.id === id) ?? this.index.methods[0];
    this.setting.method = method;
    this.form.elements.method.value = method.id;
    this.form.querySelector('.live-summary').textContent = method.summary;
    const measured = (preset) => this.measured(preset) !== undefined;
    const presets = Object.keys(method.presets).sort((a, b) => measured(b) - measured(a));
    this.fill('preset', presets.map((preset) => [preset, measured(preset) ? `${preset}, measured` : preset]));
    this.choosePreset(presets[0]);
  }

  measured(preset) {
    return this.setting.view.cells.find((cell) => cell.method === this.setting.method.id && cell.preset === preset);
  }

  choosePreset(preset) {
    const { method } = this.setting;
    this.cell = this.measured(preset);
    const stored = this.cell?.parameters ?? {};
    this.setting.parameters = Object.fromEntries(
      method.parameters.map(({ id }) => [id, stored[id] ?? method.presets[preset][id]]));
    this.setting.border = stored.border ?? 'far';
    this.form.elements.border.value = this.setting.border;
    fillParameters(this.form.querySelector('.live-method-parameters'), method, this.setting.parameters, () => this.request());
    this.chooseFilter(this.cell?.filter ?? method.preset_filters[preset] ?? 'none');
  }

  chooseFilter(id) {
    const filter = this.index.filters.find((other) => other.id === id) ?? null;
    this.setting.filter = filter;
    this.setting.filterParameters = { ...filter?.presets.default };
    const { blur, filter: chooser } = this.form.elements;
    blur.checked = filter !== null;
    if (filter) chooser.value = id;
    fillParameters(this.form.querySelector('.live-filter-parameters'), filter ?? { parameters: [], presets: {} },
      this.setting.filterParameters, () => this.request());
    this.request();
  }

  // However many changes come while a picture is drawn, the next one has them all.
  async request() {
    this.changed = true;
    if (this.drawing) return;
    this.drawing = true;
    const results = details.querySelector('.live-results');
    results.setAttribute('aria-busy', 'true');
    try {
      while (this.changed) {
        await new Promise((resolve) => { requestAnimationFrame(resolve); });
        this.changed = false;
        await this.draw();
      }
    } catch (error) {
      showFailure(error.message);
    }
    this.drawing = false;
    results.setAttribute('aria-busy', 'false');
  }

  async draw() {
    const setting = { ...this.setting, parameters: { ...this.setting.parameters }, filterParameters: { ...this.setting.filterParameters } };
    const start = performance.now();
    const output = await this.runner.run(setting);
    if (setting.view !== this.setting.view) return;
    this.output = output;
    this.show(setting, performance.now() - start);
  }

  show(setting, elapsed_ms) {
    const { view, filter, filterParameters } = setting;
    const errors = liveErrors(this.output, this.truth, this.noise, view.noise_floor_rmse);
    this.showErrors(errors);
    const odd = errors.nonfinite > 0 ? ` ${errors.nonfinite} pixels are NaN or infinite and left out.` : '';
    details.querySelector('.live-status').textContent = `RMSE ${numberText(errors.rmse, 4)} over ${errors.count} valid pixels, `
      + `drawn and read back in ${elapsed_ms.toFixed(0)} ms here.${odd}`;
    this.paintShown();
    paintError(details.querySelector('.live-error'), view, this.output, this.truth, this.noise, errorRange);
    document.getElementById('live-preset-text').value = presetText(setting);
    document.getElementById('live-command-text').value = commandText(setting, this.index.contract.seed);
    details.querySelector('.live-filter-note').hidden = !filter || Object.keys(changedValues(filter, filterParameters)).length === 0;
    details.shown = { ...setting, output: this.output, errors };  // for scripts that drive the page
  }

  showErrors(errors) {
    const rows = [['Live', errors]];
    if (this.cell) rows.push([`As measured, ${this.cell.preset}, filter ${this.cell.filter}`, this.cell]);
    const largest = {};
    for (const id of ['rmse', 'rmse_debiased', 'bias']) largest[id] = Math.max(...rows.map(([, row]) => Math.abs(row[id] ?? 0)));
    details.querySelector('.live-errors tbody').replaceChildren(...rows.map(([name, row]) => {
      const head = make('th', 'text', name);
      head.scope = 'row';
      return make('tr', '', head, ...errorCells(row, largest));
    }));
  }

  async paintShown() {
    const chooser = details.querySelector('[name=shown]');
    const stored = this.stageView.cells.find(({ id }) => id === this.cell?.id)?.images?.output;
    chooser.querySelector('[value=stored]').disabled = !stored;
    if (!stored && chooser.value === 'stored') chooser.value = 'live';
    const sources = { live: () => ({ at: (i) => this.output[i] }), truth: () => this.truth, stored: () => imageValues(stored) };
    if (!this.output) return;
    const { at } = await sources[chooser.value]();
    paintVisibility(details.querySelector('.live-output'), this.setting.view, at);
  }

  probe({ target, clientX, clientY }) {
    if (!(target instanceof HTMLCanvasElement) || !this.output) return;
    const { width, height } = this.setting.view;
    const box = target.getBoundingClientRect();
    const x = Math.min(Math.max(Math.floor((clientX - box.left) / box.width * width), 0), width - 1);
    const y = Math.min(Math.max(Math.floor((clientY - box.top) / box.height * height), 0), height - 1);
    const i = x + y * width;
    const truth = this.truth.at(i);
    const error = Number.isNaN(this.noise.at(i)) ? 'not compared' : `error ${signedText(this.output[i] - truth, 4)}`;
    details.querySelector('.live-probe').textContent =
      `Pixel ${x}, ${y}: live ${numberText(this.output[i], 4)}, truth ${numberText(truth, 4)}, ${error}`;
  }
}

function showFailure(text) {
  const failure = details.querySelector('.live-failure');
  failure.textContent = text;
  failure.hidden = false;
}

// Nothing is unpacked or compiled before the section is opened.
details?.addEventListener('toggle', async () => {
  try {
    const index = JSON.parse(new TextDecoder().decode(await inflatedBytes('live index')));
    const bench = new LiveBench(index);
    await bench.chooseView(stageData.views[0].key);
    details.querySelector('.live-bench').hidden = false;
  } catch (error) {
    showFailure(error.message);
  }
}, { once: true });
