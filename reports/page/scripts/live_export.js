// What a setting is called elsewhere: members of a method.json, and the command line that measures it.

// What differs from the method's defaults.
function changedValues(descriptor, values) {
  const usual = descriptor.presets.default;
  return Object.fromEntries(Object.entries(values).filter(([id, value]) => value !== usual[id]));
}

const livePreset = 'live';

// To be merged into shaders/methods/<id>/method.json, whose preset `live` it makes.
function presetText({ method, parameters, filter }) {
  const preset = { presets: { [livePreset]: changedValues(method, parameters) } };
  if (filter) preset.preset_filters = { [livePreset]: filter.id };
  return JSON.stringify(preset, null, 2);
}

function quoted(word) {
  return /^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

function commandText({ view, method, parameters, filter, filterParameters, border, resolution }, { seed, methodsDir }) {
  const words = ['aoscore', ...(seed === 1 ? [] : ['--seed', String(seed)]), 'score', view.scene, '--view', view.view,
    ...(methodsDir ? ['--methods-dir', methodsDir] : []), '--methods', method.id, '--size', `${view.width}x${view.height}`, '--samples', String(view.samples),
    '--radius', String(view.radius_m), '--filter', filter ? filter.id : 'none', '--border', border, '--resolution', resolution];
  const assignments = Object.entries({ ...changedValues(method, parameters),
    ...(filter ? Object.fromEntries(Object.entries(changedValues(filter, filterParameters)).map(([id, value]) => [`filter.${id}`, value])) : {}),
  }).map(([id, value]) => `${id}=${value}`);
  if (assignments.length > 0) words.push('--set', ...assignments);
  return words.map(quoted).join(' ');
}

function downloadText(name, text) {
  const link = make('a');
  link.href = URL.createObjectURL(new Blob([text], { type: 'application/json' }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

// Selects the text where the browser does not let a page write to the clipboard.
async function copyText(field, button) {
  try {
    await navigator.clipboard.writeText(field.value);
    button.textContent = 'Copied';
  } catch {
    field.select();
    button.textContent = 'Selected: press Ctrl C';
  }
  setTimeout(() => { button.textContent = 'Copy'; }, 2000);
}
