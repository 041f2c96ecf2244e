// One picture of the stage: a canvas with its title, sentence, colour bars and keys. Pixels are shown as they are, without
// smoothing, from one to one on, and carry their numbers once these fit.
const pixelWithNumber_px = 38;

class Pane {
  constructor(template, stage) {
    this.stage = stage;
    this.element = template.content.firstElementChild.cloneNode(true);
    this.canvas = this.element.querySelector('canvas');
    this.caption = this.element.querySelector('figcaption');
    this.showing = 0;
    this.base = null;
    this.top = null;
  }

  // `top`, where there is one, lies over the base as the mode says. A brief caption leaves out what others say already.
  async show(base, top, brief = false) {
    const turn = ++this.showing;
    this.element.dataset.layer = base.key;
    this.canvas.setAttribute('aria-label', top ? `${base.title}, with ${top.title} over it` : base.title);
    this.canvas.style.aspectRatio = `${base.width} / ${base.height}`;
    fillCaption(this.caption, base, top, brief);
    this.element.setAttribute('aria-busy', 'true');
    const painted = await Promise.all([paintedLayer(base), top && paintedLayer(top)]);
    if (turn !== this.showing) return;
    [this.base, this.top] = painted;
    this.image = base;
    this.element.setAttribute('aria-busy', 'false');
    this.stage.requestDraw();
  }

  // The image's pixel under a point of the window; null outside.
  pixelAt(clientX, clientY) {
    if (!this.image) return null;
    const box = this.canvas.getBoundingClientRect();
    const { scale, left, top } = this.stage.viewport.placeIn(box.width, box.height, this.image);
    const x = Math.floor((clientX - box.left - left) / scale);
    const y = Math.floor((clientY - box.top - top) / scale);
    return x >= 0 && y >= 0 && x < this.image.width && y < this.image.height ? { x, y } : null;
  }

  draw() {
    if (!this.base) return;
    const w = this.canvas.clientWidth;
    const h = this.canvas.clientHeight;
    if (w === 0) return;
    const ratio = window.devicePixelRatio;
    if (this.canvas.width !== Math.round(w * ratio)) this.canvas.width = Math.round(w * ratio);
    if (this.canvas.height !== Math.round(h * ratio)) this.canvas.height = Math.round(h * ratio);
    const context = this.canvas.getContext('2d');
    const place = this.stage.viewport.placeIn(w, h, this.image);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, w, h);
    context.imageSmoothingEnabled = place.scale * ratio < 1;
    context.imageSmoothingQuality = 'high';
    drawComparison(context, this, place, w, h);
    const { pixel } = this.stage;
    if (pixel && place.scale >= 3) markPixel(context, pixel, place);
  }
}

function visiblePart(image, place, w, h) {
  const x0 = Math.max(0, Math.floor(-place.left / place.scale));
  const y0 = Math.max(0, Math.floor(-place.top / place.scale));
  const x1 = Math.min(image.width, Math.ceil((w - place.left) / place.scale));
  const y1 = Math.min(image.height, Math.ceil((h - place.top) / place.scale));
  return { x0, y0, x1, y1 };
}

function drawPainted(context, painted, image, place, w, h) {
  const { x0, y0, x1, y1 } = visiblePart(image, place, w, h);
  context.drawImage(painted.canvas, x0, y0, x1 - x0, y1 - y0, place.left + x0 * place.scale,
    place.top + y0 * place.scale, (x1 - x0) * place.scale, (y1 - y0) * place.scale);
  if (place.scale >= pixelWithNumber_px) writeNumbers(context, painted, image, place, w, h);
}

// Without the leading zero, in white with a dark rim: legible on every colour.
function writeNumbers(context, painted, image, place, w, h) {
  const { x0, y0, x1, y1 } = visiblePart(image, place, w, h);
  const decimals = place.scale >= 1.6 * pixelWithNumber_px ? Math.min(4, painted.decimals) : 2;
  context.font = `${Math.min(16, place.scale / 3.2)}px ${getComputedStyle(document.body).fontFamily}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.lineWidth = 3;
  context.strokeStyle = '#000c';
  context.fillStyle = '#fff';
  for (let y = y0; y < y1; y += 1) {
    for (let x = x0; x < x1; x += 1) {
      const value = painted.value(x + y * image.width);
      const text = (painted.signed ? signedText : numberText)(value, decimals).replace(/^([+−]?)0\./, '$1.');
      const at = [place.left + (x + 0.5) * place.scale, place.top + (y + 0.5) * place.scale];
      context.strokeText(text, ...at);
      context.fillText(text, ...at);
    }
  }
}

function markPixel(context, pixel, place) {
  const box = [place.left + pixel.x * place.scale, place.top + pixel.y * place.scale, place.scale, place.scale];
  context.lineWidth = 3;
  context.strokeStyle = '#000';
  context.strokeRect(...box);
  context.lineWidth = 1;
  context.strokeStyle = '#fff';
  context.strokeRect(...box);
}

function colourBar({ map, ticks, unit }) {
  const gradient = make('span', 'gradient');
  gradient.style.background = cssGradient(map);
  return make('span', 'bar', gradient, make('span', 'ticks', ...ticks.map((tick) => make('span', '', tick.trim()))),
    make('span', 'quiet', unit));
}

function fillCaption(caption, base, top, brief) {
  const keys = base.keys.map(({ colour, text }) => {
    const swatch = make('span', 'swatch');
    swatch.style.background = cssColour(colour);
    return make('span', 'key', swatch, text);
  });
  const title = make('strong', '', base.title);
  caption.replaceChildren(...(top ? [make('strong', '', top.title), ' over ', title] : [title]));
  if (!brief) caption.append(' ', make('span', 'sentence', base.text), ...base.bars.map(colourBar));
  caption.append(make('span', 'keys', ...(brief ? [] : keys)));
}
