// Presets from a file of the reader's, as `aoscore tune` writes one beside tune.json, or as the section gives one out.
const largestPresetFile = 2 ** 20;

function isObject(value) {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function listed(words) {
  return words.length > 0 ? words.join(', ') : 'none';
}

// The file's content; what it does not have is empty. Throws an error in words for another form.
function parsedPresetFile(text) {
  let content;
  try {
    content = JSON.parse(text);
  } catch (error) {
    throw new Error(`It is no JSON: ${error.message}.`);
  }
  const { method = null, presets, preset_filters: filters = {}, absolute_presets: absolute = {} } = isObject(content) ? content : {};
  if (!isObject(presets) || Object.keys(presets).length === 0 || !Object.values(presets).every(isObject)) {
    throw new Error('It holds no presets: what aoscore tune writes as METHOD.tuned.json has some, and so has what this section lets you download.');
  }
  if (!isObject(filters) || !isObject(absolute)) throw new Error('Its preset_filters and absolute_presets must be objects.');
  return { method, presets, filters, absolute };
}

// What a value must be; empty where it is.
function faultOfValue({ type, low, high, choices }, value) {
  if (type === 'choice') return choices.includes(value) ? '' : `one of ${choices.join(', ')}`;
  if (type === 'boolean') return typeof value === 'boolean' ? '' : 'true or false';
  const isNumber = typeof value === 'number' && (type !== 'integer' || Number.isInteger(value));
  return isNumber && value >= low && value <= high ? '' : `${type === 'integer' ? 'a whole number' : 'a number'} from ${low} to ${high}`;
}

function checkPreset(name, values, method) {
  for (const [id, value] of Object.entries(values)) {
    const parameter = method.parameters.find((other) => other.id === id);
    if (!parameter) {
      throw new Error(`Preset ${name} names ${id}, which ${method.label} does not have; it has ${listed(method.parameters.map((other) => other.id))}.`);
    }
    const valid = faultOfValue(parameter, value);
    if (valid) throw new Error(`Preset ${name} has ${id} = ${JSON.stringify(value)}, which must be ${valid}.`);
  }
}

// The parameter that every run makes its AO radius.
function radiusParameter(method, lengths, radius_m) {
  const followed = Object.entries(lengths).filter(([preset]) => !(preset in method.absolute_presets));
  const isRadius = ({ id }) => followed.length > 0 && followed.every(([, drawn]) => drawn[id] === radius_m);
  return method.parameters.find((parameter) => parameter.length_power === 1 && isRadius(parameter))?.id;
}

// The lengths of a preset in a view, whose radius they follow as those of the method's own presets do.
function drawnLengths(method, values, view) {
  const lengths = view.method_lengths[method.id] ?? {};
  const radius = radiusParameter(method, lengths, view.radius_m);
  if (view.own_parameters || radius === undefined) return {};
  const factor = view.radius_m / values[radius];
  return Object.fromEntries(method.parameters.filter(({ length_power: power }) => power !== 0)
    .map(({ id, length_power: power }) => [id, id === radius ? view.radius_m : values[id] * factor ** power]));
}

function filterOfFile(named, filters, name) {
  const { filter = 'none', preset = 'default' } = typeof named === 'string' ? { filter: named } : named ?? {};
  const found = filters.find(({ id }) => id === filter);
  if (filter !== 'none' && !(found && preset in found.presets)) {
    throw new Error(`Preset ${name} has the filter ${filter} (${preset}), which this page does not run; it runs ${listed(filters.map(({ id }) => id))}.`);
  }
  return { filter, preset };
}

// Adds the file's presets to those of its method in all views. Returns the method's id and the presets' names here. Nothing
// is added where anything is at fault.
function addPresetsOfFile({ methods, filters, views }, text, fileName, shownMethod) {
  const file = parsedPresetFile(text);
  const id = file.method ?? shownMethod;
  const method = methods.find((other) => other.id === id);
  if (!method) throw new Error(`It is for the method ${JSON.stringify(id)}, which this page does not run; it runs ${listed(methods.map((other) => other.id))}.`);
  const added = Object.entries(file.presets).map(([name, values]) => {
    checkPreset(name, values, method);
    return { name, as: `${name} (${fileName})`, values: { ...method.presets.default, ...values }, filter: filterOfFile(file.filters[name], filters, name) };
  });
  for (const { name, as, values, filter } of added) {
    method.presets[as] = values;
    method.preset_filters[as] = filter;
    if (name in file.absolute) method.absolute_presets[as] = String(file.absolute[name]);
    for (const view of Object.values(views)) {
      const lengths = name in file.absolute ? {} : drawnLengths(method, values, view);
      if (Object.keys(lengths).length > 0) view.method_lengths[id][as] = lengths;
    }
  }
  return { method: id, presets: added.map(({ as }) => as) };
}

async function readPresetFile(bench, file) {
  if (file.size > largestPresetFile) throw new Error(`It has ${file.size} bytes, and a file of presets has at most ${largestPresetFile}.`);
  const { method, presets } = addPresetsOfFile(bench.index, await file.text(), file.name, bench.setting.method?.id);
  bench.takeView(bench.setting.view);
  bench.chooseMethod(method);
  bench.form.elements.preset.value = presets[0];
  bench.choosePreset(presets[0]);
}

// A file is chosen, or dropped anywhere on the section.
function acceptPresetFiles(element, bench) {
  const failure = element.querySelector('.live-file-failure');
  const take = async ([file]) => {
    if (!file || !bench.setting.view) return;
    failure.hidden = true;
    try {
      await readPresetFile(bench, file);
    } catch (error) {
      failure.textContent = `${file.name} was not taken. ${error.message}`;
      failure.hidden = false;
    }
  };
  const chooser = bench.form.elements.file;
  chooser.addEventListener('click', () => { chooser.value = ''; });  // the same file may be chosen again
  chooser.addEventListener('change', () => take(chooser.files));
  element.addEventListener('dragover', (event) => event.preventDefault());
  element.addEventListener('drop', (event) => {
    event.preventDefault();
    take(event.dataTransfer.files);
  });
}
