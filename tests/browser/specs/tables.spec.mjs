// The tables agree with results.json, and their headers sort them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open, results, screenshot } from './browser.mjs';

const { page } = await open();
const number = (text) => Number(text.replace('−', '-').replace(/\s/g, ''));
const rounds = (text, value) => {
  const decimals = (text.split('.')[1] ?? '').length;
  assert.ok(Math.abs(number(text) - value) <= 0.5000001 * 10 ** -decimals, `${text} is not ${value}`);
};

async function table(selector) {
  return page.locator(selector).evaluate((element) => ({
    heads: [...element.tHead.rows[0].cells].map((cell) => cell.textContent.trim()),
    rows: [...element.tBodies[0].rows].map((row) => ({ cell: row.dataset.cell,
      texts: [...row.cells].map(({ firstChild, textContent }) => (firstChild?.nodeType === 3 ? firstChild.textContent : textContent).trim()) })),
  }));
}

const metricHeads = { RMSE: 'rmse', 'RMSE, debiased': 'rmse_debiased', MAE: 'mae', Bias: 'bias', PSNRdB: 'psnr', SSIM: 'ssim',
  'Max. error': 'max_error', FLIP: 'flip', 'MS-SSIM': 'ms_ssim' };

for (const view of results.views) {
  test(`the ranking of ${view.key} holds the results' numbers`, async () => {
    const { heads, rows } = await table(`#ranking table[data-view="${view.key}"]`);
    const ranking = results.rankings.find(({ view_keys: keys }) => keys.length === 1 && keys[0] === view.key);
    assert.deepEqual(rows.map(({ cell }) => cell), ranking.places.map(({ cell_ids: [id] }) => id));
    const rankText = ({ rank }) => (rank === null ? 'bound' : [...new Set([rank.best, rank.worst])].join('–'));
    assert.deepEqual(rows.map(({ texts: [rank] }) => rank), ranking.places.map(rankText));
    let compared = 0;
    for (const { cell: id, texts } of rows) {
      const cell = results.cells.find((other) => other.id === id);
      const values = { ...Object.fromEntries(Object.entries(metricHeads).map(([head, metric]) => [head, cell.ranked[metric]?.value])),
        'Missing%': cell.analysis.missing.area * 100, 'False%': cell.analysis.false_occlusion.area * 100,
        'Fetchesa pixel': cell.fetches_per_pixel, AOms: cell.ao.median_ms, Filterms: cell.filter_pass.median_ms, Framems: cell.frame_ms };
      for (const [head, value] of Object.entries(values)) {
        const column = heads.indexOf(head);
        assert.ok(column > 0, `no column ${head} among ${heads}`);
        if (value === null || value === undefined) assert.equal(texts[column], '–');
        else rounds(texts[column], value);
        compared += 1;
      }
    }
    assert.equal(compared, 15 * ranking.places.length);
  });

  test(`missing and false occlusion on ${view.key} are the results'`, async () => {
    const at = results.views.indexOf(view);
    const { rows } = await table(`#failures table >> nth=${at}`);
    const { places } = results.rankings.find(({ view_keys: keys }) => keys.length === 1 && keys[0] === view.key);
    const cells = places.map(({ cell_ids: [id] }) => results.cells.find((cell) => cell.id === id));
    assert.equal(rows.length, cells.length);
    rows.forEach(({ texts }, i) => {
      const { missing, false_occlusion: dark } = cells[i].analysis;
      rounds(texts[2], missing.area * 100);
      missing.causes.forEach(({ area }, k) => rounds(texts[3 + k], area * 100));
      assert.equal(missing.causes.length, 4);
      rounds(texts[8], dark.area * 100);
    });
  });
}

test('every interval is the results\', per view and over views', async () => {
  const tables = await page.locator('#ranking table.intervals').evaluateAll((all) => all.map((element) => ({
    heads: [...element.tHead.rows[0].cells].map((cell) => cell.textContent.trim()),
    rows: [...element.tBodies[0].rows].map((row) => [...row.cells].map((cell) => ({
      value: cell.firstChild?.nodeType === 3 ? cell.firstChild.textContent.trim() : '', interval: cell.querySelector('.unit')?.textContent ?? '' }))),
  })));
  assert.equal(tables.length, results.rankings.length);
  assert.ok(results.rankings.some(({ view_keys: keys }) => keys.length > 1), 'no ranking over views');
  const ids = { ...metricHeads, 'Missing%': 'missing_area', 'False%': 'false_area' };
  let intervals = 0;
  results.rankings.forEach(({ places, view_keys: keys }, i) => places.forEach(({ measures, cell_ids: [first] }, row) => {
    for (const [head, id] of Object.entries(ids)) {
      const { value, interval } = tables[i].rows[row][tables[i].heads.indexOf(head)];
      const times = id.endsWith('_area') ? 100 : 1;
      if (!measures[id]) assert.equal(value, '–', `${head} of ${first}`);
      else rounds(value, measures[id].value * times);
      const bounds = measures[id]?.interval;
      if (!bounds) {
        assert.match(interval, /^(no interval)?$/, `${head} of ${first}`);
        continue;
      }
      interval.split(' to ').forEach((text, end) => rounds(text, (end ? bounds.high : bounds.low) * times));
      if (keys.length === 1) assert.deepEqual(bounds, results.cells.find((cell) => cell.id === first).analysis.intervals[id]);
      intervals += 1;
    }
  }));
  // All but the largest error, MS-SSIM of a small picture, and areas that are empty in every block.
  const places = results.rankings.reduce((sum, ranking) => sum + ranking.places.length, 0);
  assert.ok(intervals >= places * 7 && intervals <= places * 9, `${intervals} intervals at ${places} places`);
});

test('heads sort up and down, and a number that is missing stays last', async () => {
  const head = page.locator(`#ranking table[data-view] >> nth=0`).locator('thead button', { hasText: 'Fetches' });
  const column = async () => {
    const { heads, rows } = await table('#ranking table[data-view] >> nth=0');
    return rows.map(({ texts }) => number(texts[heads.indexOf('Fetchesa pixel')]));
  };
  await head.click();
  await page.waitForTimeout(100);
  const up = await column();
  assert.deepEqual(up, [...up].sort((a, b) => a - b));
  await head.click();
  await page.waitForTimeout(100);
  assert.deepEqual(await column(), [...up].sort((a, b) => b - a));
  const chooser = page.locator('#ranking .scroll:has(table[data-view]) >> nth=0').locator('xpath=preceding-sibling::*[1]');
  await chooser.locator('summary').click();
  await chooser.getByLabel('MS-SSIM').check();
  const empty = page.locator('#ranking table[data-view] >> nth=0').locator('thead button', { hasText: 'MS-SSIM' });
  await empty.press('Enter');
  await page.waitForTimeout(100);
  assert.equal(await page.locator('#ranking table[data-view] >> nth=0').locator('th[aria-sort]').textContent(), 'MS-SSIM');
});

test('charts show every method and the front is unbeaten', async () => {
  for (const section of ['cost', 'failures', 'distributions']) {
    await page.locator(`#${section}`).scrollIntoViewIfNeeded();
    await page.waitForTimeout(400);
  }
  for (const chart of await page.locator('.chart').all()) {
    await chart.scrollIntoViewIfNeeded();
    await chart.locator('.uplot canvas').waitFor();
    const drawn = await chart.locator('canvas').evaluate((canvas) => new Set(new Uint32Array(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size);
    assert.ok(drawn > 3, 'an empty chart');
  }
  const costs = await page.locator('.cost-chart').evaluateAll((charts) => charts.map((chart) => JSON.parse(chart.parentElement.querySelector('script').textContent)));
  costs.forEach((points, i) => {
    const cells = results.cells.filter((cell) => cell.view_key === results.views[i].key);
    assert.equal(points.length, cells.length);
    for (const point of points) {
      const cell = cells.find(({ id }) => id === point.cell);
      assert.equal(point.ms, cell.ao.median_ms + (cell.filter_pass.median_ms ?? 0));
      assert.equal(point.error, cell.ranked.rmse_debiased.value);
      assert.deepEqual({ low: point.low, high: point.high }, cell.analysis.intervals.rmse_debiased);
      const beaten = points.some(({ bound, ms, error }) => !bound && ms <= point.ms && error <= point.error && (ms < point.ms || error < point.error));
      assert.equal(point.bound, cell.role === 'bound');
      assert.equal(point.front, !beaten && !point.bound, point.label);
    }
  });
  for (const section of ['cost', 'failures', 'distributions']) await screenshot(page.locator(`#${section}`), section);
});
