// The page is one file that needs nothing else, has no errors, and is valid.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { test } from 'node:test';
import { open, pages, require } from './browser.mjs';

for (const which of Object.keys(pages)) {
  test(`${which}: asks for nothing but itself`, async () => {
    const { page, requests, complaints, address } = await open({ which });
    for (const mode of await page.locator('input[name=mode]').evaluateAll((inputs) => inputs.map(({ value }) => value))) {
      await page.locator(`input[name=mode][value=${mode}]`).check();
    }
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    await page.waitForTimeout(300);
    assert.deepEqual([...new Set(requests.filter((url) => !url.startsWith('data:')))], [address]);
    assert.deepEqual(complaints, []);
    assert.equal(await page.evaluate(() => document.documentElement.dataset.scriptError), undefined);
  });

  test(`${which}: its policy refuses a request`, async () => {
    const { page } = await open({ which });
    const refused = await page.evaluate(() => new Promise((resolve) => {
      document.addEventListener('securitypolicyviolation', (event) => resolve(event.effectiveDirective));
      fetch('https://localhost/x').catch(() => {});
      setTimeout(() => resolve('nothing'), 3000);
    }));
    assert.equal(refused, 'connect-src');
  });

  test(`${which}: is valid HTML`, async () => {
    const { HtmlValidate } = require('html-validate');
    // The images' base64 is no markup.
    const html = fs.readFileSync(pages[which], 'utf8')
      .replace(/(<script type="application\/octet-stream"[^>]*>)[^<]*/g, '$1');
    const report = await new HtmlValidate({ extends: ['html-validate:standard'],
      rules: { 'no-inline-style': 'off', 'long-title': 'off', 'no-trailing-whitespace': 'off' } }).validateString(html);
    const messages = report.results.flatMap(({ messages: found }) => found)
      .filter(({ severity }) => severity === 2).map(({ line, message, ruleId }) => `${line}: ${ruleId}: ${message}`);
    assert.deepEqual(messages, []);
  });
}
