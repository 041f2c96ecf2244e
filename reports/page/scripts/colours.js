// Colour maps by a few control points at equal distances, as 0xRRGGBB: magma and viridis (van der Walt, Smith, 2015) for
// magnitudes and depth, RdBu (Brewer, 2003) for signed error, whose ends are of equal lightness.
const colourMaps = {
  gray: [0x000000, 0xffffff],
  grayMagnitude: [0xffffff, 0x000000],
  magma: [0x000004, 0x1d1147, 0x51127c, 0x832681, 0xb73779, 0xe75263, 0xfc8961, 0xfec488, 0xfcfdbf],
  viridis: [0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725],
  blueRed: [0x053061, 0x2166ac, 0x4393c3, 0x92c5de, 0xf7f7f7, 0xf4a582, 0xd6604d, 0xb2182b, 0x67001f],
  paleGray: [0x70706e, 0xf2f2f0],
};

// Told apart under every common colour blindness, and from gray (Okabe, Ito, Color Universal Design, 2008).
const signColours = {
  missing: 0xd55e00,
  false: 0x0072b2,
  invalid: 0x6f6f76,
  nonfinite: 0xff00ff,
};

const causeColours = { outside: 0x56b4e9, hidden: 0xd55e00, grazing: 0xe69f00, visible: 0x777777 };

function cssColour(colour) {
  return `#${colour.toString(16).padStart(6, '0')}`;
}

// As a pixel of ImageData seen as 32-bit numbers; every machine with a browser is little-endian.
function pixelOf(colour) {
  return (0xff000000 | (colour & 0xff) << 16 | (colour & 0xff00) | colour >> 16) >>> 0;
}

// `part` of the way from one colour to another, in sRGB.
function mixedColour(from, to, part) {
  let colour = 0;
  for (const shift of [16, 8, 0]) {
    const a = from >> shift & 255;
    colour |= Math.round(a + ((to >> shift & 255) - a) * part) << shift;
  }
  return colour;
}

// The map at `position`, which is held to [0, 1].
function colourAt(map, position) {
  const points = colourMaps[map];
  const place = Math.min(Math.max(position, 0), 1) * (points.length - 1);
  const low = Math.min(Math.floor(place), points.length - 2);
  return mixedColour(points[low], points[low + 1], place - low);
}

// `steps` pixels from end to end of a map.
function pixelPalette(map, steps) {
  return Uint32Array.from({ length: steps }, (_, i) => pixelOf(colourAt(map, i / (steps - 1))));
}

function cssGradient(map) {
  return `linear-gradient(to right,${colourMaps[map].map(cssColour).join(',')})`;
}
