// The page looks as it did: coarse pictures of its first screen and of its folded sections, within a tolerance. A run that is
// meant to look otherwise writes them anew with AOSCORE_WRITE_LOOKS=1.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { test } from 'node:test';
import { open } from './browser.mjs';

const file = new URL('looks.json', import.meta.url);
const kept = fs.existsSync(file) ? JSON.parse(fs.readFileSync(file, 'utf8')) : {};
const sizes = [[1280, 800], [1920, 1080], [390, 844]];
const columns = 32;
const rows = 20;
// Gray levels: fonts and their smoothing differ from machine to machine, which moves a cell by a few and a few cells by more.
const usual = { mean: 4, one: 60 };

// Mean luminance of a screenshot in a grid, 0 to 255.
async function grid(page) {
  const picture = (await page.screenshot()).toString('base64');
  return page.evaluate(async ([source, w, h]) => {
    const image = new Image();
    image.src = `data:image/png;base64,${source}`;
    await image.decode();
    const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
    const context = canvas.getContext('2d', { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const sums = Array(w * h).fill(0);
    const counts = Array(w * h).fill(0);
    for (let y = 0, i = 0; y < image.height; y += 1) {
      for (let x = 0; x < image.width; x += 1, i += 4) {
        const cell = Math.floor(y * h / image.height) * w + Math.floor(x * w / image.width);
        sums[cell] += 0.2126 * data[i] + 0.7152 * data[i + 1] + 0.0722 * data[i + 2];
        counts[cell] += 1;
      }
    }
    return sums.map((sum, i) => Math.round(sum / counts[i]));
  }, [picture, columns, rows]);
}

for (const [width, height] of sizes) {
  for (const colorScheme of ['light', 'dark']) {
    test(`${width} px wide, ${colorScheme}`, async () => {
      const { page } = await open({ which: 'synthetic', folded: true, viewport: { width, height }, colorScheme, reducedMotion: 'reduce' });
      await page.locator('.small-cost-chart').first().scrollIntoViewIfNeeded();
      await page.locator('.small-cost-chart canvas').first().waitFor();
      const places = { first: () => scrollTo({ top: 0, behavior: 'instant' }),
        folded: () => document.getElementById('measurement').scrollIntoView({ block: 'end', behavior: 'instant' }) };
      for (const [place, scroll] of Object.entries(places)) {
        await page.evaluate(scroll);
        await page.waitForTimeout(400);
        if (place === 'folded') {
          await page.waitForFunction(() => [...document.querySelectorAll('.pane')].every((pane) => pane.getAttribute('aria-busy') === 'false'));
        }
        const name = `${place} ${width} ${colorScheme}`;
        const seen = await grid(page);
        if (process.env.AOSCORE_WRITE_LOOKS) {
          kept[name] = seen;
          continue;
        }
        assert.ok(kept[name], `looks.json lacks ${name}`);
        const off = seen.map((value, i) => Math.abs(value - kept[name][i]));
        const mean = off.reduce((sum, value) => sum + value, 0) / off.length;
        assert.ok(mean <= usual.mean && Math.max(...off) <= usual.one, `${name}: off by ${mean.toFixed(1)} in the mean and ${Math.max(...off)} at most`);
      }
    });
  }
}

test('every look that is kept is one that is compared', () => {
  if (process.env.AOSCORE_WRITE_LOOKS) fs.writeFileSync(file, `${JSON.stringify(kept).replaceAll('],', '],\n')}\n`);
  assert.equal(Object.keys(kept).length, 2 * 2 * sizes.length);
});
