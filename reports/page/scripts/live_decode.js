// The G-buffers that methods are run on, unpacked when they are first needed; src/page/live/live_packing.h says how they lie
// here.

// 32-bit integers in four planes of bytes, the highest first, that were folded (0, -1, 1, -2, … became 0, 1, 2, 3, …).
function foldedIntegers(bytes) {
  const size = bytes.length / 4;
  const values = new Uint32Array(size);
  for (let i = 0; i < size; i += 1) {
    const folded = bytes[i] << 24 | bytes[size + i] << 16 | bytes[2 * size + i] << 8 | bytes[3 * size + i];
    values[i] = folded >>> 1 ^ -(folded & 1);
  }
  return values;
}

// 32-bit integers of an image, of which is stored what is left after left + up - upper left.
function unpackedIntegers(bytes, width, height) {
  const values = foldedIntegers(bytes);
  for (let y = 0, i = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1, i += 1) {
      const left = x > 0 ? values[i - 1] : 0;
      const up = y > 0 ? values[i - width] : 0;
      const upLeft = x > 0 && y > 0 ? values[i - width - 1] : 0;
      values[i] += left + up - upLeft;  // modulo 2^32, as the array stores it
    }
  }
  return values;
}

// Both octahedral codes of each pixel, one after the other.
function plainCodes(bytes) {
  return new Uint16Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / 2);
}

// The same from the residuals of all first codes and then of all second ones.
function predictedCodes(bytes, width, height) {
  const size = width * height;
  const [first, second] = [0, 2 * size].map((start) => predictCodes(unfoldedResiduals(bytes.subarray(start), size), width, height));
  const codes = new Uint16Array(2 * size);
  for (let i = 0; i < size; i += 1) {
    codes[2 * i] = first[i];
    codes[2 * i + 1] = second[i];
  }
  return codes;
}

// Unit vectors, four floats each, from octahedral codes of two 16-bit numbers.
function unpackedNormals(codes) {
  const normals = new Float32Array(2 * codes.length);
  for (let i = 0; i < codes.length; i += 2) {
    let x = codes[i] / 32767 - 1;
    let y = codes[i + 1] / 32767 - 1;
    const z = 1 - Math.abs(x) - Math.abs(y);
    if (z < 0) {
      const fold = x;
      x = (1 - Math.abs(y)) * (fold < 0 ? -1 : 1);
      y = (1 - Math.abs(fold)) * (y < 0 ? -1 : 1);
    }
    const length = Math.sqrt(x * x + y * y + z * z);
    normals[2 * i] = x / length;
    normals[2 * i + 1] = y / length;
    normals[2 * i + 2] = z / length;
  }
  return normals;
}

// How each kind of input is unpacked.
const inputKinds = {
  floats: (bytes, width, height) => ({ format: 'R', data: new Float32Array(unpackedIntegers(bytes, width, height).buffer) }),
  normals: (bytes) => ({ format: 'RGBA', data: unpackedNormals(plainCodes(bytes)) }),
  'predicted normals': (bytes, width, height) => ({ format: 'RGBA', data: unpackedNormals(predictedCodes(bytes, width, height)) }),
};

// {name: {format, data}} as LiveRunner takes them, of a view or a previewView(). `say(text)` is told how far it is.
async function unpackedInputs({ width, height, inputs }, say) {
  const unpacked = {};
  const all = Object.entries(inputs);
  for (const [i, [name, { kind, data }]] of all.entries()) {
    say(`Unpacking ${name.replaceAll('_', ' ')}, ${i + 1} of ${all.length} parts of the G-buffer …`);
    unpacked[name] = inputKinds[kind](await inflatedBytes(data), width, height);
  }
  return unpacked;
}
