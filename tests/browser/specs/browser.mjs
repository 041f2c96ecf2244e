// Opens pages of a small run in Chromium for all specs, with the browser's complaints and requests.
import { createRequire } from 'node:module';
import fs from 'node:fs';
import path from 'node:path';
import { after } from 'node:test';
import { pathToFileURL } from 'node:url';

export const require = createRequire(path.join(process.env.AOSCORE_DATA, 'package.json'));
const { chromium } = require('playwright-core');

export const folder = process.env.AOSCORE_TEST_FOLDER;
export const pages = Object.fromEntries(['measured', 'synthetic', 'odd-names', 'one-method', 'no-pictures', 'index']
  .map((name) => [name, path.join(folder, name, 'index.html')]));
export const results = JSON.parse(fs.readFileSync(path.join(folder, 'measured/results.json'), 'utf8'));

const browser = await chromium.launch({
  executablePath: '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--disable-background-networking'],
});
after(() => browser.close());

// Opens a page, unfolds all of it unless it is to stay `folded`, and waits until its stage shows pictures; `init` runs before the page's script. `complaints`
// gathers console and script errors, `requests` every address asked for beside the page's own.
export async function open({ which = 'measured', hash = '', folded = false, init = null, ...context } = {}) {
  const view = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...context });
  view.setDefaultTimeout(120000);  // slow machines compile shaders and draw charts too
  const page = await view.newPage();
  const complaints = [];
  const requests = [];
  page.on('console', (message) => {
    const ours = message.text().includes('willReadFrequently');  // specs read canvases, the page never does
    if (['error', 'warning'].includes(message.type()) && !ours) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => requests.push(request.url().split('#')[0]));
  const address = pathToFileURL(pages[which]).href;
  if (init) await page.addInitScript(init);
  await page.goto(address + hash);
  if (!folded) {
    await unfoldAll(page);
    if (await page.locator('.stage').count() > 0) await startStage(page);
    if (hash === '') await page.evaluate(() => scrollTo({ top: 0, behavior: 'instant' }));
  }
  return { page, complaints, requests, address };
}

// Unfolds every section, and waits until they are built.
export async function unfoldAll(page) {
  await page.evaluate(() => { for (const fold of document.querySelectorAll('.fold')) fold.open = true; });
  await page.waitForFunction(() => !document.querySelector('.fold > noscript'));
}

// The stage unpacks its pictures when it comes into sight.
export async function startStage(page) {
  await page.locator('.stage').evaluate((stage) => stage.scrollIntoView({ behavior: 'instant' }));
  await settled(page);
}

// Waits until every pane has painted its picture.
export async function settled(page) {
  await page.waitForFunction(() => {
    const panes = [...document.querySelectorAll('.pane')];
    return document.documentElement.dataset.scriptError
      || (panes.length > 0 && panes.every((pane) => pane.getAttribute('aria-busy') === 'false'));
  });
  await page.evaluate(() => new Promise((resolve) => { requestAnimationFrame(() => requestAnimationFrame(resolve)); }));
}

export async function choose(page, name, value) {
  await page.locator(`.choosers input[name="${name}"][value="${value}"]`).check();
  await settled(page);
}

export async function screenshot(target, name) {
  await target.screenshot({ path: path.join(folder, `${name}.png`) });
}

// The keys of the layers that the panes show.
export function layers(page) {
  return page.locator('.pane').evaluateAll((panes) => panes.map((pane) => pane.dataset.layer));
}

// Pixels of a canvas: its width, row 20 and every 97th pixel, as 0xAABBGGRR.
export function pixels(page, pane = 0) {
  return page.locator('.pane canvas').nth(pane).evaluate((canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const all = new Uint32Array(data.buffer);
    return { width: canvas.width, row: [...all.subarray(canvas.width * 20, canvas.width * 21)],
      sample: [...all.filter((_, i) => i % 97 === 0)] };
  });
}
