// The section of live parameters: every kind of control, its exports, and its message where it cannot run.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { folder, open, require, results, screenshot } from './browser.mjs';
import { openLive, refusal, shown, startFrom } from './live.mjs';

const index = JSON.parse(fs.readFileSync(path.join(folder, 'values.json'), 'utf8'));
const exr = (name) => {
  const bytes = fs.readFileSync(index[name].file);
  return new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
};
const cellOf = (method, view) => results.cells.find((cell) => cell.method === method && cell.view_key === view);
const [first, second] = results.views.map(({ key }) => key);
const nearShare = (a, b) => a.filter((value, i) => Math.abs(value - b[i]) <= 2 / 255).length / a.length;

const { page, complaints } = await open();
const slider = (name) => page.locator(`.live-method-parameters input[type=range][name=${name}]`);
const number = (name) => page.locator(`.live-method-parameters [aria-label^="${name}, exact"]`);

test('nothing is unpacked before the section is opened, by keyboard as well', async () => {
  assert.equal(await page.locator('.live-bench').isHidden(), true);
  assert.equal(await page.evaluate(() => document.querySelector('details.live').shown), undefined);
  await page.locator('details.live summary').focus();
  await page.keyboard.press('Enter');
  await shown(page);
  assert.equal(await page.locator('.live-bench').isVisible(), true);
});

test('a preview of fewer pixels comes before the first picture, and looks like it', async () => {
  const { preview, full } = await page.evaluate(() => {
    const { preview: small, shown: large } = document.querySelector('details.live');
    return { preview: { width: small.width, height: small.height, output: [...small.output] }, full: { width: large.view.width, output: [...large.output] } };
  });
  assert.deepEqual([preview.width, preview.height], [54, 32]);
  // Each pixel of the preview stands for a square of 3 x 3 pixels.
  const rows = full.output.length / full.width;
  const middle = preview.output.map((value, i) => {
    const [x, y] = [3 * (i % preview.width), 3 * Math.floor(i / preview.width)];
    const square = [0, 1, 2].flatMap((v) => [0, 1, 2].map((u) => full.output[Math.min(y + v, rows - 1) * full.width + Math.min(x + u, full.width - 1)]));
    return square.reduce((sum, one) => sum + one, 0) / square.length;
  });
  const mean = (list) => list.reduce((sum, value) => sum + value, 0) / list.length;
  assert.ok(Math.abs(mean(preview.output) - mean(middle)) < 0.05, `${mean(preview.output)} beside ${mean(middle)}`);
  const spread = (a, b) => mean(a.map((value, i) => (value - mean(a)) * (b[i] - mean(b))));
  const likeness = (a, b) => spread(a, b) / Math.sqrt(spread(a, a) * spread(b, b));
  const mirrored = middle.map((_, i) => middle[i - i % preview.width + preview.width - 1 - i % preview.width]);
  const [right, wrong] = [likeness(preview.output, middle), likeness(preview.output, mirrored)];
  assert.ok(right > 0.5 && right > wrong + 0.2, `correlation ${right}, with the mirrored picture ${wrong}`);
});

test('a slider moves the value, the picture and the error, by keyboard as well', async () => {
  const before = await startFrom(page, cellOf('hbao', first));
  await slider('radius').focus();
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('PageUp');
  const after = await shown(page);
  assert.ok(after.parameters.radius > before.parameters.radius);
  assert.equal(await number('radius').inputValue(), String(after.parameters.radius));
  assert.notEqual(after.errors.rmse, before.errors.rmse);
  assert.match(await page.locator('.live-status').textContent(), new RegExp(`RMSE ${after.errors.rmse.toFixed(4)} over \\d+ valid pixels`));
  const cells = await page.locator('.live-errors tbody tr').evaluateAll((rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));
  assert.equal(cells[0][1], after.errors.rmse.toFixed(4));
  assert.equal(cells[1][1], cellOf('hbao', first).ranked.rmse.value.toFixed(4));
});

test('a number takes the whole range and nothing else', async () => {
  await number('radius').fill('0.7321');
  assert.equal((await shown(page)).parameters.radius, 0.7321);
  await number('radius').fill('-3');
  assert.equal((await shown(page)).parameters.radius, 0.7321);
  assert.equal(await number('radius').evaluate((input) => input.checkValidity()), false);
  await page.locator('[data-does=reset]').click();
  const reset = await shown(page);
  assert.equal(reset.parameters.radius, cellOf('hbao', first).parameters.radius);
  assert.equal(await number('radius').evaluate((input) => input.checkValidity()), true);
});

test('without its filter a method gives what the run kept as raw, with another filter something else', async () => {
  const cell = cellOf('ssao', first);
  const filtered = await startFrom(page, cell);
  await page.locator('#live-filtered').uncheck();
  const raw = await shown(page);
  assert.equal(raw.filter, 'none');
  assert.ok(nearShare(raw.output, exr(`${cell.id} raw`)) >= 0.99);
  assert.ok(nearShare(raw.output, filtered.output) < 0.9);
  await page.locator('#live-filtered').check();
  await page.locator('.live-controls [name=filter]').selectOption('normal-depth');
  assert.equal((await shown(page)).filter, 'normal-depth');
  await page.locator('.live-filter-parameters [aria-label^="taps, exact"]').fill('1');
  await shown(page);
  assert.equal(await page.locator('.live-filter-note').isVisible(), true);
});

test('every method and every preset runs', async () => {
  const methods = await page.locator('#live-method option').evaluateAll((options) => options.map(({ value }) => value));
  const live = JSON.parse(fs.readFileSync(path.join(folder, 'measured/live.json'), 'utf8'));
  const registry = live.methods;
  const lengths = live.views[await page.locator('#live-view').inputValue()].method_lengths;
  assert.deepEqual(methods, registry.filter((method) => !refusal(method, live)).map(({ id }) => id));
  for (const method of registry.filter((method) => !refusal(method, live))) {
    await page.locator('#live-method').selectOption(method.id);
    for (const preset of Object.keys(method.presets).filter((name) => !refusal(method, live, method.presets[name]))) {
      await page.locator('#live-preset').selectOption(preset);
      const { output, parameters } = await shown(page);
      assert.deepEqual(parameters, { ...method.presets[preset], ...lengths[method.id]?.[preset] }, `${method.id} ${preset}`);
      assert.ok(output.every((value) => value >= 0 && value <= 1), `${method.id} ${preset}`);
    }
  }
});

test('the values stay when the view changes', async () => {
  await startFrom(page, cellOf('alchemy', first));
  await number('radius').fill('0.3');
  await shown(page);
  await page.locator('#live-view').selectOption(second);
  const there = await shown(page);
  assert.equal(there.parameters.radius, 0.3);
  await page.locator('[data-does=reset]').click();
  assert.ok(nearShare((await shown(page)).output, exr(`${cellOf('alchemy', second).id} output`)) >= 0.995);
});

test('the picture under the pointer is read', async () => {
  const { output } = await shown(page);
  const canvas = page.locator('.live-output');
  const truth = exr(`${second} truth`)[40 + 30 * 160];
  const said = `Pixel 40, 30: live ${output[40 + 30 * 160].toFixed(4)}, truth ${truth.toFixed(4)}`;
  // Charts above are drawn when they come near, and may move the picture: the pointer then moves again.
  for (let attempt = 0; ; attempt += 1) {
    const { width, height } = await canvas.boundingBox();
    await canvas.hover({ position: { x: width * 40.5 / 160, y: height * 30.5 / 96 } });  // waits until it stands still
    const text = await page.locator('.live-probe').textContent();
    if (text.startsWith('Pixel 40, 30:') || attempt === 20) {
      assert.ok(text.startsWith(said), `${text} is not ${said}`);
      break;
    }
    await page.waitForTimeout(100);
  }
});

test('the preset can be downloaded and copied', async () => {
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator('[data-does=download]').click()]);
  assert.equal(download.suggestedFilename(), 'alchemy-live.json');
  const text = fs.readFileSync(await download.path(), 'utf8');
  assert.equal(text, `${await page.locator('#live-preset-text').inputValue()}\n`);
  assert.ok(JSON.parse(text).presets.live);
  const copy = page.locator('[data-of=live-command-text]');
  // The button shows it for only two seconds, so every change of its text is recorded.
  const heard = copy.evaluate((button) => new Promise((resolve) => {
    new MutationObserver(() => resolve(button.textContent)).observe(button, { childList: true });
  }));
  await copy.click();
  assert.match(await heard, /Copied|Selected/);
});

test('it is accessible, light and dark, and no wider than a phone', async () => {
  await page.addScriptTag({ path: require.resolve('axe-core/axe.min.js') }).catch(async () => {
    await page.evaluate(fs.readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8'));
  });
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    const { violations } = await page.evaluate(() => axe.run('#live'));
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`), []);
    await screenshot(page.locator('#live'), `live-${colorScheme}`);
  }
  await page.setViewportSize({ width: 375, height: 800 });
  await page.waitForFunction(() => document.documentElement.scrollWidth <= 375);  // charts follow the width later
  await screenshot(page.locator('#live'), 'live-phone');
});

test('nothing was complained of', () => assert.deepEqual(complaints, []));

for (const [what, script, sentence] of [
  ['WebGL 2', 'HTMLCanvasElement.prototype.getContext = () => null;', /has no WebGL 2/],
  ['float targets', 'WebGL2RenderingContext.prototype.getExtension = () => null;', /32-bit floats \(EXT_color_buffer_float\)/],
]) {
  test(`without ${what} a sentence says so`, async () => {
    const { page: other } = await open();
    await other.evaluate(script);
    await assert.rejects(openLive(other), sentence);
    assert.match(await other.locator('.live-failure').textContent(), sentence);
  });
}

test('a lost context is told', async () => {
  const { page: other } = await open();
  await other.evaluate(() => {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function kept(...all) {
      const context = getContext.apply(this, all);
      if (all[0] === 'webgl2') window.live = context;
      return context;
    };
  });
  await openLive(other);
  await other.evaluate(() => window.live.getExtension('WEBGL_lose_context').loseContext());
  await other.waitForFunction(() => /gave up/.test(document.querySelector('.live-failure').textContent));
});
