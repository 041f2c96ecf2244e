// A full picture that takes longer is drawn behind a preview, and in strips that take about so long. Before the first one is
// drawn, a strip has so many pixels.
const longestWait_ms = 400;
const stripTime_ms = 200;
const stripSize_px = 2 ** 17;
const mostStrips = 32;

// One view, one method with its parameters, one filter with its own: drawn anew after every change.
class LiveBench {
  constructor(element, index) {
    this.index = index;
    this.form = element.querySelector('.live-controls');
    this.failure = element.querySelector('.live-failure');
    this.runner = new LiveRunner(index.contract);
    this.previewRunner = new LiveRunner(index.contract, this.runner.live);
    this.elapsed_ms = null;  // what the latest full picture of the view took
    this.isPreviewed = false;  // the preview of the present setting is shown, or being drawn
    this.result = new LiveResult(element, { seed: index.contract.seed, methodsDir: index.methods_dir });
    this.setting = { border: 'far', resolution: 'full' };
    this.turn = 0;
    this.changed = false;
    this.drawing = false;
    this.loading = null;  // the key of the view that is being unpacked
    this.unpacking = false;  // surfaces of the view, for methods over depth layers
    this.runner.live.canvas.addEventListener('webglcontextlost', () => {
      this.showFailure('The graphics driver gave up, perhaps for too many samples. Load the page again to go on.');
    });
    this.fill('view', stageData.views.map(({ key }) => [key, key]));
    this.methods = index.methods;
    this.filters = index.filters;
    this.fill('method', index.methods.map(({ id, label }) => [id, label]));
    this.fill('filter', index.filters.map(({ id, label }) => [id, label]));
    this.listen();
    acceptPresetFiles(element, this);
  }

  fill(name, entries) {
    this.form.elements[name].replaceChildren(...entries.map(([value, text]) => new Option(text, value)));
  }

  listen() {
    const { elements } = this.form;
    const does = {
      view: () => this.chooseView(elements.view.value).catch((error) => this.showFailure(error.message)),
      method: () => this.chooseMethod(elements.method.value),
      preset: () => this.choosePreset(elements.preset.value),
      filter: () => this.chooseFilter(elements.filter.value),
      filtered: () => this.chooseFilter(elements.filtered.checked ? elements.filter.value : 'none'),
      border: () => this.chooseMode('border', elements.border.value),
      resolution: () => this.chooseMode('resolution', elements.resolution.value),
    };
    for (const [name, act] of Object.entries(does)) elements[name].addEventListener('change', act);
    this.form.querySelector('[data-does=reset]').addEventListener('click', () => this.choosePreset(elements.preset.value));
    this.form.addEventListener('submit', (event) => event.preventDefault());
  }

  showFailure(text) {
    this.failure.textContent = text;
    this.failure.hidden = text === '';
  }

  // The method and its values stay as they are; what its presets would be is the new view's. Its preview is drawn while the
  // rest is unpacked.
  async chooseView(key) {
    const turn = this.turn += 1;
    const view = this.index.views[key];
    const stageView = stageData.views.find((other) => other.key === key);
    const say = (text) => this.sayMeanwhile(text);
    this.loading = key;
    this.result.setBusy(true);
    const preview = previewView(view);
    const few = await unpackedInputs(preview, say);
    if (turn !== this.turn) return;
    this.result.setView(stageView);
    this.result.say('Compiling the shaders …');
    this.previewRunner.setView(preview, few);
    this.takeView(view);
    const { truth, noise } = stageView.images;
    const [inputs, ...images] = await Promise.all([unpackedInputs(view, say), imageValues(truth), imageValues(noise)]);
    if (turn !== this.turn) return;
    this.loading = null;
    this.result.setTruth(...images);
    this.runner.setView(view, inputs);
    this.elapsed_ms = null;
    this.request(false);
  }

  // Of work that goes on beside the drawing, which has more to say.
  sayMeanwhile(text) {
    if (!this.drawing) this.result.say(text);
  }

  // Most methods read no surfaces behind one another: they are unpacked when one is chosen that does, and previews are drawn
  // meanwhile.
  async unpackSurfaces() {
    if (this.unpacking) return;
    this.unpacking = true;
    try {
      await this.runner.layers.unpack((text) => this.sayMeanwhile(text));
      this.unpacking = false;
      this.request(false);
    } catch (error) {
      this.unpacking = false;
      this.showFailure(error.message);
    }
  }

  isWaiting() {
    return this.loading !== null || (this.unpacking && !this.runner.holdsInputsOf(this.setting.method));
  }

  takeView(view) {
    this.setting.view = view;
    this.methods = drawnDescriptors(this.index.methods, view.method_lengths);
    this.filters = drawnDescriptors(this.index.filters, view.filter_lengths);
    if (this.setting.method) {
      this.setting.method = this.methods.find(({ id }) => id === this.setting.method.id);
      this.setting.filter = this.filters.find(({ id }) => id === this.setting.filter?.id) ?? null;
      this.listPresets();
      this.request();
    } else {
      this.chooseMethod(view.cells[0]?.method);
    }
  }

  chooseMethod(id) {
    this.setting.method = this.methods.find((other) => other.id === id) ?? this.methods[0];
    this.form.elements.method.value = this.setting.method.id;
    this.form.querySelector('.live-summary').textContent = this.setting.method.summary;
    this.form.elements.preset.replaceChildren();
    this.listPresets();
    this.choosePreset(this.form.elements.preset.value);
  }

  // What the run measured in this view comes first.
  listPresets() {
    const chooser = this.form.elements.preset;
    const kept = chooser.value;
    const presets = Object.keys(this.setting.method.presets);
    const group = (label, names) => {
      const element = make('optgroup', '', ...names.map((name) => new Option(name, name)));
      element.label = label;
      return names.length > 0 ? [element] : [];
    };
    chooser.replaceChildren(...group('measured by the run', presets.filter((name) => this.measured(name))),
      ...group('presets', presets.filter((name) => !this.measured(name))));
    if (kept) chooser.value = kept;
    this.result.setCell(this.measured(chooser.value));
  }

  measured(preset) {
    return this.setting.view.cells.find((cell) => cell.method === this.setting.method.id && cell.preset === preset);
  }

  choosePreset(preset) {
    const { method } = this.setting;
    const cell = this.measured(preset);
    this.result.setCell(cell);
    this.setting.parameters = Object.fromEntries(
      method.parameters.map(({ id }) => [id, cell?.parameters[id] ?? method.presets[preset][id]]));
    this.chooseMode('border', cell?.parameters.border ?? 'far');
    this.chooseMode('resolution', cell?.parameters.resolution === 'half' ? 'half' : 'full');
    fillParameters(this.form.querySelector('.live-method-parameters'), method, this.setting.parameters, () => this.request());
    const own = method.preset_filters[preset] ?? { filter: 'none', preset: 'default' };
    this.chooseFilter(cell?.filter ?? own.filter, cell?.parameters, own.preset);
  }

  chooseMode(name, choice) {
    this.setting[name] = choice;
    this.form.elements[name].value = choice;
    this.request();
  }

  // `measured` may hold parameters of the filter, as cells name them; `preset` is the filter's own.
  chooseFilter(id, measured = {}, preset = 'default') {
    const filter = this.filters.find((other) => other.id === id) ?? null;
    this.setting.filter = filter;
    const usual = filterOfPreset(filter, this.setting.method, this.form.elements.preset.value)?.presets[preset];
    this.setting.filterParameters = Object.fromEntries(
      Object.entries(usual ?? {}).map(([name, value]) => [name, measured[`filter.${name}`] ?? value]));
    const { filtered, filter: chooser } = this.form.elements;
    filtered.checked = filter !== null;
    if (filter) chooser.value = id;
    fillParameters(this.form.querySelector('.live-filter-parameters'), filter ?? { parameters: [], presets: {} },
      this.setting.filterParameters, () => this.request());
    this.request();
  }

  // However many changes come while a picture is drawn, the next one has them all.
  async request(newSetting = true) {
    this.changed = true;
    if (newSetting) this.isPreviewed = false;
    if (this.drawing) return;
    this.drawing = true;
    this.result.setBusy(true);
    while (this.changed) {
      await new Promise((resolve) => { requestAnimationFrame(resolve); });
      this.changed = false;
      try {
        await this.draw();
      } catch (error) {
        this.showFailure(error.message);
      }
    }
    this.drawing = false;
    this.result.setBusy(this.isWaiting());
  }

  // The preview comes first where the full picture takes long or cannot be drawn yet.
  async draw() {
    const { parameters, filterParameters } = this.setting;
    const setting = { ...this.setting, parameters: { ...parameters }, filterParameters: { ...filterParameters } };
    const { method } = setting;
    const cannotYet = this.loading !== null || !this.runner.holdsInputsOf(method);
    const takesLong = (this.elapsed_ms ?? Infinity) > longestWait_ms;
    if (!this.isPreviewed && (cannotYet || takesLong)) {
      this.isPreviewed = true;
      const { view } = this.previewRunner;
      if (method.depth_layers) await this.previewRunner.layers.unpack(() => {});
      const preview = await this.previewRunner.run(setting);
      if (!preview || setting.view !== this.setting.view) return;
      this.showFailure('');
      this.result.preview(view, preview);
      await new Promise((resolve) => { requestAnimationFrame(() => setTimeout(resolve)); });
    }
    if (this.changed || this.loading) return;
    if (this.runner.holdsInputsOf(method)) await this.drawFull(setting);
    else this.unpackSurfaces();
  }

  // A change on the way stops it: the next setting is drawn at once.
  async drawFull(setting) {
    const start = performance.now();
    const { width, height } = setting.view;
    const wanted = this.elapsed_ms === null ? width * height / stripSize_px : this.elapsed_ms / stripTime_ms;
    const strips = Math.min(Math.max(Math.ceil(wanted), 1), mostStrips);
    const goOn = (text) => {
      this.result.say(`Drawing ${width}×${height} pixels: ${text} …`);
      return !this.changed && !this.loading;
    };
    const output = await this.runner.run(setting, { strips, goOn });
    if (!output || setting.view !== this.setting.view) return;
    this.showFailure('');
    this.elapsed_ms = performance.now() - start;
    this.result.show(setting, output, this.elapsed_ms);
  }
}
