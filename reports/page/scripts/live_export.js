// What a setting is called elsewhere: members of a method.json, and the command line that measures it.

// What differs from the defaults as the run draws them in the view.
function changedValues(descriptor, values) {
  const usual = descriptor.presets.default;
  return Object.fromEntries(Object.entries(values).filter(([id, value]) => value !== usual[id]));
}

const livePreset = 'live';

function changesLength(method, parameters) {
  return Object.keys(lengthsAmong(method, changedValues(method, parameters))).length > 0;
}

// Whether the filter would run otherwise behind the preset `live`.
function losesFilterValues({ method, parameters, filter, filterParameters }) {
  const behind = changesLength(method, parameters) ? filter?.own : filter;
  return Boolean(behind) && Object.keys(changedValues(behind, filterParameters)).length > 0;
}

// To be merged into shaders/methods/<id>/method.json, whose preset `live` it makes. Where no length was changed, all of
// them go on following the radius of a run; else the preset is absolute.
function presetText({ view, method, parameters, filter }) {
  const changed = changedValues(method, parameters);
  const absolute = changesLength(method, parameters);
  const preset = { presets: { [livePreset]: absolute ? { ...changed, ...lengthsAmong(method, parameters) } : changed } };
  if (absolute) preset.absolute_presets = { [livePreset]: `set by hand at an AO radius of ${view.radius_m} m` };
  if (filter) preset.preset_filters = { [livePreset]: filter.id };
  return JSON.stringify(preset, null, 2);
}

function quoted(word) {
  return /^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

function commandText({ view, method, parameters, filter, filterParameters, border, resolution }, { seed, methodsDir }) {
  const words = ['aoscore', ...(seed === 1 ? [] : ['--seed', String(seed)]), 'score', view.scene, '--view', view.view,
    ...(methodsDir ? ['--methods-dir', methodsDir] : []), '--methods', method.id, '--size', `${view.width}x${view.height}`, '--samples', String(view.samples),
    '--radius', String(view.radius_m), ...(view.own_parameters ? ['--own-parameters'] : []),
    '--filter', filter ? filter.id : 'none', '--border', border, '--resolution', resolution];
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
