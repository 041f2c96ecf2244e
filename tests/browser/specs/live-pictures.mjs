// Every cell of the run, drawn again in WebGL 2: within 2/255 of the stored image on nearly all pixels, with the same errors. Methods that cannot be run are named on the page with the reason.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { folder, open, results, screenshot } from './browser.mjs';
import { openLive, refusal, startFrom } from './live.mjs';

const index = JSON.parse(fs.readFileSync(path.join(folder, 'values.json'), 'utf8'));
const { least_near: leastNear } = JSON.parse(fs.readFileSync(path.join(folder, 'case.json'), 'utf8'));
const live = JSON.parse(fs.readFileSync(path.join(folder, 'measured/live.json'), 'utf8'));
const stored = (name) => {
  const bytes = fs.readFileSync(index[name].file);
  return new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
};

const { page, complaints } = await open();
await openLive(page);
const text = await page.locator('#live').textContent();

const report = [];
for (const cell of results.cells) {
  const method = live.methods.find(({ id }) => id === cell.method);
  const reason = refusal(method, live, cell.parameters);
  if (reason) {
    test(`${cell.method} is named with the reason why it does not run`, () => {
      const names = [method.label, `${method.label}, preset ${cell.preset}`, cell.id];
      assert.ok(names.some((name) => text.includes(`${name}, ${reason}`)), reason);
    });
    continue;
  }
  test(`${cell.id} is the stored image`, async () => {
    const shown = await startFrom(page, cell);
    const expected = stored(`${cell.id} output`);
    assert.deepEqual([shown.method, shown.filter], [cell.method, cell.filter]);
    assert.equal(shown.output.length, expected.length);
    const off = expected.map((value, i) => Math.abs(value - shown.output[i]));
    const near = off.filter((difference) => difference <= 2 / 255).length / off.length;
    report.push(`${(100 * near).toFixed(3)} % within 2/255, largest difference ${Math.max(...off).toFixed(5)}: ${cell.id}`);
    assert.ok(near >= leastNear, report.at(-1));
    assert.ok(Math.max(...expected) - Math.min(...expected) > 0.1, 'a blank image says nothing');
    assert.ok(Math.abs(shown.errors.rmse - cell.ranked.rmse.value) < 5e-4, `RMSE ${shown.errors.rmse}, ${cell.ranked.rmse.value} stored`);
    assert.ok(Math.abs(shown.errors.rmse_debiased - cell.ranked.rmse_debiased.value) < 5e-4);
    assert.ok(Math.abs(shown.errors.bias - cell.ranked.bias.value) < 5e-4, `bias ${shown.errors.bias}, ${cell.ranked.bias.value} stored`);
  });
}

test('nothing was complained of', async () => {
  fs.writeFileSync(path.join(folder, 'live-pictures.txt'), `${report.sort().join('\n')}\n`);
  await screenshot(page.locator('#live'), 'live');
  assert.deepEqual(complaints, []);
});
