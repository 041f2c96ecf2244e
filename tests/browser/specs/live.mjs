// Drives the section of live parameters.

// The state once it has drawn: {method, parameters, filter, border, output, errors}.
export async function shown(page) {
  await page.waitForFunction(() => !document.querySelector('.live-failure').hidden
    || document.querySelector('.live-results').getAttribute('aria-busy') === 'false');
  return page.evaluate(() => {
    const failure = document.querySelector('.live-failure');
    if (!failure.hidden) throw new Error(failure.textContent);
    const { method, parameters, filter, border, output, errors } = document.querySelector('details.live').shown;
    return { method: method.id, parameters, filter: filter?.id ?? 'none', border, output: [...output], errors };
  });
}

export async function openLive(page) {
  await page.locator('details.live summary').click();
  return shown(page);
}

// Why the page does not run a method, or these values of its parameters, as it says itself; empty where it does. `live` is
// the run's live.json.
export function refusal({ processor, passes, ...method }, live, values = method.presets.default) {
  if (processor) return `computed on the processor (${processor})`;
  const layered = passes.flatMap(({ inputs }) => inputs).find((input) => ['depth_layers', 'side_layers'].includes(input));
  if (!layered) return '';
  if (!Object.values(live.views).every(({ surfaces }) => surfaces)) return `reads the input ${layered}`;
  const member = (input, name) => {
    const value = method[input]?.[name];
    return typeof value === 'string' && value.startsWith('@') ? values[value.slice(1)] : value;
  };
  if (!method.depth_layers) return `reads the input ${layered}`;
  if (member('side_layers', 'cameras')) return 'reads depth layers of further cameras';
  const sampling = member('depth_layers', 'sampling');
  return ['isotropic', 'anisotropic', 'rays'].includes(sampling) ? `takes depth layers by the sampling ${sampling}` : '';
}

// Chooses the method with the settings of a measured cell.
export async function startFrom(page, cell) {
  await page.locator('#live-method').selectOption(cell.method);
  await page.locator('#live-preset').selectOption(cell.preset);
  return shown(page);
}
