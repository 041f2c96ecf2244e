// The images that the page holds, unpacked when they are first needed; src/page/pictures/quantised_image.h says how they lie here.
const unpackedImages = new Map();
const documentIsParsed = document.readyState === 'loading'
  ? new Promise((resolve) => { document.addEventListener('DOMContentLoaded', resolve, { once: true }); })
  : Promise.resolve();

// The bytes of a text as src/page/document/dense_text.h writes them.
function denseBytes(text) {
  const bytes = new Uint8Array(Math.floor(text.length * 13 / 16));
  const digitAt = (i) => {
    const code = text.charCodeAt(i);
    return code < 60 ? code - 33 : code - 34;
  };
  let size = 0;
  for (let i = 0, bits = 0, count = 0; i < text.length; i += 2) {
    const isLastAlone = i + 1 === text.length;
    bits |= (isLastAlone ? digitAt(i) : digitAt(i) * 93 + digitAt(i + 1)) << count;
    count += isLastAlone ? 6 : 13;
    for (; count >= 8; count -= 8, bits >>>= 8) {
      bytes[size] = bits & 255;
      size += 1;
    }
  }
  return bytes.subarray(0, size);
}

async function inflatedBytes(name) {
  await documentIsParsed;
  const packed = denseBytes(document.querySelector(`script[data-image="${CSS.escape(name)}"]`).textContent);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Residuals of two bytes were folded (0, -1, 1, -2, … became 0, 1, 2, 3, …), all their high bytes first.
function unfoldedResiduals(bytes, size) {
  const residuals = new Uint16Array(size);
  for (let i = 0; i < size; i += 1) {
    const folded = bytes[i] << 8 | bytes[size + i];
    residuals[i] = folded >> 1 ^ -(folded & 1);
  }
  return residuals;
}

// What the median edge detector expects beside these neighbours.
function medianOf(left, up, upLeft) {
  const low = left < up ? left : up;
  const high = left < up ? up : left;
  return upLeft >= high ? low : upLeft <= low ? high : left + up - upLeft;
}

// Adds to each residual what the median edge detector predicts; the array's type wraps the sums around.
function predictCodes(codes, width, height) {
  for (let y = 0, i = 0; y < height; y += 1) {
    let left = 0;
    let upLeft = 0;
    for (let x = 0; x < width; x += 1, i += 1) {
      const up = y > 0 ? codes[i - width] : 0;
      codes[i] += medianOf(left, up, upLeft);
      left = codes[i];
      upLeft = up;
    }
  }
  return codes;
}

// Depth lies in the page as the live methods read it, and where nothing is compared as well.
async function unpackExactImage({ data, width, height, low, step, valid }) {
  const [bytes, { codes: known, none: unknown }] = await Promise.all([inflatedBytes(data), imageValues(valid)]);
  const exact = new Float32Array(unpackedIntegers(bytes, width, height).buffer);
  const none = 65535;
  const codes = Uint16Array.from(exact, (value, i) => (known[i] === unknown ? none : Math.round((value - low) / step)));
  const values = Float32Array.from({ length: none + 1 }, (_, code) => (code === none ? NaN : low + step * code));
  return { codes, values, none, at: (i) => (codes[i] === none ? NaN : exact[i]) };
}

async function unpackImage(image) {
  if (image.exact) return unpackExactImage(image);
  const bytes = await inflatedBytes(image.data);
  const size = image.width * image.height;
  const codes = predictCodes(image.bytes === 1 ? bytes : unfoldedResiduals(bytes, size), image.width, image.height);
  const none = image.bytes === 1 ? 255 : 65535;
  const values = Float32Array.from({ length: none + 1 },
    (_, code) => (code === none ? NaN : image.low + image.step * code));
  return { codes, values, none, at: (i) => values[codes[i]] };
}

// A promise of { codes, values, none, at }: at(i) is the value of pixel i = x + y * width, NaN where there is none;
// values[codes[i]] is within half a step of it, faster in a loop.
function imageValues(image) {
  if (!unpackedImages.has(image.data)) unpackedImages.set(image.data, unpackImage(image));
  return unpackedImages.get(image.data);
}
