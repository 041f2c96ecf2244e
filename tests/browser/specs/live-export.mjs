// Changes a method on the page in every way that its export knows, and leaves the page's exports for the program:
// live.json, the preset; live-command.txt; live.f32, the picture.
import fs from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { folder, open } from './browser.mjs';
import { openLive, shown } from './live.mjs';

test('the page gives out a changed setting', async () => {
  const { page } = await open();
  await openLive(page);
  await page.locator('#live-method').selectOption('my-ssao');
  await page.locator('#live-preset').selectOption('quality');
  const number = (name) => page.locator(`.live-method-parameters [aria-label^="${name}, exact"]`);
  await number('samples').fill('23');
  await number('radius').fill('0.4321');
  await page.locator('.live-method-parameters [name=noise]').selectOption('hash');
  await page.locator('.live-method-parameters [name=kernel_scale]').selectOption('squared_of_64');
  await page.locator('#live-border').selectOption('clamp');
  await page.locator('#live-filtered').check();
  await page.locator('.live-controls [name=filter]').selectOption('gaussian-depth');
  await page.locator('.live-filter-parameters [aria-label^="taps, exact"]').fill('2');
  const { output } = await shown(page);
  fs.writeFileSync(path.join(folder, 'preset.json'), await page.locator('#live-preset-text').inputValue());
  fs.writeFileSync(path.join(folder, 'command.txt'), await page.locator('#live-command-text').inputValue());
  fs.writeFileSync(path.join(folder, 'live.f32'), new Uint8Array(Float32Array.from(output).buffer));
});
