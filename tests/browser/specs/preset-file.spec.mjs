// A file of presets, as tune writes it, runs in the section of live parameters like the method's own; a bad one is told in words.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { folder, open, results } from './browser.mjs';
import { openLive, shown } from './live.mjs';

const live = JSON.parse(fs.readFileSync(path.join(folder, 'measured/live.json'), 'utf8'));
const { page, complaints } = await open();
await openLive(page);
const key = await page.locator('#live-view').inputValue();
const { radius_m } = results.views.find((view) => view.key === key);
const hbao = live.methods.find(({ id }) => id === 'hbao');
const number = (name) => page.locator(`.live-method-parameters [aria-label^="${name}, exact"]`);
const choose = (name, content) => page.locator('#live-file').setInputFiles(
  { name, mimeType: 'application/json', buffer: Buffer.from(typeof content === 'string' ? content : JSON.stringify(content)) });
// A file is read some time after it is chosen.
const taken = async (name, content) => {
  await choose(name, content);
  await page.waitForFunction((file) => document.querySelector('#live-preset').value.endsWith(`(${file})`), name);
};
const failure = page.locator('.live-file-failure');

test('a chosen file brings its method, its values and its filter', async () => {
  await page.locator('#live-method').selectOption('alchemy');
  await shown(page);
  await taken('hbao.tuned.json', { method: 'hbao', presets: { tuned: { bias: 0.1, steps: 7 } }, preset_filters: { tuned: 'gaussian-depth' }, tunings: {} });
  const { method, parameters, filter } = await shown(page);
  assert.equal(method, 'hbao');
  assert.equal(filter, 'gaussian-depth');
  assert.deepEqual(parameters, { ...hbao.presets.default, ...live.views[key].method_lengths.hbao.default, bias: 0.1, steps: 7 });
  assert.equal(parameters.radius, radius_m);
  assert.equal(await page.locator('#live-preset').inputValue(), 'tuned (hbao.tuned.json)');
});

test('its lengths follow the radius of the view as those of a preset of the method do', async () => {
  const alchemy = live.methods.find(({ id }) => id === 'alchemy');
  const { radius, sigma } = alchemy.presets.default;
  await taken('alchemy.tuned.json', { method: 'alchemy', presets: { twice: { radius: 2 * radius, sigma: 2 * sigma } } });
  const { parameters } = await shown(page);
  assert.equal(parameters.radius, radius_m);
  assert.ok(Math.abs(parameters.sigma - sigma * radius_m / radius) < 1e-12, `${parameters.sigma}`);
  await taken('absolute.json', { method: 'alchemy', presets: { metres: { radius: 0.7, sigma: 0.2 } }, absolute_presets: { metres: 'a source' } });
  const absolute = (await shown(page)).parameters;
  assert.deepEqual([absolute.radius, absolute.sigma], [0.7, 0.2]);
});

test('a file that is dropped is taken, and one that the section gave out is its method again', async () => {
  await page.locator('#live-method').selectOption('hbao');
  await shown(page);
  await number('bias').fill('0.25');
  const before = await shown(page);
  const text = await page.locator('#live-preset-text').inputValue();
  await page.locator('[data-does=reset]').click();
  await shown(page);
  const transfer = await page.evaluateHandle((content) => {
    const data = new DataTransfer();
    data.items.add(new File([content], 'hbao-live.json', { type: 'application/json' }));
    return data;
  }, text);
  await page.locator('.live-controls').dispatchEvent('drop', { dataTransfer: transfer });
  await page.waitForFunction(() => document.querySelector('#live-preset').value === 'live (hbao-live.json)');
  const after = await shown(page);
  assert.deepEqual(after.parameters, before.parameters);
  assert.deepEqual(after.output, before.output);
});

for (const [what, content, words] of [
  ['no JSON', 'method: hbao', /was not taken\. It is no JSON/],
  ['no object', '[1, 2]', /holds no presets/],
  ['no presets', { method: 'hbao' }, /holds no presets/],
  ['an unknown method', { method: 'nonsense', presets: { a: {} } }, /for the method "nonsense".* it runs .*alchemy/],
  ['an unknown parameter', { method: 'hbao', presets: { a: { nonsense: 1 } } }, /names nonsense, which HBAO does not have; it has bias, directions, /],
  ['a value out of range', { method: 'hbao', presets: { a: { steps: 1.5 } } }, /steps = 1\.5, which must be a whole number from 1 to 512/],
  ['an unknown choice', { method: 'hbao', presets: { a: { noise: '<b>' } } }, /noise = "<b>", which must be one of tiled_4x4/],
  ['an unknown filter', { method: 'hbao', presets: { a: {} }, preset_filters: { a: 'nonsense' } }, /filter nonsense \(default\), which this page does not run/],
  ['too large a file', ' '.repeat(2 ** 20 + 1), /has 1048577 bytes/],
]) {
  test(`${what} is refused in words, and changes nothing`, async () => {
    const before = await page.evaluate(() => [document.querySelector('#live-method').value, document.querySelector('#live-preset').innerHTML]);
    await choose('bad.json', content);
    await failure.waitFor({ state: 'visible' });
    assert.match(await failure.textContent(), words);
    assert.deepEqual(await page.evaluate(() => [document.querySelector('#live-method').value, document.querySelector('#live-preset').innerHTML]), before);
    await choose('good.json', { method: 'hbao', presets: { good: {} } });
    await shown(page);
    await failure.waitFor({ state: 'hidden' });
  });
}

test('nothing was complained of', () => assert.deepEqual(complaints, []));
