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

// Depth's bits are those of a prediction from pixels of the same triangle, across which its reciprocal is linear, plus what
// is stored.
function unpackedDepths(bytes, triangles, width, height) {
  const bits = foldedIntegers(bytes);
  const depths = new Float32Array(bits.buffer);
  const guess = new Float32Array(1);
  const guessBits = new Uint32Array(guess.buffer);
  const planes = surfacePlanes.map((plane) => plane.map(([x, y]) => ({ x, y, step: x + y * width })));
  const sources = takenFrom.map(([x, y]) => ({ x, y, step: x + y * width }));
  for (let y = 0, i = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1, i += 1) {
      const isSame = (to) => y + to.y >= 0 && x + to.x >= 0 && x + to.x < width && triangles[i + to.step] === triangles[i];
      const plane = planes.find(([a, b, c]) => isSame(a) && isSame(b) && isSame(c));
      const source = plane ? null : sources.find(isSame);
      let expected;
      if (plane) {
        const [a, b, c] = plane.map(({ step }) => depths[i + step]);
        guess[0] = 1 / (1 / a + 1 / b - 1 / c);
        if (!(guess[0] > 0 && Number.isFinite(guess[0]))) guess[0] = a;
        [expected] = guessBits;
      } else if (source) {
        expected = bits[i + source.step];
      } else {
        const left = x > 0 ? bits[i - 1] : 0;
        const up = y > 0 ? bits[i - width] : 0;
        expected = x === 0 ? up : y === 0 ? left : medianOf(left, up, bits[i - width - 1]);
      }
      bits[i] += expected;
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
