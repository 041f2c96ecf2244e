// Controls of a method's parameters. A slider covers what is likely, the number beside it the whole range.
const sliderSteps = 1000;

// Between a slider's place in [0, 1] and a value. Around settings above 0 it is logarithmic, a factor of 16 to each side;
// from 0 on it is quadratic up to 1; over a short range it is linear.
function sliderScale({ type, low, high }, settings) {
  if (type === 'integer') {
    const top = Math.min(high, 8 * Math.max(...settings, 1));
    return { value: (place) => Math.round(low + place * (top - low)), place: (value) => (value - low) / (top - low || 1) };
  }
  const positive = settings.filter((value) => value > 0);
  const largest = Math.max(...positive, 0);
  if (low >= 0 && largest > 0 && high > 20 * largest) {
    const bottom = Math.max(low, Math.min(...positive) / 16);
    const span = Math.log(Math.min(high, 16 * largest) / bottom);
    return { value: (place) => (place <= 0 ? Math.min(low, bottom) || 0 : bottom * Math.exp(place * span)),
      place: (value) => (value <= bottom ? 0 : Math.log(value / bottom) / span) };
  }
  if (low === 0 && largest === 0 && high > 1) {
    return { value: (place) => place * place, place: (value) => Math.sqrt(value) };
  }
  return { value: (place) => low + place * (high - low), place: (value) => (value - low) / (high - low || 1) };
}

let controlCount = 0;

function numberControl(parameter, settings, changed) {
  const { id, type, low, high, unit } = parameter;
  const scale = sliderScale(parameter, settings);
  const range = make('input');
  Object.assign(range, { type: 'range', min: 0, max: sliderSteps, step: 1, id: `live-${controlCount += 1}`, name: id });
  const number = make('input');
  Object.assign(number, { type: 'number', min: low, max: high, step: type === 'integer' ? 1 : 'any' });
  number.setAttribute('aria-label', `${id}, exact value${unit ? ` in ${unit}` : ''}`);
  const showOnSlider = (value) => {
    range.value = Math.round(sliderSteps * Math.min(Math.max(scale.place(value), 0), 1));
    range.setAttribute('aria-valuetext', `${value} ${unit}`.trim());
  };
  const short = (value) => (type === 'integer' ? value : Number(value.toPrecision(3)));
  range.addEventListener('input', () => {
    const value = Math.min(Math.max(short(scale.value(range.value / sliderSteps)), low), high);
    number.value = value;
    number.setCustomValidity('');
    range.setAttribute('aria-valuetext', `${value} ${unit}`.trim());
    changed(value);
  });
  number.addEventListener('input', () => {
    if (!number.value || !number.checkValidity()) return;  // the browser says what would be valid
    showOnSlider(number.valueAsNumber);
    changed(number.valueAsNumber);
  });
  number.addEventListener('change', () => number.reportValidity());
  const set = (value) => {
    number.value = value;
    showOnSlider(value);
  };
  return { labelled: range, elements: [range, number, make('span', 'unit-beside', unit)], set };
}

function choiceControl({ id, choices, not_here: notHere = [] }, changed) {
  const select = make('select', '', ...choices.map((choice) => new Option(choice, choice)));
  for (const option of select.options) option.disabled = notHere.includes(option.value);
  Object.assign(select, { id: `live-${controlCount += 1}`, name: id });
  select.addEventListener('change', () => changed(select.value));
  return { labelled: select, elements: [select], set: (value) => { select.value = value; } };
}

function booleanControl({ id }, changed) {
  const box = make('input');
  Object.assign(box, { type: 'checkbox', id: `live-${controlCount += 1}`, name: id });
  box.addEventListener('change', () => changed(box.checked));
  return { labelled: box, elements: [box], set: (value) => { box.checked = value; } };
}

// Fills a fieldset with a control for each parameter of a method or filter. `values` is what they show and change;
// `changed` is called after each change. Returns a function that shows the values anew.
function fillParameters(fieldset, descriptor, values, changed) {
  const controls = descriptor.parameters.map((parameter) => {
    const { id, type, meaning } = parameter;
    const settings = Object.values(descriptor.presets).map((preset) => preset[id]);
    const change = (value) => {
      values[id] = value;
      changed();
    };
    const control = type === 'choice' ? choiceControl(parameter, change)
      : type === 'boolean' ? booleanControl(parameter, change) : numberControl(parameter, settings, change);
    const label = make('label', '', id);
    label.htmlFor = control.labelled.id;
    const note = make('small', '', meaning);
    note.id = `${control.labelled.id}-note`;
    control.labelled.setAttribute('aria-describedby', note.id);
    return { ...control, row: make('div', 'live-parameter', label, make('span', 'live-inputs', ...control.elements), note), id };
  });
  fieldset.replaceChildren(fieldset.querySelector('legend'), ...controls.map(({ row }) => row));
  fieldset.hidden = controls.length === 0;
  const show = () => { for (const { set, id } of controls) set(values[id]); };
  show();
  return show;
}
