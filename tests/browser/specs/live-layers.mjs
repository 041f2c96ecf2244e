// Surfaces behind one another are unpacked when a method over depth layers is chosen, and not before. The ranking's first
// method, which the section draws first, reads none.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open } from './browser.mjs';
import { openLive, shown } from './live.mjs';

// Notes the blocks that the page reads. Runs in the page before its own script.
function noteBlocks() {
  window.blocksRead = [];
  const { querySelector } = Document.prototype;
  Document.prototype.querySelector = function noted(selector) {
    const [, name] = /^script\[data-image="(.*)"\]$/.exec(selector) ?? [];
    if (name) window.blocksRead.push(name.replace(/\\(.)/g, '$1'));  // as it was before CSS.escape()
    return querySelector.call(this, selector);
  };
}

const { page, complaints } = await open({ init: noteBlocks });
const surfacesRead = () => page.evaluate(() => window.blocksRead.filter((name) => name.includes('surfaces')));
const choose = async (method) => {
  await page.locator('#live-method').selectOption(method);
  return shown(page);
};

test('a method that reads the G-buffer alone is drawn without them', async () => {
  assert.equal((await openLive(page)).method, 'gtao');
  assert.deepEqual(await surfacesRead(), []);
});

test('a method over depth layers is drawn once they are unpacked, each of them once', async () => {
  const first = await choose('sd-hbao');
  assert.equal(first.method, 'sd-hbao');
  assert.ok(new Set(first.output).size > 100, 'a flat picture');
  const read = await surfacesRead();
  assert.ok(read.length > 0);
  await choose('gtao');
  const again = await choose('sd-hbao');
  assert.deepEqual(again.output, first.output);
  assert.deepEqual(await surfacesRead(), read);
});

test('another view brings its own', async () => {
  const read = await surfacesRead();
  const other = await page.locator('#live-view option').nth(1).getAttribute('value');
  await page.locator('#live-view').selectOption(other);
  await shown(page);
  const more = (await surfacesRead()).slice(read.length);
  assert.equal(more.length, read.length);
  assert.ok(more.every((name) => name.includes(other)), more.join());
});

test('nothing was complained of', () => assert.deepEqual(complaints, []));
