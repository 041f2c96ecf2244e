// On the stage two fingers zoom, and one scrolls the page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open, pixels, screenshot, settled } from './browser.mjs';

const { page, complaints } = await open({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
const touch = await page.context().newCDPSession(page);
const zoom = () => page.locator('.zoom-text').textContent();

// Moves fingers along straight lines, {from: [x, y], to: [x, y]} each, in viewport coordinates.
async function fingers(...lines) {
  const points = (part) => lines.map(({ from, to }, id) => ({ id, x: from[0] + part * (to[0] - from[0]), y: from[1] + part * (to[1] - from[1]) }));
  await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(0) });
  for (let step = 1; step <= 10; step += 1) {
    await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(step / 10) });
  }
  await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await settled(page);
}

async function middle() {
  const canvas = page.locator('.pane canvas').first();
  await canvas.evaluate((element) => element.scrollIntoView({ behavior: 'instant', block: 'center' }));
  const { x, y, width, height } = await canvas.boundingBox();
  return [x + width / 2, y + height / 2];
}

test('two fingers that part zoom every pane, and neither zoom nor scroll the page', async () => {
  const [x, y] = await middle();
  const before = await Promise.all([pixels(page, 0), pixels(page, 1)]);
  const scrolled = await page.evaluate(() => scrollY);
  const fitted = parseFloat((await zoom()).replace('fits: ', ''));
  await fingers({ from: [x - 20, y], to: [x - 80, y] }, { from: [x + 20, y], to: [x + 80, y] });
  const times = parseFloat(await zoom()) / fitted;
  assert.ok(times > 3 && times < 5, `${times} times is not the fingers' 4`);
  const after = await Promise.all([pixels(page, 0), pixels(page, 1)]);
  assert.notDeepEqual(after[0], before[0]);
  assert.notDeepEqual(after[1], before[1]);
  assert.equal(await page.evaluate(() => scrollY), scrolled);
  assert.equal(await page.evaluate(() => visualViewport.scale), 1);
  await screenshot(page, 'two-fingers');
});

test('two fingers that come together zoom out', async () => {
  const [x, y] = await middle();
  await fingers({ from: [x - 80, y], to: [x - 15, y] }, { from: [x + 80, y], to: [x + 15, y] });
  assert.match(await zoom(), /^fits: /);
});

test('one finger that goes up scrolls the page', async () => {
  const [x, y] = await middle();
  const before = await page.evaluate(() => scrollY);
  await fingers({ from: [x, y], to: [x, y - 200] });
  await page.waitForFunction((from) => scrollY > from + 50, before);
  assert.match(await zoom(), /^fits: /);
});

test('nothing was complained of', () => assert.deepEqual(complaints, []));
