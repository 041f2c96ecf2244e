// A caption with a colour bar needs so much room beside its picture.
const leastCaption_px = 230;

// The picture stage: its form holds what is chosen, its panes show it.
class Stage {
  constructor(element) {
    this.element = element;
    this.form = element.querySelector('.choosers');
    this.panesBox = element.querySelector('.panes');
    this.paneTemplate = element.querySelector('template.pane-template');
    this.status = element.querySelector('.stage-status');
    this.panes = [];
    this.pixel = null;
    this.pinned = null;  // the pixel that was asked for by a click, a key or an address
    this.held = false;
    this.blink = new Blink(this);
    this.viewport = new Viewport(() => this.requestDraw());
    this.inspector = new Inspector(element.querySelector('.inspector'));
    this.listeners = [];
  }

  radios(name) {
    return [...this.form.querySelectorAll('input[type=radio]')].filter((input) => input.name === name);
  }

  chosen(name) {
    return this.radios(name).find((input) => input.checked)?.value ?? '';
  }

  // Checks the radio of that value, if there is one that can be chosen.
  choose(name, value) {
    const input = this.radios(name).find((other) => other.value === value && !other.disabled);
    if (input) input.checked = true;
    return Boolean(input);
  }

  // The neighbour of what is checked, around the ends, leaving out what cannot be chosen.
  step(name, direction) {
    const open = this.radios(name).filter((input) => !input.disabled && !input.closest('label').hidden);
    const at = open.findIndex((input) => input.checked);
    if (open.length > 0) open[(at + direction + open.length) % open.length].checked = true;
    this.update();
  }

  get view() {
    return stageData.views.find((view) => view.key === this.chosen('view'));
  }

  get cell() {
    return this.view.cells.find((cell) => cell.id === this.chosen(`cell-${this.view.key}`)) ?? null;
  }

  get choice() {
    const { elements } = this.form;
    return {
      view: this.view.key,
      cell: this.cell?.id ?? '',
      picture: this.chosen('picture'),
      mode: this.chosen('mode'),
      against: elements.against.value,
      cut: Number(elements.cut.value),
      mix: Number(elements.mix.value),
      rate: Number(elements.rate.value),
      range: Number(elements.range.value),
      gray: elements.gray.checked,
    };
  }

  // What each pane shows, as [base, top] or [base].
  layers() {
    const { view, cell } = this;
    const choice = this.choice;
    const truth = layerOf('truth', view, null, choice);
    if (!cell) return [[truth]];
    const other = view.cells.find(({ id }) => id === choice.against);
    const chosen = layerOf(choice.picture, view, cell, choice);
    const compared = ['output', 'raw'].includes(choice.picture) ? choice.picture : 'output';
    const against = other ? layerOf(choice.picture, view, other, choice) : truth;
    const test = compared === 'raw' ? cell.images.raw ?? cell.images.output : cell.images.output;
    const difference = other || compared === 'raw'
      ? differenceLayer({ key: `difference ${compared} ${cell.id} ${choice.against}`,
        title: `${cell.name}${compared === 'raw' ? ', raw' : ''} minus ${other ? other.name : 'truth'}`,
        text: 'Red is brighter than what is held against it, blue is darker.', view, test,
        base: other ? other.images.output : view.images.truth, unit: 'difference', options: choice })
      : layerOf('error', view, cell, choice);
    const everyMethod = view.cells.filter(({ images }) => images)
      .map((every) => layerOf(choice.picture, view, every, choice));
    const panes = modes[choice.mode].panes({ chosen, against, difference, truth, everyMethod });
    return this.held ? panes.map(() => [truth]) : panes;
  }

  // Shows what the form says. Called after every change of it.
  update() {
    const choice = this.choice;
    this.showControls(choice);
    const layers = this.layers();
    while (this.panes.length > layers.length) this.panes.pop().element.remove();
    while (this.panes.length < layers.length) {
      const pane = new Pane(this.paneTemplate, this);
      this.panes.push(pane);
      this.panesBox.append(pane.element);
    }
    this.panesBox.dataset.panes = String(layers.length);
    this.arrange();
    layers.forEach(([base, top], i) => this.panes[i].show(base, top, i > 1));
    this.blink.set(choice.mode === 'blink' && !this.held ? 1000 / choice.rate : 0);
    this.inspector.show(this.view, this.pixel);
    for (const listener of this.listeners) listener(choice);
    this.said();
  }

  // Two pictures stand one above the other, with their captions beside them, where that makes them larger.
  arrange() {
    const box = this.panesBox;
    const { width, height } = this.view;
    const gap_px = 14;
    const beside_px = (box.clientWidth - gap_px) / 2;
    const free_px = innerHeight - this.element.querySelector('.stage-tools').offsetHeight - 7 * gap_px;
    const above_px = Math.floor(Math.min(free_px / 2 * width / height, box.clientWidth - leastCaption_px));
    const above = this.panes.length === 2 && above_px > 1.1 * beside_px;
    box.classList.toggle('one-above-the-other', above);
    box.style.setProperty('--pane-width', `${above_px}px`);
    this.requestDraw();
  }

  // Hides what the chosen mode and view have no use for.
  showControls(choice) {
    for (const set of this.form.querySelectorAll('.methods')) set.hidden = set.dataset.view !== choice.view;
    for (const control of this.form.querySelectorAll('[data-modes]')) {
      control.hidden = !control.dataset.modes.split(' ').includes(choice.mode);
    }
    const absent = { raw: !this.view.cells.some(({ images }) => images?.raw), depth: !this.view.images.depth,
      noise: !this.view.noiseHigh, causes: !hasCauses(this.view) };
    for (const input of this.radios('picture')) input.closest('label').hidden = Boolean(absent[input.value]);
    if (absent[choice.picture]) this.choose('picture', 'output');
    const { against } = this.form.elements;
    if (against.dataset.view !== choice.view) this.fillAgainst(against, choice.view);
  }

  fillAgainst(select, view) {
    select.dataset.view = view;
    const options = this.view.cells.filter(({ images }) => images).map(({ id, name }) => new Option(name, id));
    select.replaceChildren(new Option('the truth', ''), ...options);
  }

  // One line for those who do not see the pictures.
  said() {
    const { mode } = this.choice;
    const titles = this.layers().flat().map(({ title }) => title);
    this.status.textContent = mode === 'blink' && titles.length === 2
      ? titles[this.blink.showsTop ? 1 : 0] : titles.join('; ');
  }

  hold(on) {
    if (this.held === on) return;
    this.held = on;
    this.update();
  }

  inspect(pixel) {
    this.pixel = pixel;
    this.inspector.show(this.view, pixel);
    this.requestDraw();
  }

  pin(pixel) {
    this.pinned = pixel;
    this.inspect(pixel);
    for (const listener of this.listeners) listener(this.choice);
  }

  // The size that all panes have, and the image in them.
  get frame() {
    const { canvas } = this.panes[0];
    return [canvas.clientWidth, canvas.clientHeight, this.view];
  }

  zoomBy(factor, px, py) {
    const [w, h, image] = this.frame;
    this.viewport.zoomAt(factor, px ?? w / 2, py ?? h / 2, w, h, image);
  }

  // One pixel of the image for one of the screen.
  zoomToPixels() {
    const [w, h, image] = this.frame;
    const { scale } = this.viewport.placeIn(w, h, image);
    this.zoomBy(1 / window.devicePixelRatio / scale);
  }

  // Pixels of the screen along one of the image.
  zoomText() {
    const { scale } = this.viewport.placeIn(...this.frame);
    return `${this.viewport.zoom === 1 ? 'fits: ' : ''}${numberText(scale * window.devicePixelRatio, 2)}×`;
  }

  requestDraw() {
    if (this.drawing || this.panes.length === 0) return;
    this.drawing = requestAnimationFrame(() => {
      this.drawing = 0;
      for (const pane of this.panes) pane.draw();
      this.element.querySelector('.zoom-text').textContent = this.zoomText();
      for (const listener of this.listeners) listener(this.choice);
    });
  }
}
