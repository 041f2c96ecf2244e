// An index of 10,000 cells answers at once: it filters, sorts, leads from a scene's error to its cells, and says what failed.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { test } from 'node:test';
import { open, require, screenshot } from './browser.mjs';

const axe = fs.readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
const openIndex = (more) => open({ which: 'index', folded: true, ...more });
const shown = (page) => page.locator('.filters output').textContent();

// Prints how long the page takes to answer and to lay itself out anew; times are never asserted.
async function timed(page, name, act) {
  const ms = await page.evaluate((source) => {
    const start = performance.now();
    new Function(source)();
    document.body.getBoundingClientRect();
    return performance.now() - start;
  }, act);
  console.log(`${name}: ${ms.toFixed(0)} ms`);
}
const clickHead = (name) => `[...document.querySelectorAll('.cells thead button')].find(({ textContent }) => textContent === '${name}').click()`;
const setInput = (name, value) => `const input = document.querySelector('.filters').elements['${name}']; input.value = '${value}'; input.dispatchEvent(new Event('input', { bubbles: true }))`;

test('cells are filtered, sorted and unfolded', async () => {
  const { page, complaints } = await openIndex({});
  console.log(`${fs.statSync(new URL(page.url())).size} bytes, interactive after ${await page.evaluate(() => document.documentElement.dataset.interactive)} ms`);
  assert.equal(await shown(page), '200 of 10000 cells are shown');
  await timed(page, 'a word', setInput('text', 'scene-042/view-3'));
  assert.equal(await shown(page), '25 of 25 cells are shown');
  await page.locator('.cells thead').getByRole('button', { name: 'RMSE, debiased', exact: true }).click();
  const errors = await page.locator('.cells tbody tr:not(.failed)').evaluateAll((rows) => rows.map((row) => Number(row.cells[4].textContent)));
  assert.deepEqual(errors, [...errors].sort((a, b) => a - b));
  assert.equal(await page.locator('.cells tbody tr th').first().textContent(), 'Method 0, default, box-4x4');
  await page.getByLabel('Contains').fill('');
  await page.locator('.filters [name=only]').selectOption('failed');
  assert.equal(await shown(page), '100 of 100 cells are shown');
  assert.match(await page.locator('.cells tbody tr').first().textContent(), /failed: 7 pixels are NaN/);
  await timed(page, 'all cells', setInput('only', ''));
  await timed(page, 'all cells by their error', clickHead('RMSE, debiased'));
  await timed(page, 'all cells by their view', clickHead('Scene'));
  await page.getByRole('button', { name: 'Show 200 more' }).click();
  assert.equal(await shown(page), '400 of 10000 cells are shown');
  assert.deepEqual(complaints, []);
});

test('the error of a method on a scene is that of its views, and leads to its cells', async () => {
  const { page } = await openIndex({});
  const { cells, views } = JSON.parse(await page.locator('#index-data').textContent());
  const squares = cells.filter(([view, contestant]) => views[view].scene === 'scene-007' && contestant === 3).map((cell) => cell[2] ** 2);
  const expected = Math.sqrt(squares.reduce((sum, square) => sum + square, 0) / squares.length);
  const button = page.getByRole('button', { name: 'Method 3, default, box-4x4 on scene-007' }).or(page.locator('button[title="Method 3, default, box-4x4 on scene-007"]')).first();
  assert.equal(await button.textContent(), expected.toFixed(4));
  await button.click();
  assert.equal(await shown(page), '4 of 4 cells are shown');
});

for (const [width, height] of [[1280, 800], [390, 844]]) {
  for (const colorScheme of ['light', 'dark']) {
    test(`${width} px wide, ${colorScheme}: axe-core finds no fault, and nothing is wider than the window`, async () => {
      const { page, complaints } = await openIndex({ viewport: { width, height }, colorScheme });
      // Axe takes minutes over 2,500 numbers of the matrix: some of its rows tell as much.
      await page.evaluate(() => { for (const row of [...document.querySelectorAll('.matrix tbody tr, .cells tbody tr')]) if (row.rowIndex > 3) row.remove(); });
      await page.evaluate(axe);
      const found = await page.evaluate(async () => (await axe.run(document, { resultTypes: ['violations'] })).violations.map(({ id, nodes }) => `${id}: ${nodes[0].target}`));
      assert.deepEqual(found, []);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
      await screenshot(page, `index-${width}-${colorScheme}`);
      assert.deepEqual(complaints, []);
    });
  }
}
