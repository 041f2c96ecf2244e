// axe-core finds no fault, in both colour schemes, on desktops and on a phone, folded and unfolded; nothing is
// wider than the window.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { test } from 'node:test';
import { choose, open, require, screenshot, startStage, unfoldAll } from './browser.mjs';

const axe = fs.readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
const sizes = { desk: { width: 1280, height: 800 }, large: { width: 1920, height: 1080 }, phone: { width: 390, height: 844 } };

async function violations(page) {
  const { violations: found } = await page.evaluate(() => axe.run(document, { resultTypes: ['violations'] }));
  return found.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ target }) => target.join(' ')).join(', ')}`);
}

for (const which of ['measured', 'synthetic']) {
  for (const [place, viewport] of Object.entries(sizes)) {
    for (const colorScheme of ['light', 'dark']) {
      test(`${which}, ${place}, ${colorScheme}`, async () => {
        const { page, complaints } = await open({ which, viewport, colorScheme, folded: true });
        await page.evaluate(axe);
        assert.deepEqual(await violations(page), []);
        await screenshot(page, `${which}-${place}-${colorScheme}`);
        await unfoldAll(page);
        await startStage(page);
        if (which === 'measured') await choose(page, 'picture', 'error');
        await page.locator('.pane canvas').first().hover();
        await page.evaluate(async () => {
          for (const details of document.querySelectorAll('details')) details.open = true;
          for (let y = 0; y < document.body.scrollHeight; y += 500) {
            scrollTo({ top: y, behavior: 'instant' });
            await new Promise((resolve) => { setTimeout(resolve, 30); });
          }
          scrollTo({ top: 0, behavior: 'instant' });
        });
        assert.deepEqual(await violations(page), []);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        assert.ok(wide <= 0, `the page is ${wide} px wider than the window`);
        const small = await page.evaluate(() => [...document.querySelectorAll('body *')].filter((element) => element.checkVisibility?.()
          && [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim())
          && parseFloat(getComputedStyle(element).fontSize) < 12 && element.tagName !== 'SUP').map(({ tagName, className }) => `${tagName}.${className}`));
        assert.deepEqual([...new Set(small)], [], 'type smaller than 12 px');
        assert.deepEqual(complaints, []);
        await page.locator('.stage').evaluate((stage) => stage.scrollIntoView({ behavior: 'instant' }));
        await page.waitForTimeout(300);
        await screenshot(page, `${which}-${place}-${colorScheme}-stage`);
      });
    }
  }
}
