// The address keeps the stage's pictures, and one that names nothing does no harm.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { choose, layers, open, settled } from './browser.mjs';

test('a reload shows the same', async () => {
  const { page } = await open();
  const views = await page.evaluate(() => JSON.parse(document.getElementById('stage-data').textContent).views);
  const [, view] = views;
  await choose(page, 'view', view.key);
  await choose(page, `cell-${view.key}`, view.cells[2].id);
  await choose(page, 'picture', 'masks');
  await choose(page, 'mode', 'swipe');
  await page.keyboard.press('+');
  await page.waitForTimeout(500);
  const before = await layers(page);
  const zoomed = await page.locator('.zoom-text').textContent();
  assert.match(zoomed, /^[\d.]+×$/);
  const hash = await page.evaluate(() => location.hash);
  await page.reload();
  await settled(page);
  assert.deepEqual(await layers(page), before);
  assert.equal(await page.locator('.zoom-text').textContent(), zoomed);
  await page.waitForTimeout(500);
  assert.equal(await page.evaluate(() => location.hash), hash);
});

test('an address that names nothing opens the first view', async () => {
  const { page, complaints } = await open({ hash: '#view=nowhere&cell=%22%3E%3Cscript%3E&picture=no&mode=no&cut=x&zoom=a,b&at=1' });
  assert.match((await layers(page))[0], /^truth atrium\//);
  assert.deepEqual(complaints, []);
});

test('a worst region jumps to its place on the stage', async () => {
  const { page } = await open();
  const link = page.locator('.regions a').first();
  await link.scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.querySelector('.regions canvas').dataset.painted);
  const { box, cell } = await link.evaluate((element) => ({ ...element.dataset }));
  await link.click();
  await settled(page);
  assert.match((await layers(page)).join(), new RegExp(`error ${cell}`));
  const [left, top, width, height] = box.split(',').map(Number);
  const place = await page.locator('.pixel-place').textContent();
  assert.equal(place, `Pixel ${Math.floor(left + width / 2)}, ${Math.floor(top + height / 2)}`);
  await page.waitForFunction(() => Math.abs(document.querySelector('.stage').getBoundingClientRect().top) < 200);
});

test('the closest method is shown first', async () => {
  const { page } = await open({ which: 'synthetic' });
  // Its RMSE is four fifths of the previous preset's.
  assert.deepEqual((await layers(page))[1], 'output atrium/wide/alchemy/quality gray');
});
