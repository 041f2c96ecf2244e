// Numbers as the rest of the page writes them: equal decimals, a true minus sign, a dash where there is none.
function numberText(value, decimals) {
  if (!Number.isFinite(value)) return '–';
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace('-', '') : text.replace('-', '−');
}

function signedText(value, decimals) {
  const text = numberText(value, decimals);
  return value > 0 && Number(text) !== 0 ? `+${text}` : text;
}

// Decimals that show every step of a quantised image.
function decimalsOf(image) {
  return Math.max(2, Math.ceil(-Math.log10(image.step)));
}
