// What a picture can show. A layer has a key of its own, a title, a sentence, colour bars and keys to its colours, and
// load(): a promise of { value(i), decimals, signed, paint(pixels) } that colours 32-bit pixels.
const errorSteps = 511;

function scalarLayer({ key, title, text, image, map, low, high, unit, ends = ['', ''], decimals = 2 }) {
  const middle = (low + high) / 2;
  return {
    key: `${key} ${map}`, title, text, width: image.width, height: image.height,
    bars: [{ map, unit, ticks: [`${numberText(low, decimals)} ${ends[0]}`, numberText(middle, decimals),
      `${numberText(high, decimals)} ${ends[1]}`] }],
    keys: [],
    async load() {
      const { codes, values, none, at } = await imageValues(image);
      const colours = Uint32Array.from(values, (value, code) => pixelOf(code === none
        ? signColours[unit === 'visibility' ? 'nonfinite' : 'invalid']
        : colourAt(map, (value - low) / (high - low || 1))));
      return {
        value: at, decimals: decimalsOf(image), signed: false,
        paint: (pixels) => { for (let i = 0; i < pixels.length; i += 1) pixels[i] = colours[codes[i]]; },
      };
    },
  };
}

function visibilityLayer(key, title, text, image) {
  return scalarLayer({ key, title, text, image, map: 'gray', low: 0, high: 1, unit: 'visibility',
    ends: ['occluded', 'open'], decimals: 1 });
}

// test - base, over ±range; what is not compared and what is no number have colours of their own.
function differenceLayer({ key, title, text, view, test, base, unit, options }) {
  const { range, gray } = options;
  const map = gray ? 'grayMagnitude' : 'blueRed';
  const ticks = gray ? ['0', numberText(range / 2, 3), numberText(range, 2)]
    : [`${signedText(-range, 2)} too dark`, '0', `${signedText(range, 2)} too bright`];
  return {
    key: `${key} ${range} ${gray}`, title, text, width: test.width, height: test.height,
    bars: [{ map, unit: gray ? `size of ${unit}` : unit, ticks }],
    keys: [{ colour: signColours.invalid, text: 'not compared' }],
    async load() {
      const [a, b, noise] = await Promise.all([base, test, view.images.noise].map(imageValues));
      const palette = pixelPalette(map, errorSteps);
      const invalid = pixelOf(signColours.invalid);
      const nonfinite = pixelOf(signColours.nonfinite);
      const scale = (errorSteps - 1) / (gray ? range : 2 * range);
      return {
        value: (i) => (noise.codes[i] === noise.none ? NaN : b.at(i) - a.at(i)),
        decimals: decimalsOf(test), signed: true,
        paint: (pixels) => {
          for (let i = 0; i < pixels.length; i += 1) {
            const error = b.values[b.codes[i]] - a.values[a.codes[i]];
            if (error !== error) {
              pixels[i] = nonfinite;
            } else if (noise.codes[i] === noise.none) {
              pixels[i] = invalid;
            } else {
              const step = ((gray ? Math.abs(error) : error + range) * scale + 0.5) | 0;
              pixels[i] = palette[step < 0 ? 0 : step >= errorSteps ? errorSteps - 1 : step];
            }
          }
        },
      };
    },
  };
}

// Missing and false occlusion over the truth in pale gray.
function maskLayer(view, cell) {
  const { threshold } = stageData;
  return {
    key: `masks ${cell.id}`, title: `${cell.name}: masks`,
    text: `Where visibility is off by more than ${threshold} and three standard errors of the truth, which lies under it in gray. The areas are those beyond ${threshold} alone, without the noise of the truth: with few rays the picture shows less.`,
    width: view.width, height: view.height, bars: [],
    keys: [{ colour: signColours.missing, text: `missing occlusion, ${cell.missing} % of the valid pixels` },
      { colour: signColours.false, text: `false occlusion, ${cell.false} %` }],
    async load() {
      const { truth, noise } = view.images;
      const [base, error, test] = await Promise.all([truth, noise, cell.images.output].map(imageValues));
      const grays = Uint32Array.from(base.values, (value) => pixelOf(colourAt('paleGray', value)));
      const missing = pixelOf(signColours.missing);
      const falseOcclusion = pixelOf(signColours.false);
      const value = (i) => (error.codes[i] === error.none ? NaN : test.at(i) - base.at(i));
      return {
        value, decimals: decimalsOf(cell.images.output), signed: true,
        paint: (pixels) => {
          for (let i = 0; i < pixels.length; i += 1) {
            const off = value(i);
            const limit = Math.max(threshold, 3 * error.values[error.codes[i]]);
            pixels[i] = off > limit ? missing : off < -limit ? falseOcclusion : grays[base.codes[i]];
          }
        },
      };
    },
  };
}

// The truth's occlusion by what causes most of it: the more is occluded, the fuller the colour.
function causeLayer(view) {
  const { truth, noise } = view.images;
  const present = stageData.causes.filter(({ id }) => view.images[id]);
  return {
    key: `causes ${view.key}`, title: 'Causes of the truth’s occlusion',
    text: 'What most of the occluding rays meet: nothing in one layer of depth shows the first three.',
    width: view.width, height: view.height, bars: [],
    keys: present.map(({ id, label }) => ({ colour: causeColours[id], text: label })),
    async load() {
      const [base, compared, ...causes] = await Promise.all([truth, noise, ...present.map(({ id }) => view.images[id])].map(imageValues));
      const shades = present.map(({ id }) => Array.from({ length: 256 }, (_, i) => pixelOf(mixedColour(0xffffff, causeColours[id], i / 255))));
      const invalid = pixelOf(signColours.invalid);
      return {
        value: (i) => 1 - base.at(i), decimals: decimalsOf(truth), signed: false,
        paint: (pixels) => {
          for (let i = 0; i < pixels.length; i += 1) {
            let most = 0;
            for (let c = 1; c < causes.length; c += 1) if (causes[c].at(i) > causes[most].at(i)) most = c;
            const occlusion = Math.min(Math.max(1 - base.at(i), 0), 1);
            pixels[i] = compared.codes[i] === compared.none ? invalid : shades[most][Math.round(occlusion * 255)];
          }
        },
      };
    },
  };
}

// By picture and method; what belongs to the view is the same for every method.
const layerKinds = {
  truth: (view) => visibilityLayer(`truth ${view.key}`, 'Truth',
    `Ray-traced visibility, ${view.samples > 0 ? `${view.samples} samples a pixel` : 'from a file'}, R ${view.radius} m: white is open.`, view.images.truth),
  noise: (view, cell, options) => scalarLayer({ key: `noise ${view.key}`, title: 'Truth’s noise',
    text: 'Standard error of each pixel’s truth: no method can be judged finer than this.', image: view.images.noise,
    map: options.gray ? 'grayMagnitude' : 'magma', low: 0, high: view.noiseHigh, unit: 'standard error of visibility',
    decimals: 3 }),
  depth: (view, cell, options) => scalarLayer({ key: `depth ${view.key}`, title: 'Depth',
    text: 'Linear depth of the G-buffer that all methods read; the farthest 1 % share one colour.',
    image: view.images.depth, map: options.gray ? 'gray' : 'viridis', low: view.images.depth.low, high: view.depthHigh,
    unit: 'm' }),
  output: (view, cell) => visibilityLayer(`output ${cell.id}`, `${cell.name}: output`,
    cell.filter === 'none' ? 'The method’s visibility; no filter is applied.'
      : `The method’s visibility after the filter ${cell.filter}.`, cell.images.output),
  raw: (view, cell) => visibilityLayer(`raw ${cell.id}`, `${cell.name}: raw`, 'The same before the filter.',
    cell.images.raw),
  error: (view, cell, options) => differenceLayer({ key: `error ${cell.id}`, title: `${cell.name}: signed error`,
    text: 'Output minus truth. Red is too bright: occlusion is missing. Blue is too dark.', view,
    test: cell.images.output, base: view.images.truth, unit: 'output − truth', options }),
  masks: maskLayer,
  causes: causeLayer,
};
const viewPictures = new Set(['truth', 'noise', 'depth', 'causes']);

function hasCauses(view) {
  return stageData.causes.some(({ id }) => view.images[id]);
}

// The layer of a picture, or of the output where there is no such picture: a method without a filter is its own raw.
function layerOf(picture, view, cell, options) {
  const images = viewPictures.has(picture) ? view.images : cell.images;
  const absent = { raw: !images.raw, depth: !images.depth, noise: !view.noiseHigh, causes: !hasCauses(view) }[picture];
  return layerKinds[absent ? 'output' : picture](view, cell, options);
}

// Painted layers, the latest ones kept: a canvas of the image's size and the value of each pixel.
const paintedLayers = new Map();
const mostPaintedLayers = 12;

async function paintLayer(layer) {
  const { value, decimals, signed, paint } = await layer.load();
  const canvas = document.createElement('canvas');
  canvas.width = layer.width;
  canvas.height = layer.height;
  const context = canvas.getContext('2d');
  const data = context.createImageData(layer.width, layer.height);
  paint(new Uint32Array(data.data.buffer));
  context.putImageData(data, 0, 0);
  return { canvas, value, decimals, signed };
}

function paintedLayer(layer) {
  const painted = paintedLayers.get(layer.key) ?? paintLayer(layer);
  paintedLayers.delete(layer.key);
  paintedLayers.set(layer.key, painted);
  if (paintedLayers.size > mostPaintedLayers) paintedLayers.delete(paintedLayers.keys().next().value);
  return painted;
}
