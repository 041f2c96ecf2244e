// The page's values are the EXR files' within the stated quantisation: all of them as unpacked, and some as the
// inspector writes them.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { choose, folder, open, results } from './browser.mjs';

const index = JSON.parse(fs.readFileSync(path.join(folder, 'values.json'), 'utf8'));
function exr(name) {
  const bytes = fs.readFileSync(index[name].file);
  return new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
}

const { page } = await open();
const stageData = await page.evaluate(() => JSON.parse(document.getElementById('stage-data').textContent));

// Reads every number from the inspector; the pointer goes to the middle of the pixel.
async function inspect(x, y) {
  const canvas = page.locator('.pane canvas').first();
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const [view] = stageData.views;
  await page.mouse.move(box.x + (x + 0.5) / view.width * box.width, box.y + (y + 0.5) / view.height * box.height);
  await page.waitForFunction(([u, v]) => document.querySelector('.pixel-place').textContent === `Pixel ${u}, ${v}`, [x, y]);
  // The first pixel waits until the images are unpacked.
  await page.locator('.inspector tbody tr').first().waitFor();
  await page.waitForTimeout(120);
  const rows = await page.locator('.inspector tbody tr').evaluateAll((list) => list.map((row) => [...row.cells].map((cell) => cell.textContent)));
  return new Map(rows.map(([name, ...rest]) => [name, rest]));
}
const number = (text) => Number(text.replace('−', '-').replace(/[^\d.+-]/g, ''));

test('states its quantisation', async () => {
  const { step } = stageData.views[0].images.truth;
  assert.equal(step, 1 / 65534);
  assert.match(await page.locator('.inspector-note').textContent(), /steps of 1\/65534: .* half a step/);
});

const places = [[0, 0], [159, 95], [80, 48], [13, 77], [103, 23], [140, 48]];
for (const [x, y] of places) {
  test(`pixel ${x}, ${y} reads as in the EXR files`, async () => {
    const rows = await inspect(x, y);
    const [view] = stageData.views;
    const i = x + y * view.width;
    const truth = exr(`${view.key} truth`)[i];
    const near = (text, value, step) => assert.ok(Math.abs(number(text) - value) <= step / 2 + 0.5e-5 + 1e-9, `${text} is not ${value}`);
    near(rows.get('Truth')[0], truth, view.images.truth.step);
    const valid = exr(`${view.key} mask`)[i] > 0.5;
    if (valid) assert.ok(Math.abs(number(rows.get('Truth')[1]) - exr(`${view.key} noise`)[i]) <= view.images.noise.step / 2 + 0.0005);
    else assert.equal(rows.get('Truth')[1], 'not compared');
    let compared = 0;
    for (const cell of view.cells) {
      for (const kind of Object.keys(cell.images)) {
        const row = rows.get(kind === 'raw' ? `${cell.name}, raw` : cell.name);
        const value = exr(`${cell.id} ${kind}`)[i];
        near(row[0], value, cell.images[kind].step);
        if (valid) near(row[1], value - truth, 2 * cell.images[kind].step);
        compared += 1;
      }
    }
    const parts = [...stageData.causes.map(({ id, label }) => [id, `Occluded: ${label}`]), ['one_layer', 'Occluded, in one layer']];
    assert.equal(parts.length, 5);
    for (const [id, name] of parts) {
      const { step } = view.images[id];
      assert.ok(Math.abs(number(rows.get(name)[0]) - exr(`${view.key} ${id}`)[i]) <= step / 2 + 0.0005 + 1e-9, name);
    }
    assert.equal(compared, results.cells.filter((cell) => cell.view_key === view.key).length * 2);
    if (valid) assert.ok(Math.abs(number(rows.get('Depth')[0]) - exr(`${view.key} depth`)[i]) <= view.images.depth.step / 2 + 0.0005);
  });
}

test('an error painted red is where the output is brighter than the truth', async () => {
  const [view] = stageData.views;
  const [cell] = view.cells;
  await choose(page, `cell-${view.key}`, cell.id);
  await choose(page, 'picture', 'error');
  await choose(page, 'mode', 'alone');
  const canvas = page.locator('.pane canvas');
  const [truth, output, mask] = [exr(`${view.key} truth`), exr(`${cell.id} output`), exr(`${view.key} mask`)];
  const colours = await canvas.evaluate((element, [w, h]) => {
    const context = element.getContext('2d');
    const list = [];
    for (let y = 0; y < h; y += 1) {
      for (let x = 0; x < w; x += 1) {
        const at = [(x + 0.5) / w * element.width, (y + 0.5) / h * element.height].map(Math.floor);
        list.push([...context.getImageData(...at, 1, 1).data]);
      }
    }
    return list;
  }, [view.width, view.height]);
  let red = 0;
  let blue = 0;
  colours.forEach(([r, g, b], i) => {
    const error = output[i] - truth[i];
    if (mask[i] <= 0.5) return assert.deepEqual([r, g, b], [0x6f, 0x6f, 0x76]);
    if (error > 0.02) { red += 1; assert.ok(r > b, `${i}: ${error} is ${r} ${g} ${b}`); }
    if (error < -0.02) { blue += 1; assert.ok(b > r, `${i}: ${error} is ${r} ${g} ${b}`); }
    return undefined;
  });
  assert.ok(red > 100 && blue > 100, `${red} red, ${blue} blue`);
});
