// No table is cut: columns that do not fit are left out, most important ones last, and a chooser brings them back. Every table,
// chart and row of pictures gives its link and its command, and every row of a cell the command of that cell.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open, results } from './browser.mjs';

for (const which of ['measured', 'synthetic', 'odd-names']) {
  for (const width of [390, 1280, 1920]) {
    test(`${which}, ${width} px wide: every table shows whole columns, and the rest can be chosen`, async () => {
      const { page } = await open({ which, viewport: { width, height: 800 } });
      await page.evaluate(() => { for (const details of document.querySelectorAll('main details')) details.open = true; });
      await page.waitForTimeout(300);
      const tables = await page.evaluate(() => [...document.querySelectorAll('.scroll')].filter((box) => box.querySelector('table.numbers') && box.clientWidth > 0).map((box) => {
        const table = box.querySelector('table.numbers');
        const heads = [...table.tHead.querySelectorAll('th')].filter(({ scope }) => scope === 'col');
        const kept = heads.filter((head, i) => !head.hidden && i > 0 && head.dataset.keep !== '0' && table.tBodies[0].rows[0]?.cells[i]?.tagName !== 'TH').length;
        return { name: box.getAttribute('aria-label'), wide: box.scrollWidth - box.clientWidth, kept, shown: heads.filter(({ hidden }) => !hidden).length,
          all: heads.length, chooser: box.previousElementSibling?.matches('.columns') ? box.previousElementSibling.querySelector('summary').textContent : '',
          sticky: [...table.querySelectorAll('tbody th')].every((head) => getComputedStyle(head).position === 'sticky') };
      }));
      assert.ok(tables.length > 5);
      for (const { name, wide, kept, shown, all, chooser, sticky } of tables) {
        assert.ok(sticky || wide <= 1, `${name}: the names of the rows do not stay`);
        assert.ok(wide <= 1 || kept <= 1, `${name} is ${wide} px wider than its place and shows ${shown} of ${all} columns`);
        assert.equal(chooser, shown < all ? `Columns: ${shown} of ${all}` : '', name);
      }
      if (width === 390) assert.ok(tables.some(({ shown, all }) => shown < all));
    });
  }
}

test('a column that was left out is brought back by the chooser, and the error that ranks was never', async () => {
  const { page } = await open({ viewport: { width: 700, height: 800 } });
  const box = page.locator(`#ranking .scroll:has(table[data-view="${results.views[0].key}"])`);
  const head = (text) => box.locator('thead th').filter({ hasText: text });
  assert.equal(await head('PSNR').isVisible(), false);
  assert.equal(await head('RMSE, debiased').isVisible(), true);
  const chooser = box.locator('xpath=preceding-sibling::*[1]');
  await chooser.locator('summary').click();
  await chooser.getByLabel('PSNR').check();
  assert.equal(await head('PSNR').isVisible(), true);
  const at = await head('PSNR').evaluate(({ cellIndex }) => cellIndex);
  assert.equal(await box.locator('tbody tr').first().locator(':scope > *').nth(at).isVisible(), true);
});

test('every table, chart and row of pictures has a link and a command; every cell has its own', async () => {
  const { page } = await open({ which: 'measured' });
  const without = await page.evaluate(() => [...document.querySelectorAll('main .fold :is(.scroll, .chart, .sweep-chart, .thumbnails)')].filter((part) => {
    const place = part.closest('figure') ?? part.nextElementSibling;
    return !part.closest('.live') && place?.querySelectorAll('.copy-buttons button, :scope > button').length !== 2;
  }).map((part) => part.getAttribute('aria-label')));
  assert.deepEqual(without, []);
  const rows = page.locator('#ranking table[data-view] tbody tr');
  for (const row of await rows.all()) {
    const id = await row.getAttribute('data-cell');
    const cell = results.cells.find((other) => other.id === id);
    const view = results.views.find(({ key }) => key === cell.view_key);
    await page.evaluate(() => { navigator.clipboard.writeText = async (text) => { window.copied = text; }; window.copied = ''; });
    await row.locator('.copy-cell').click();
    await page.waitForFunction(() => window.copied);
    const command = await page.evaluate(() => window.copied);
    for (const part of [`score ${view.scene} --view ${view.view}`, `--size ${view.width}x${view.height}`, `--methods ${cell.method}`, `--preset ${cell.preset}`]) {
      assert.ok(command.includes(part), `${command} lacks ${part}`);
    }
  }
});

test('a link to a table unfolds its section and shows it', async () => {
  const { page } = await open({ folded: true, hash: `#${new URLSearchParams({ section: 'failures', part: `Missing and false occlusion on ${results.views[1].key}` })}` });
  const box = page.locator('#failures .scroll').nth(1);
  await box.waitFor();
  await page.waitForFunction(() => Math.abs(document.querySelectorAll('#failures .scroll')[1].getBoundingClientRect().top) < innerHeight / 2);
});
