// Errors and pictures of a live result against the page's truth. `truth` and `noise` are imageValues(); what is not
// compared has no noise.

function liveErrors(output, truth, noise, noiseFloor) {
  let count = 0;
  let sum = 0;
  let squares = 0;
  let nonfinite = 0;
  for (let i = 0; i < output.length; i += 1) {
    if (noise.codes[i] === noise.none) continue;
    const error = output[i] - truth.values[truth.codes[i]];
    if (!Number.isFinite(error)) {
      nonfinite += 1;
      continue;
    }
    count += 1;
    sum += error;
    squares += error * error;
  }
  const mse = squares / count;
  return { count, nonfinite, rmse: Math.sqrt(mse), bias: sum / count,
    rmse_debiased: Math.sqrt(Math.max(0, mse - noiseFloor * noiseFloor)) };
}

function paintPixels(canvas, width, height, colourOf) {
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const context = canvas.getContext('2d');
  const image = context.createImageData(width, height);
  const pixels = new Uint32Array(image.data.buffer);
  for (let i = 0; i < pixels.length; i += 1) pixels[i] = colourOf(i);
  context.putImageData(image, 0, 0);
  canvas.style.imageRendering = width < canvas.clientWidth ? 'pixelated' : 'auto';
}

const liveSteps = 256;

function paintVisibility(canvas, { width, height }, valueAt) {
  const palette = pixelPalette('gray', liveSteps);
  const nonfinite = pixelOf(signColours.nonfinite);
  paintPixels(canvas, width, height, (i) => {
    const value = valueAt(i);
    return value === value ? palette[Math.min(Math.max(value * (liveSteps - 1) + 0.5 | 0, 0), liveSteps - 1)] : nonfinite;
  });
}

function paintError(canvas, { width, height }, output, truth, noise, range) {
  const palette = pixelPalette('blueRed', errorSteps);
  const invalid = pixelOf(signColours.invalid);
  const nonfinite = pixelOf(signColours.nonfinite);
  paintPixels(canvas, width, height, (i) => {
    if (noise.codes[i] === noise.none) return invalid;
    const error = output[i] - truth.values[truth.codes[i]];
    if (error !== error) return nonfinite;
    const step = (error + range) / (2 * range) * (errorSteps - 1) + 0.5 | 0;
    return palette[Math.min(Math.max(step, 0), errorSteps - 1)];
  });
}

// A row of the table of errors: numbers with bars, as long as they are large beside the largest of the column.
function errorCells(errors, largest) {
  return [['rmse', numberText], ['rmse_debiased', numberText], ['bias', signedText]].map(([id, text]) => {
    const value = errors[id] ?? NaN;
    const bar = make('span', `live-bar ${id === 'bias' ? (value > 0 ? 'bright' : 'dark') : ''}`.trim());
    bar.style.setProperty('--part', Number.isFinite(value) ? String(Math.abs(value) / (largest[id] || 1)) : '0');
    return make('td', '', text(value, 4), bar);
  });
}
