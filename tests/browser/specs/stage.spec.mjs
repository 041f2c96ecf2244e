// Every mode shows its picture, keys and sliders do what the help says, and zooming leaves scrolling alone.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { choose, layers, open, pixels, screenshot, settled } from './browser.mjs';

const { page, complaints } = await open();
const stageData = await page.evaluate(() => JSON.parse(document.getElementById('stage-data').textContent));
const [view] = stageData.views;
const stage = page.locator('.stage');
const truth = `truth ${view.key} gray`;
const output = (i) => `output ${view.cells[i].id} gray`;
const checked = (name) => page.locator(`input[name="${name}"]:checked`).getAttribute('value');
const zoom = () => page.locator('.zoom-text').textContent();

async function fresh(mode) {
  await page.keyboard.press('r');
  await choose(page, `cell-${view.key}`, view.cells[0].id);
  if (mode) await choose(page, 'mode', mode);
  await stage.scrollIntoViewIfNeeded();
}
async function slide(name, value) {
  await page.locator(`.choosers [name=${name}]`).evaluate((input, to) => {
    input.value = to;
    input.dispatchEvent(new Event('input', { bubbles: true }));
    input.dispatchEvent(new Event('change', { bubbles: true }));
  }, String(value));
  await settled(page);
}
async function hover(u = 0.5, v = 0.5, pane = 0) {
  const box = await page.locator('.pane canvas').nth(pane).boundingBox();
  await page.mouse.move(box.x + u * box.width, box.y + v * box.height);
  return box;
}
const varied = ({ sample }) => new Set(sample).size > 10;

const shown = {
  beside: () => [truth, output(0)],
  swipe: () => [output(0)],
  blink: () => [output(0)],
  onion: () => [output(0)],
  difference: () => [`error ${view.cells[0].id} 0.5 false`],
  alone: () => [output(0)],
  all: () => [truth, ...view.cells.map((cell, i) => output(i))],
};
for (const [mode, expected] of Object.entries(shown)) {
  test(`${mode} shows its panes`, async () => {
    await fresh(mode);
    assert.deepEqual(await layers(page), expected());
    for (let pane = 0; pane < expected().length; pane += 1) assert.ok(varied(await pixels(page, pane)), `pane ${pane} is blank`);
    await screenshot(stage, `mode-${mode}`);
  });
}
test('there is no other mode', async () => {
  const modes = await page.locator('input[name=mode]').evaluateAll((inputs) => inputs.map(({ value }) => value));
  assert.deepEqual(modes.sort(), Object.keys(shown).sort());
});

test('every picture can be shown and says what it shows', async () => {
  await fresh('alone');
  const pictures = await page.locator('input[name=picture]').evaluateAll((inputs) => inputs.filter((input) => !input.closest('label').hidden).map(({ value }) => value));
  assert.deepEqual(pictures, ['output', 'raw', 'error', 'masks', 'causes', 'noise', 'depth']);
  for (const picture of pictures) {
    await choose(page, 'picture', picture);
    assert.match((await layers(page))[0], new RegExp(`^${picture} `));
    const { sample: list } = await pixels(page);
    assert.ok(new Set(list).size > 4, picture);
    assert.ok((await page.locator('.pane figcaption .sentence').textContent()).length > 20);
    assert.ok(await page.locator('.pane .bar, .pane .key').count() > 0, `${picture} has neither bar nor key`);
    await screenshot(stage, `picture-${picture}`);
  }
});

test('the cut of a swipe parts truth and output, by slider and by drag', async () => {
  await fresh('alone');
  const { width, row: alone } = await pixels(page);
  await choose(page, 'mode', 'swipe');
  await slide('cut', 0);
  assert.deepEqual((await pixels(page)).row.slice(8), alone.slice(8));
  await slide('cut', 100);
  const whole = (await pixels(page)).row;
  assert.notDeepEqual(whole.slice(0, -8), alone.slice(0, -8));
  await slide('cut', 50);
  const half = (await pixels(page)).row;
  assert.deepEqual(half.slice(0, width / 2 - 8), whole.slice(0, width / 2 - 8));
  assert.deepEqual(half.slice(width / 2 + 8), alone.slice(width / 2 + 8));
  const box = await hover(0.5);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.25, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  assert.ok(Math.abs(Number(await page.locator('[name=cut]').inputValue()) - 25) < 1);
});

test('onion skin mixes by its slider', async () => {
  await fresh('onion');
  const at = async (mix) => { await slide('mix', mix); return (await pixels(page)).sample.map((pixel) => pixel & 255); };
  const [top, mid, base] = [await at(0), await at(50), await at(100)];
  let apart = 0;
  for (let i = 0; i < mid.length; i += 1) {
    assert.ok(Math.abs(mid[i] - (top[i] + base[i]) / 2) <= 3);
    if (top[i] !== base[i]) apart += 1;
  }
  assert.ok(apart > 100);
});

test('blink changes by itself, no more than three times a second, and by hand', async () => {
  await fresh('blink');
  await slide('rate', 3);
  const says = () => page.locator('.stage-status').textContent();
  const heard = await page.evaluate(() => new Promise((resolve) => {
    let changes = 0;
    const observer = new MutationObserver(() => { changes += 1; });
    observer.observe(document.querySelector('.stage-status'), { childList: true, characterData: true, subtree: true });
    setTimeout(() => { observer.disconnect(); resolve(changes); }, 2000);
  }));
  assert.ok(heard >= 3 && heard <= 6, `${heard} changes in 2 s`);
  await page.locator('.panes').focus();
  await page.keyboard.press(' ');
  const before = await says();
  await page.waitForTimeout(500);
  assert.equal(await says(), before, 'it still blinks by itself');
  await page.keyboard.press(' ');
  assert.notEqual(await says(), before);
});

test('difference is held against another method, in gray and over another range', async () => {
  await fresh('difference');
  await page.locator('[name=against]').selectOption(view.cells[1].id);
  await settled(page);
  assert.deepEqual(await layers(page), [`difference output ${view.cells[0].id} ${view.cells[1].id} 0.5 false`]);
  await page.locator('[name=range]').selectOption('0.1');
  await page.locator('[name=gray]').check();
  await settled(page);
  assert.deepEqual(await layers(page), [`difference output ${view.cells[0].id} ${view.cells[1].id} 0.1 true`]);
  const { sample: list } = await pixels(page);
  assert.ok(list.every((pixel) => (pixel & 255) === (pixel >> 8 & 255) || (pixel & 0xffffff) === 0x766f6f), 'colours in gray');
  assert.match(await page.locator('.ticks').textContent(), /0\.10/);
  await screenshot(stage, 'difference-gray');
});

test('digits choose methods, M modes, V views', async () => {
  await fresh();
  for (let i = 0; i < view.cells.length; i += 1) {
    await page.keyboard.press(String(i + 1));
    await settled(page);
    assert.equal(await checked(`cell-${view.key}`), view.cells[i].id);
    assert.deepEqual(await layers(page), [truth, output(i)]);
  }
  await page.keyboard.press('m');
  assert.equal(await checked('mode'), 'swipe');
  await page.keyboard.press('v');
  await settled(page);
  assert.equal(await checked('view'), stageData.views[1].key);
  assert.match((await layers(page))[0], new RegExp(stageData.views[1].key));
});

test('arrows on the pictures step through methods and pictures, and leave the page alone elsewhere', async () => {
  await fresh();
  await page.locator('.panes').focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await checked(`cell-${view.key}`), view.cells[1].id);
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await checked(`cell-${view.key}`), view.cells.at(-1).id);
  await page.keyboard.press('ArrowDown');
  assert.equal(await checked('picture'), 'raw');
  await page.keyboard.press('ArrowUp');
  assert.equal(await checked('picture'), 'output');
  await page.evaluate(() => document.activeElement.blur());
  const before = await page.evaluate(() => scrollY);
  await page.keyboard.press('ArrowDown');
  await page.waitForTimeout(300);
  assert.notEqual(await page.evaluate(() => scrollY), before);
  assert.equal(await checked('picture'), 'output');
});

test('Shift holds the truth', async () => {
  await fresh('alone');
  await page.keyboard.down('Shift');
  await settled(page);
  assert.deepEqual(await layers(page), [truth]);
  await page.keyboard.up('Shift');
  await settled(page);
  assert.deepEqual(await layers(page), [output(0)]);
});

test('wheel scrolls the page; with Ctrl it zooms, where the pointer is; F fits, R resets', async () => {
  await fresh();
  await page.evaluate(() => document.querySelector('.stage').scrollIntoView({ behavior: 'instant' }));
  await hover();
  const before = await page.evaluate(() => scrollY);
  await page.mouse.wheel(0, 200);
  await page.waitForTimeout(500);
  assert.ok(await page.evaluate(() => scrollY) > before, 'the stage traps the wheel');
  assert.match(await zoom(), /^fits: /);
  await page.evaluate(() => document.querySelector('.stage').scrollIntoView({ behavior: 'instant' }));
  await hover(0.253, 0.747);
  const pixel = await page.locator('.pixel-place').textContent();
  const fitted = parseFloat((await zoom()).replace('fits: ', ''));
  const scrolled = await page.evaluate(() => scrollY);
  await page.keyboard.down('Control');
  for (let i = 0; i < 12; i += 1) await page.mouse.wheel(0, -100);
  await page.keyboard.up('Control');
  await settled(page);
  await page.waitForTimeout(200);
  assert.ok(parseFloat(await zoom()) > 5 * fitted, await zoom());
  assert.equal(await page.evaluate(() => scrollY), scrolled);
  await hover(0.253, 0.747);
  assert.equal(await page.locator('.pixel-place').textContent(), pixel, 'zooming moved what is under the pointer');
  await screenshot(stage, 'zoomed');
  await page.keyboard.press('f');
  await settled(page);
  assert.match(await zoom(), /^fits: /);
  await choose(page, 'picture', 'error');
  await page.locator('[name=gray]').check();
  await page.keyboard.press('r');
  await settled(page);
  assert.equal(await checked('picture'), 'output');
  assert.equal(await page.locator('[name=gray]').isChecked(), false);
});

test('panes move in step, show pixels without smoothing and carry their numbers', async () => {
  await fresh();
  for (let i = 0; i < 9; i += 1) await page.keyboard.press('+');
  await settled(page);
  const before = await Promise.all([pixels(page, 0), pixels(page, 1)]);
  const box = await hover();
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 - 60, box.y + box.height / 2 - 40, { steps: 3 });
  await page.mouse.up();
  await settled(page);
  const after = await Promise.all([pixels(page, 0), pixels(page, 1)]);
  assert.notDeepEqual(after[0], before[0]);
  assert.notDeepEqual(after[1], before[1]);
  // White letters with dark rims on an even colour: the truth is gray, so that other colours come from the text.
  const texts = await page.evaluate(() => {
    const { fillText } = CanvasRenderingContext2D.prototype;
    return new Promise((resolve) => {
      const list = [];
      CanvasRenderingContext2D.prototype.fillText = function record(text, ...rest) {
        list.push(text);
        return fillText.call(this, text, ...rest);
      };
      window.dispatchEvent(new Event('resize'));
      document.querySelector('[data-does="-"]').click();
      requestAnimationFrame(() => requestAnimationFrame(() => {
        CanvasRenderingContext2D.prototype.fillText = fillText;
        resolve(list);
      }));
    });
  });
  assert.ok(texts.length >= 8 && texts.every((text) => /^[+−]?(1|0)?\.?\d*$/.test(text)), texts.join(' '));
  await screenshot(stage, 'numbers');
});

test('W A S D inspect neighbours, P shows one pixel for one', async () => {
  await fresh();
  await hover(0.5, 0.5);
  const place = async () => (await page.locator('.pixel-place').textContent()).match(/\d+/g).map(Number);
  const [x, y] = await place();
  for (const [key, dx, dy] of [['d', 1, 0], ['s', 1, 1], ['a', 0, 1], ['w', 0, 0]]) {
    await page.keyboard.press(key);
    assert.deepEqual(await place(), [x + dx, y + dy]);
  }
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('+');
  await page.keyboard.press('p');
  await settled(page);
  // The picture is smaller than its place, in which case one for one is not reached: the zoom says what is.
  const [scale, least] = await page.locator('.pane canvas').first().evaluate((canvas) => [
    Number(document.querySelector('.zoom-text').textContent.match(/[\d.]+/)[0]), canvas.width / 160]);
  assert.ok(Math.abs(scale - Math.max(1, least)) < 0.02, `${scale} of at least ${least}`);
});

test('? lists every key', async () => {
  await fresh();
  await page.keyboard.press('?');
  const dialog = page.locator('.stage dialog');
  assert.ok(await dialog.isVisible());
  assert.equal(await dialog.locator('tr').count(), 13);
  await screenshot(page, 'help');
  await page.keyboard.press('Escape');
  assert.equal(await dialog.isVisible(), false);
});

test('buttons do what their keys do', async () => {
  await fresh();
  const fitted = parseFloat((await zoom()).replace('fits: ', ''));
  await page.locator('[data-does="+"]').click();
  await settled(page);
  assert.ok(Math.abs(parseFloat(await zoom()) - 1.5 * fitted) < 0.02, await zoom());
  await page.locator('[data-does="-"]').click();
  await settled(page);
  assert.match(await zoom(), /^fits: /);
});

test('nothing was complained of', () => assert.deepEqual(complaints, []));
