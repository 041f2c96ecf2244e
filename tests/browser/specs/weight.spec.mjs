// What a reader waits for is small: what is unpacked and shown before anything is touched. Prints the weight and the times of
// each page, and of those that AOSCORE_PAGES names (paths with commas between); times are printed, never asserted.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { test } from 'node:test';
import { open, pages } from './browser.mjs';

const most_bytes = 3e6;
for (const file of process.env.AOSCORE_PAGES?.split(',') ?? []) pages[file] = file;

const without = ['no-pictures', 'index'];  // they have no stage
for (const which of Object.keys(pages).filter((name) => !without.includes(name))) {
  test(`${which} unpacks and shows less than ${most_bytes / 1e6} MB before it is touched`, async () => {
    const { page } = await open({ which, folded: true, viewport: { width: 1280, height: 800 }, init: countInflated });
    await page.waitForTimeout(500);
    const weight = await page.evaluate(() => {
      const paint = performance.getEntriesByName('first-contentful-paint')[0].startTime;
      const { domInteractive } = performance.getEntriesByType('navigation')[0];
      const shown = [...document.images].filter((image) => image.checkVisibility() && image.complete);
      return { inflated: window.inflatedBytes ?? 0, pictures: shown.reduce((sum, { src }) => sum + src.length * 3 / 4, 0),
        nodes: document.querySelectorAll('*').length, height: document.documentElement.scrollHeight,
        paint, script: Number(document.documentElement.dataset.interactive), parsed: domInteractive };
    });
    const start = Date.now();
    await page.locator('.stage').evaluate((stage) => stage.scrollIntoView({ behavior: 'instant' }));
    await page.waitForFunction(() => [...document.querySelectorAll('.pane')].some((pane) => pane.getAttribute('aria-busy') === 'false'));
    const mb = (bytes) => `${(bytes / 1e6).toFixed(2)} MB`;
    console.log(`${which}: file ${mb(fs.statSync(pages[which]).size)}; before it is touched ${mb(weight.pictures)} of pictures and ${mb(weight.inflated)} unpacked; `
      + `${weight.nodes} nodes, ${weight.height} px; first paint ${weight.paint.toFixed(0)} ms, interactive ${weight.script.toFixed(0)} ms, `
      + `parsed ${weight.parsed.toFixed(0)} ms; first picture of the stage ${Date.now() - start} ms after it came into sight`);
    assert.ok(weight.pictures + weight.inflated < most_bytes, `${mb(weight.pictures)} and ${mb(weight.inflated)}`);
  });
}

// Counts what streams unpack. Runs in the page before its own script.
function countInflated() {
  window.inflatedBytes = 0;
  const { pipeThrough } = ReadableStream.prototype;
  ReadableStream.prototype.pipeThrough = function counted(...rest) {
    return pipeThrough.call(pipeThrough.apply(this, rest), new TransformStream({
      transform(chunk, controller) {
        window.inflatedBytes += chunk.byteLength;
        controller.enqueue(chunk);
      },
    }));
  };
}
