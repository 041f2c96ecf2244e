// Surfaces behind one another that depth layers are gathered from, unpacked when they are first needed;
// src/page/live/surface_packing.h and live_surfaces.h say how they lie here.

// The pixels that a triangle's number, or a depth, is taken over from, and planes: pixels of which the first and the second
// less the third is the pixel itself. As [x, y] from the pixel.
const takenFrom = [[-1, 0], [0, -1], [1, -1], [-1, -1]];
const surfacePlanes = [
  [[-1, 0], [0, -1], [-1, -1]], [[-1, 0], [1, -1], [0, -1]], [[-1, -1], [1, -1], [0, -2]], [[0, -1], [-1, -1], [-1, -2]],
  [[0, -1], [1, -1], [1, -2]], [[-1, 0], [-1, -1], [-2, -1]], [[-1, 0], [-1, 0], [-2, 0]], [[0, -1], [0, -1], [0, -2]],
  [[-1, -1], [-1, -1], [-2, -2]], [[1, -1], [1, -1], [2, -2]],
];

function unpackedTriangles(bytes, width, height) {
  const size = width * height;
  const triangles = new Uint32Array(size);
  const news = foldedIntegers(bytes.subarray(size));
  for (let y = 0, i = 0, next = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1, i += 1) {
      const source = takenFrom[bytes[i]];
      if (source) {
        triangles[i] = triangles[i + source[0] + source[1] * width];
      } else {
        const before = y > 0 ? triangles[i - width] : x > 0 ? triangles[i - 1] : 0;
        triangles[i] = before + news[next];
        next += 1;
      }
    }
  }
  return triangles;
}

// Finds pixels of the same triangle before one: `plane(i, x, y)` is the place of three in a row of `steps`, `source(i, x, y)`
// that of one among takenFrom; -1 where there is none.
function neighboursOfTriangles(triangles, width) {
  const flat = (offsets) => ({ xs: Int32Array.from(offsets, ([x]) => x), ys: Int32Array.from(offsets, ([, y]) => y),
    steps: Int32Array.from(offsets, ([x, y]) => x + y * width) });
  const planes = flat(surfacePlanes.flat());
  const sources = flat(takenFrom);
  const isSame = ({ xs, ys, steps }, k, i, x, y) => y + ys[k] >= 0 && x + xs[k] >= 0 && x + xs[k] < width
    && triangles[i + steps[k]] === triangles[i];
  const plane = (i, x, y) => {
    for (let k = 0; k < planes.steps.length; k += 3) {
      if (isSame(planes, k, i, x, y) && isSame(planes, k + 1, i, x, y) && isSame(planes, k + 2, i, x, y)) return k;
    }
    return -1;
  };
  const source = (i, x, y) => {
    for (let k = 0; k < sources.steps.length; k += 1) if (isSame(sources, k, i, x, y)) return k;
    return -1;
  };
  return { plane, source, planeSteps: planes.steps, sourceSteps: sources.steps };
}

// Depth's bits are those of a prediction from pixels of the same triangle, across which its reciprocal is linear, plus what
// is stored.
function unpackedDepths(bytes, triangles, width, height) {
  const bits = new Int32Array(foldedIntegers(bytes).buffer);  // signed: sums that wrap around are fast then
  const depths = new Float32Array(bits.buffer);
  const reciprocals = new Float64Array(depths.length);
  const guess = new Float32Array(1);
  const guessBits = new Int32Array(guess.buffer);
  const { plane, source, planeSteps, sourceSteps } = neighboursOfTriangles(triangles, width);
  for (let y = 0, i = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1, i += 1) {
      const at = plane(i, x, y);
      const from = at < 0 ? source(i, x, y) : -1;
      if (at >= 0) {
        const near = i + planeSteps[at];
        guess[0] = 1 / (reciprocals[near] + reciprocals[i + planeSteps[at + 1]] - reciprocals[i + planeSteps[at + 2]]);
        bits[i] = bits[i] + (guess[0] > 0 && guess[0] < Infinity ? guessBits[0] : bits[near]) | 0;
      } else if (from >= 0) {
        bits[i] = bits[i] + bits[i + sourceSteps[from]] | 0;
      } else if (x === 0 || y === 0) {
        bits[i] = bits[i] + (x > 0 ? bits[i - 1] : y > 0 ? bits[i - width] : 0) | 0;
      } else {
        bits[i] = bits[i] + medianOf(bits[i - 1], bits[i - width], bits[i - width - 1]) | 0;
      }
      reciprocals[i] = 1 / depths[i];
    }
  }
  return depths;
}

// {count, depths, triangles} of a view or a previewView(): depths, negative where a face is seen from behind, and triangles'
// numbers, one surface after the other. `say(text)` is told how far it is.
async function unpackedSurfaces({ width, height, surfaces }, say) {
  const size = width * height;
  const count = surfaces.depths.length;
  const numbers = unpackedIntegers(await inflatedBytes(surfaces.numbers), surfaces.count, 1);
  const depths = new Float32Array(size * count);
  const triangles = new Uint32Array(size * count);
  for (let layer = 0; layer < count; layer += 1) {
    say(`Unpacking surfaces behind one another, ${layer + 1} of ${count} …`);
    const places = unpackedTriangles(await inflatedBytes(surfaces.triangles[layer]), width, height);
    const packed = await inflatedBytes(surfaces.depths[layer]);
    const far = layer === 0 && surfaces.first_is_depth ? new Float32Array(unpackedIntegers(packed, width, height).buffer)
      : unpackedDepths(packed, places, width, height);
    for (let i = 0, at = layer * size; i < size; i += 1, at += 1) {
      depths[at] = places[i] & 1 ? -far[i] : far[i];
      triangles[at] = numbers[places[i] >>> 1];
    }
  }
  return { count, depths, triangles };
}
