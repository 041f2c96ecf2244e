// The first screen holds verdict, pictures and chart; all of them lead to the stage; the rest of the page is folded.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { layers, open, results, screenshot, settled, unfoldAll } from './browser.mjs';

const desk = { width: 1280, height: 800 };
const views = results.views.map(({ key }) => key);
const ranking = (key) => results.rankings.find(({ view_keys: keys }) => keys.length === 1 && keys[0] === key);
const winner = (key) => results.cells.find(({ id }) => id === ranking(key).places.find(({ rank }) => rank).cell_ids[0]);
const inSight = (locator) => locator.evaluate((element) => {
  const { top, bottom } = element.getBoundingClientRect();
  return top >= 0 && bottom <= innerHeight;
});
const stageIsAtTop = (page) => page.waitForFunction(() => Math.abs(document.querySelector('.stage').getBoundingClientRect().top) < 100);

test('a desk shows verdict, truth, winner, its error, its worst region, the chart and all views at once', async () => {
  const { page, complaints } = await open({ folded: true, viewport: desk });
  await page.locator('.small-cost-chart canvas').waitFor();
  const images = page.locator('.look:visible .strip img');
  assert.equal(await images.count(), 5, 'the worst region is two pictures');
  for (const image of await images.all()) {
    assert.ok(await image.evaluate(({ naturalWidth, complete }) => complete && naturalWidth > 8));
    assert.ok(await inSight(image), 'a picture lies below the first screen');
  }
  for (const selector of ['.verdict', '.small-cost-chart >> visible=true', '.view-tabs']) assert.ok(await inSight(page.locator(selector)), selector);
  const cell = winner(views[0]);
  const text = await page.locator('.look:visible .strip').textContent();
  assert.ok(text.includes(`${cell.method_label}, ${cell.preset}`) && text.includes(cell.ranked.rmse_debiased.value.toFixed(4)), text);
  assert.deepEqual(await page.locator('.view-tabs button').evaluateAll((tabs) => tabs.map(({ dataset, textContent }) => [dataset.view, textContent.trim()])),
    views.map((key) => [key, `${key} ${winner(key).method_label}`]));
  assert.deepEqual(complaints, []);
  await screenshot(page, 'first-screen');
});

test('a phone shows the same in one column', async () => {
  const { page } = await open({ folded: true, viewport: { width: 390, height: 844 } });
  const lefts = await page.locator('.look:visible .strip a').evaluateAll((links) => links.map((link) => link.getBoundingClientRect().left));
  assert.equal(new Set(lefts).size, 1);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await screenshot(page, 'first-screen-phone');
});

test('the switch shows another view, here and on the stage', async () => {
  const { page } = await open({ folded: true, viewport: desk });
  await page.locator(`.view-tabs button[data-view="${views[1]}"]`).click();
  const look = page.locator('.look:visible');
  assert.equal(await look.count(), 1);
  assert.equal(await look.getAttribute('data-view'), views[1]);
  assert.ok((await look.textContent()).includes(winner(views[1]).method_label));
  assert.equal(await page.locator('.choosers input[name=view]:checked').inputValue(), views[1]);
  await look.locator('.small-cost-chart canvas').waitFor();
});

test('every picture leads to itself on the stage', async () => {
  const { page } = await open({ folded: true, viewport: desk });
  const { id } = winner(views[0]);
  const wanted = [`truth ${views[0]} gray`, `output ${id} gray`, `error ${id} 0.5 false`, `output ${id} gray`];
  for (let i = 0; i < wanted.length; i += 1) {
    await page.locator('.look:visible .strip a').nth(i).click();
    await settled(page);
    assert.ok((await layers(page)).includes(wanted[i]), `${await layers(page)} lacks ${wanted[i]}`);
    await stageIsAtTop(page);
    await page.evaluate(() => scrollTo({ top: 0, behavior: 'instant' }));
  }
  const { worst_x: x, worst_y: y } = winner(views[0]).analysis.regions.reduce((a, b) =>
    (Math.abs(b.mean_error) * b.area_px > Math.abs(a.mean_error) * a.area_px ? b : a));
  const box = new URLSearchParams(await page.locator('.look:visible .strip a').nth(3).evaluate(({ hash }) => hash.slice(1))).get('at').split(',').map(Number);
  assert.ok(x >= box[0] && x < box[0] + box[2] && y >= box[1] && y < box[1] + box[3], 'the worst pixel is outside of what is shown');
});

test('a dot of the chart leads to its error on the stage', async () => {
  const { page } = await open({ folded: true, viewport: desk });
  const chart = page.locator('.look:visible .small-cost-chart');
  await chart.locator('canvas').waitFor();
  const box = await chart.locator('.u-over').boundingBox();
  // The chart names a dot under the pointer; the first that is met is clicked.
  let found = '';
  for (let y = 4; y < box.height && !found; y += 8) {
    for (let x = 4; x < box.width && !found; x += 8) {
      await page.mouse.move(box.x + x, box.y + y);
      found = await chart.locator('.u-over').evaluate(({ title }) => title);
      if (found) await page.mouse.click(box.x + x, box.y + y);
    }
  }
  await settled(page);
  const [name] = found.split(':');
  const cell = results.cells.find(({ view_key: key, method_label: label, preset }) => key === views[0] && `${label}, ${preset}` === name);
  assert.ok((await layers(page)).includes(`error ${cell.id} 0.5 false`));
  await stageIsAtTop(page);
});

test('folded, the page is under six screens and 3,000 nodes, and every section says its result', async () => {
  const { page } = await open({ folded: true, viewport: desk });
  const { height, nodes, lines } = await page.evaluate(() => ({ height: document.documentElement.scrollHeight, nodes: document.querySelectorAll('*').length,
    lines: [...document.querySelectorAll('.fold .in-short')].map(({ textContent }) => textContent) }));
  assert.ok(height < 6 * desk.height, `${height} px`);
  assert.ok(nodes < 3000, `${nodes} nodes`);
  assert.ok(lines.length >= 6);
  for (const line of lines) assert.match(line, /^\S.*\.$/);
  await unfoldAll(page);
  assert.ok(await page.evaluate(() => document.querySelectorAll('#ranking tbody tr').length) > 3);
});

test('what stands behind a link of a folded section is built and shown', async () => {
  const { page } = await open({ folded: true, viewport: desk });
  await page.locator('nav a[href="#measurement"]').click();
  await page.locator('#measurement .command').first().waitFor();
  assert.equal(await page.locator('#ranking tbody').count(), 0, 'other sections stay folded');
  const { page: second } = await open({ folded: true, which: 'synthetic', hash: '#hussain-table-3' });
  await second.waitForFunction(() => Math.abs(document.getElementById('hussain-table-3').getBoundingClientRect().top) < 200);
});

test('without scripts all tables and the first pictures can be read, and the page says what cannot be', async () => {
  const { page } = await open({ folded: true, viewport: desk, javaScriptEnabled: false });
  assert.equal(await page.locator('.look').count(), views.length);
  assert.ok(await page.locator('.look .strip img').first().isVisible());
  await page.locator('#ranking summary').first().click();
  assert.ok(await page.locator('#ranking table').first().isVisible());
  assert.match(await page.locator('#pictures noscript').textContent(), /need JavaScript/);
});

test('nothing of the stage is unpacked before it is in sight', async () => {
  const { page } = await open({ folded: true, viewport: desk });
  assert.equal(await page.locator('.pane').count(), 0);
  await page.mouse.move(600, 400);
  await page.mouse.wheel(0, 900);
  await settled(page);
  assert.equal(await page.locator('.pane').count(), 2);
});
