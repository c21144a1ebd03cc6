// SPDX-License-Identifier: MIT
// Opens the pages that sample_pages wrote, as a user does:  node page_test.mjs SAMPLE_PAGES_PROGRAM
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {exitCode, runTest} from '../support/node_test.mjs';
import {openPage, overflow, settle, startBrowser} from './browser.mjs';
import {sheetTests} from './sheet_tests.mjs';
import {viewerTests} from './viewer_tests.mjs';

const kOverallLimitMs = 90000; // whatever hangs, the test ends
setTimeout(() => {
  console.log(`the pages were not done after ${kOverallLimitMs / 1000} s`);
  process.exit(1);
}, kOverallLimitMs).unref();

const browser = await startBrowser();
const folder = mkdtempSync(join(tmpdir(), 'lueur-pages-'));
const sample = spawnSync(process.argv[2], [folder], {stdio: 'inherit', timeout: 30000});
assert.equal(sample.status, 0, 'sample_pages failed');
const expected = JSON.parse(readFileSync(join(folder, 'expected.json')));
const pageFile = (name) => join(folder, name, 'index.html');
const open = (name, options) => openPage(browser, pageFile(name), options);

const tests = {
  ...viewerTests(expected),

  async 'the table sorts and marks the best'(page) {
    const first = () => page.locator('#error-table tbody th').allTextContents();
    const heading = page.getByRole('button', {
      name: 'Sort by against path, RMSE, radiance, lower is better',
    });
    await heading.click();
    assert.equal((await first())[0], 'hierarchical "fine" </script>');
    assert.equal(await page.locator('th[aria-sort="ascending"]').count(), 1);
    await heading.press('Enter');
    assert.equal((await first())[0], 'none');
    await page.getByRole('button', {name: 'against screen, PSNR'}).click();
    assert.equal(await page.locator('th[aria-sort="descending"]').count(), 1);
    // One for each column with a number: two times, and three metrics against two references.
    assert.equal(await page.locator('#error-table .best').count(), 8);
    assert.equal(
      await page
        .locator('#error-table tbody tr', {hasText: 'none'})
        .locator('td')
        .first()
        .textContent(),
      '0',
    );
  },

  async 'the plot shows each entry'(page) {
    assert.equal(await page.locator('#scatter-plot .dot').count(), 2);
    assert.equal(await page.locator('#scatter-plot .baseline').count(), 1);
    assert.match(await page.textContent('#scatter-plot'), /RMSE in radiance \(lower is better\)/);
    await page.selectOption('#scatter-metric', 'psnr');
    // Plots are drawn again with the next frame.
    await page
      .locator('#scatter-plot', {hasText: /PSNR in dB \(higher is better\)/})
      .waitFor({timeout: 5000});
    assert.equal(await page.locator('.bar').count(), 3);
  },

  async 'Tab reaches everything, and one sees where it is'(page) {
    const reached = [];
    for (let i = 0; i < 200; ++i) {
      await page.keyboard.press('Tab');
      const focused = await page.evaluate(() => {
        const {activeElement: element} = document;
        if (element === document.body) return null;
        const outlined = (pseudo) => getComputedStyle(element, pseudo).outlineStyle !== 'none';
        return {
          id: element.id,
          name: element.outerHTML.slice(0, 80),
          visible: outlined(null) || outlined('::after'),
        };
      });
      if (focused === null) break;
      assert.ok(focused.visible, `no focus is seen on ${focused.name}`);
      reached.push(focused.id);
    }
    for (const id of [
      'left',
      'swap',
      'right',
      'exposure',
      'tone-map',
      'stage',
      'divider',
      'map-scale',
      'scatter-metric',
      'copy',
    ])
      assert.ok(reached.includes(id), `${id} is not reached`);
  },

  async 'every control has a name'(page) {
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll('button, select, input, [tabindex]')]
        .filter((e) => !(e.labels?.length || e.getAttribute('aria-label') || e.textContent.trim()))
        .map((e) => e.outerHTML.slice(0, 80)),
    );
    assert.deepEqual(nameless, []);
  },

  async 'the command is copied'(page) {
    await page.click('#copy');
    await page.waitForFunction(() => document.getElementById('copy').textContent === 'Copied');
  },
};

// Contrast as WCAG 2 defines it, of an element's text against the page.
const contrast = (page, selector) =>
  page.evaluate((s) => {
    const light = (color) => {
      const [r, g, b] = color
        .match(/\d+/g)
        .map((code) =>
          code / 255 <= 0.04045 ? code / 255 / 12.92 : ((code / 255 + 0.055) / 1.055) ** 2.4,
        );
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const [a, b] = [
      getComputedStyle(document.querySelector(s)).color,
      getComputedStyle(document.body).backgroundColor,
    ].map(light);
    return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  }, selector);

const otherPages = {
  async 'light and dark can be read'() {
    const backgrounds = [];
    for (const dark of [false, true]) {
      const page = await open('full', {dark});
      await settle(page);
      assert.ok((await contrast(page, 'body')) > 12);
      for (const quiet of ['dt', 'thead th', '.best'])
        assert.ok((await contrast(page, quiet)) > 4.5, quiet);
      backgrounds.push(await page.evaluate(() => getComputedStyle(document.body).backgroundColor));
      assert.deepEqual(page.faults, []);
      await page.close();
    }
    assert.notEqual(backgrounds[0], backgrounds[1]);
  },

  async 'no page is wider than its window'() {
    for (const name of ['full', 'one', 'empty', 'figures']) {
      const page = await open(name);
      for (const width of [1280, 400]) {
        await page.setViewportSize({width, height: 640});
        await settle(page);
        assert.ok((await overflow(page)) <= 0, `${name} at ${width} px`);
      }
      assert.deepEqual(page.faults, [], name);
      await page.close();
    }
  },

  async 'without references or techniques it says so'() {
    const single = await open('one');
    await settle(single);
    assert.match(await single.textContent('#error-note'), /no reference/);
    assert.ok(await single.isVisible('#viewer'));
    assert.ok(await single.isHidden('#scatter'));
    await single.close();
    const empty = await open('empty');
    assert.match(await empty.textContent('#error-note'), /no technique/);
    assert.ok(await empty.isHidden('#viewer'));
    await empty.close();
  },

  async 'a browser that cannot unpack says so'() {
    const page = await open('full', {
      before: () => {
        delete globalThis.DecompressionStream;
      },
    });
    assert.match(await page.textContent('#warnings'), /lacks DecompressionStream/);
    assert.ok(await page.isHidden('#viewer'));
    assert.equal(await page.locator('#error-table tbody tr').count(), 3);
    assert.deepEqual(page.faults, []);
    await page.close();
  },

  async 'figures have pictures, marks, curves and tables'() {
    const page = await open('figures');
    assert.deepEqual(
      await page.evaluate(() => [...document.images].map((image) => image.naturalWidth)),
      [192, 192],
    );
    assert.equal(await page.locator('.mark.over').count(), 1);
    assert.equal(await page.locator('.curve').count(), 3);
    assert.deepEqual(await page.locator('tbody tr').nth(1).locator('td').allTextContents(), [
      '–',
      '61',
    ]);
    assert.equal(await page.title(), 'Figures of <a paper>');
    await page.close();
  },
};

const page = await open('full');
for (const [name, test] of Object.entries(tests))
  await runTest(name, async () => {
    page.faults.length = 0;
    await page.reload();
    await page.evaluate(() => scrollTo(0, 0)); // browsers go where one was before
    await settle(page);
    await test(page);
    assert.deepEqual(page.faults, []);
  });
await page.close();
for (const [name, test] of Object.entries({...otherPages, ...sheetTests(open)}))
  await runTest(name, test);

await browser.close();
rmSync(folder, {recursive: true});
process.exit(exitCode());
