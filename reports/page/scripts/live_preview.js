// A small version of a view for a first picture: every so many pixels of its G-buffer, which a camera of fewer and larger pixels
// would see too.
const previewWidth_px = 320;

// At least half of the width is left out: else the full picture comes as soon.
function previewFactor(view) {
  return Math.max(2, Math.ceil(view.width / previewWidth_px));
}

function previewView(view, factor) {
  return { ...view, width: Math.ceil(view.width / factor), height: Math.ceil(view.height / factor),
    pixel_size: view.pixel_size.map((size) => size * factor) };
}

// The middle pixel of each square of `factor` pixels.
function previewInputs(inputs, view, factor) {
  const { width, height } = previewView(view, factor);
  return Object.fromEntries(Object.entries(inputs).map(([name, { format, data }]) => {
    const parts = format === 'R' ? 1 : 4;
    const small = new Float32Array(width * height * parts);
    for (let y = 0; y < height; y += 1) {
      const row = Math.min(y * factor + (factor >> 1), view.height - 1) * view.width;
      for (let x = 0; x < width; x += 1) {
        const from = parts * (row + Math.min(x * factor + (factor >> 1), view.width - 1));
        for (let part = 0; part < parts; part += 1) small[parts * (y * width + x) + part] = data[from + part];
      }
    }
    return [name, { format, data: small }];
  }));
}
