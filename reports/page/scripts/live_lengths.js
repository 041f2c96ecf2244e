// Methods and filters as they are drawn in one view: their presets have the lengths that the run gives them there.

function drawnDescriptor(descriptor, lengths = {}) {
  const presets = Object.entries(descriptor.presets).map(([name, values]) => [name, { ...values, ...lengths[name] }]);
  return { ...descriptor, presets: Object.fromEntries(presets), own: descriptor };
}

function drawnDescriptors(descriptors, lengths) {
  return descriptors.map((descriptor) => drawnDescriptor(descriptor, lengths[descriptor.id]));
}

// An absolute preset keeps its filter's lengths as well.
function filterOfPreset(filter, method, preset) {
  return filter && preset in method.absolute_presets ? { ...filter, presets: filter.own.presets } : filter;
}

// By id, of the parameters that are lengths.
function lengthsAmong(descriptor, values) {
  const isLength = ({ id, length_power }) => length_power !== 0 && id in values;
  return Object.fromEntries(descriptor.parameters.filter(isLength).map(({ id }) => [id, values[id]]));
}
