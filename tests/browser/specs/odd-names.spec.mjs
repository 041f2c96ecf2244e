// Names of any length, direction and content are shown, not run, and push nothing out of the window; one method makes a page,
// and so do results without pictures.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { layers, open, screenshot, startStage, unfoldAll } from './browser.mjs';

for (const width of [1280, 390]) {
  test(`odd names are read and not run, ${width} px wide`, async () => {
    const { page, complaints } = await open({ which: 'odd-names', folded: true, viewport: { width, height: 800 } });
    const dialogs = [];
    page.on('dialog', (dialog) => { dialogs.push(dialog.message()); dialog.dismiss(); });
    await screenshot(page, `odd-names-${width}`);
    for (const tab of await page.locator('.view-tabs button').all()) await tab.click();
    await unfoldAll(page);
    await startStage(page);
    await page.evaluate(async () => {
      for (let y = 0; y < document.body.scrollHeight; y += 400) {
        scrollTo({ top: y, behavior: 'instant' });
        await new Promise((resolve) => { setTimeout(resolve, 30); });
      }
    });
    const text = await page.locator('main').textContent();
    for (const name of ["<script>document.title = 'owned'</script>", 'חסימת אור סביבתי', 'N'.repeat(200), '{{lead}}']) assert.ok(text.includes(name), name);
    assert.match(await page.title(), /^aoscore: /);
    assert.equal(await page.locator('img[src="x"]').count(), 0);
    assert.deepEqual([dialogs, complaints], [[], []]);
    const wide = await page.evaluate(() => [document.documentElement.scrollWidth, ...[...document.querySelectorAll('body *')]
      .filter((element) => !element.closest('.scroll, .view-tabs, nav') && element.getBoundingClientRect().right > innerWidth + 1)
      .map(({ tagName, className }) => `${tagName}.${className}`)]);
    assert.deepEqual(wide, [width]);
  });
}

test('one method on one view has a verdict, pictures and a stage, and no switch', async () => {
  const { page, complaints } = await open({ which: 'one-method', folded: true, viewport: { width: 1280, height: 800 } });
  assert.match(await page.locator('.verdict').textContent(), /is the only method scored on/);
  assert.ok(await page.locator('.look .strip img').count() >= 3);
  assert.equal(await page.locator('.view-tabs').count(), 0);
  await unfoldAll(page);
  await startStage(page);
  assert.equal((await layers(page)).length, 2);
  assert.deepEqual(complaints, []);
});

for (const width of [1280, 390]) {
  test(`results without pictures have a verdict, rankings and charts, and no stage, ${width} px wide`, async () => {
    const { page, complaints } = await open({ which: 'no-pictures', folded: true, viewport: { width, height: 800 } });
    assert.match(await page.locator('.verdict').textContent(), /closest/);
    await unfoldAll(page);
    for (const section of ['ranking', 'cost', 'failures', 'distributions', 'measurement']) assert.equal(await page.locator(`#${section}`).count(), 1, section);
    assert.equal(await page.locator('.stage, #pictures, #live').count(), 0);
    for (const chart of await page.locator('.cost-chart, .cumulative-chart').all()) {
      await chart.scrollIntoViewIfNeeded();
      await chart.locator('canvas').first().waitFor();
      await chart.click();
    }
    await screenshot(page, `no-pictures-${width}`);
    assert.deepEqual(complaints, []);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
  });
}
