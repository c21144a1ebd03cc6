// SPDX-License-Identifier: MIT
// Opens the pages that sample_pages wrote, as a user does:  node page_test.mjs SAMPLE_PAGES_PROGRAM
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {openPage, settle, startBrowser} from './browser.mjs';

const kOverallLimitMs = 90000;  // whatever hangs, the test ends
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

const kPicture = {width: 192, height: 108};
const stageText = (page) => page.textContent('#status');
const zoomOf = async (page) => Number(/zoom (\d+) %/.exec(await stageText(page))[1]);
const label = (page, side) => page.textContent(`#${side}-label`);

async function press(page, ...keys) {
  await page.focus('#stage');
  for (const key of keys) await page.keyboard.press(key);
  await settle(page);
}

// The page's canvas: RGB at places given in its own pixels. Read from a copy, since the browser
// complains of canvases that are read often.
const canvasPixels = (page, places) => page.evaluate((at) => {
  const {width, height} = document.getElementById('canvas');
  const copy = new OffscreenCanvas(width, height).getContext('2d', {willReadFrequently: true});
  copy.drawImage(document.getElementById('canvas'), 0, 0);
  const {data} = copy.getImageData(0, 0, width, height);
  return at.map(([x, y]) => [...data.subarray((y * width + x) * 4, (y * width + x) * 4 + 3)]);
}, places);

// Where the picture's corner lies at 1:1.
const cornerAtOne = (page) => page.evaluate(({width, height}) => {
  const canvas = document.getElementById('canvas');
  return [Math.round(canvas.width / 2 - width / 2), Math.round(canvas.height / 2 - height / 2)];
}, kPicture);

const overflow = (page) => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);

const tests = {
  async 'the tone map is that of the program'(page) {
    await page.selectOption('#left', 'entry-1');
    await page.check('input[value="one"]');
    await press(page, '1');
    const [left, top] = await cornerAtOne(page);
    for (const toneMap of new Set(expected.map((pixel) => pixel.tone_map)))
      for (const stops of new Set(expected.map((pixel) => pixel.stops))) {
        await page.selectOption('#tone-map', toneMap);
        await page.fill('#exposure', String(stops));
        await settle(page);
        const pixels = expected.filter((pixel) => pixel.tone_map === toneMap && pixel.stops === stops);
        const shown = await canvasPixels(page, pixels.map(({x, y}) => [left + x, top + y]));
        // The page's light is off by up to 1 / 400, less than half a code of the steepest curve, so
        // rounding may fall on the neighbour.
        shown.forEach((rgb, i) => rgb.forEach((code, c) => assert.ok(Math.abs(code - pixels[i].display[c]) <= 1,
          `${toneMap} at ${stops}: ${rgb} is not ${pixels[i].display} at ${pixels[i].x}, ${pixels[i].y}`)));
      }
  },

  async 'the read-out tells linear values'(page) {
    await page.selectOption('#left', 'entry-1');
    await page.check('input[value="one"]');
    await press(page, '1');
    const [left, top] = await cornerAtOne(page);
    for (const {x, y, linear} of expected.slice(0, 5)) {
      await page.locator('#stage').click({position: {x: left + x + 0.5, y: top + y + 0.5}});
      await settle(page);
      assert.match(await stageText(page), new RegExp(`pixel ${x}, ${y} \\(clicked\\)`));
      const cells = await page.locator('#read-out tbody tr').nth(1).locator('td').allTextContents();
      // 1 / 400 from packing, and three digits.
      linear.forEach((value, c) => assert.ok(Math.abs(Number(cells[c]) / value - 1) < 1 / 400 + 1 / 200,
        `${cells[c]} is not ${value}`));
    }
    await press(page, 'Escape');
    assert.match(await stageText(page), /below the pointer/);
  },

  async 'pictures are swapped and stepped through'(page) {
    const [left, right] = [await label(page, 'left'), await label(page, 'right')];
    assert.equal(left, 'hierarchical, 16 <b>samples</b>');
    assert.equal(right, 'path');
    await press(page, 'x');
    assert.deepEqual([await label(page, 'left'), await label(page, 'right')], [right, left]);
    await page.click('#swap');
    await settle(page);
    assert.equal(await label(page, 'left'), left);
    await press(page, '.', '<');
    assert.equal(await label(page, 'left'), 'hierarchical "fine" </script>');
    assert.equal(await label(page, 'right'), 'hierarchical "fine" </script>');
  },

  async 'zoom and pan by key, wheel and drag'(page) {
    const fit = await zoomOf(page);
    await press(page, '+', '+');
    assert.ok(Math.abs(await zoomOf(page) / fit - 2) < 0.02);
    const middle = await stageText(page);
    await press(page, 'ArrowLeft');
    assert.notEqual(await stageText(page), middle);
    await press(page, '1');
    assert.equal(await zoomOf(page), 100);
    await press(page, '0');
    assert.equal(await zoomOf(page), fit);

    const stage = await page.locator('#stage').boundingBox();
    await page.mouse.move(stage.x + 300, stage.y + 200);
    const below = await stageText(page);
    await page.mouse.wheel(0, -600);
    await settle(page);
    assert.ok(await zoomOf(page) > fit * 1.5);
    assert.equal(/pixel .*/.exec(await stageText(page))[0], /pixel .*/.exec(below)[0], 'the pixel below the pointer stays');
    await page.mouse.down();
    await page.mouse.move(stage.x + 400, stage.y + 200, {steps: 4});
    await page.mouse.up();
    await settle(page);
    assert.equal(/pixel .*/.exec(await stageText(page))[0], /pixel .*/.exec(below)[0], 'and goes along when dragged');
  },

  async 'the wheel scrolls the page until the picture has the focus'(page) {
    const fit = await zoomOf(page);
    await page.hover('#stage');
    assert.match(await stageText(page), /click the picture/);
    await page.mouse.wheel(0, 200);
    await page.waitForFunction(() => scrollY > 0);
    assert.equal(await zoomOf(page), fit);
  },

  async 'magnified pixels have sharp edges'(page) {
    await page.check('input[value="one"]');
    await press(page, '1', '+', '+', '+', '+', '+', '+');
    assert.equal(await zoomOf(page), 800);
    const row = await canvasPixels(page, Array.from({length: 160}, (_, x) => [300 + x, 200]));
    const changes = row.slice(1).filter((rgb, i) => String(rgb) !== String(row[i])).length;
    assert.ok(changes > 5 && changes <= 20, `${changes} changes of colour in 20 magnified pixels`);
  },

  async 'exposure brightens both pictures and resets'(page) {
    const places = [[200, 200], [1000, 200]];
    const before = await canvasPixels(page, places);
    await press(page, ']', ']', ']');
    assert.match(await page.textContent('#exposure-value'), /\+1\.50 stops \(EV 2\.00\)/);
    const after = await canvasPixels(page, places);
    after.forEach((rgb, i) => assert.ok(rgb[1] > before[i][1], `${rgb} is not brighter than ${before[i]}`));
    await page.click('#exposure-reset');
    await settle(page);
    assert.deepEqual(await canvasPixels(page, places), before);
  },

  async 'indirect light, layouts, maps'(page) {
    const composed = await canvasPixels(page, [[300, 300]]);
    await press(page, 'i');
    assert.notDeepEqual(await canvasPixels(page, [[300, 300]]), composed);
    assert.ok(await page.isChecked('input[value="indirect"]'));
    await press(page, 's');
    assert.ok(await page.isChecked('input[value="side"]'));
    assert.ok(await page.isHidden('#divider'));
    await page.locator('.map').nth(0).click();
    await settle(page);
    assert.equal(await label(page, 'right'), 'FLIP: none / path');
    const dim = await canvasPixels(page, [[1000, 120]]);
    await page.fill('#map-scale', '3');
    await settle(page);
    assert.match(await page.textContent('#legend-top'), /^0\.125 and more$/);
    assert.notDeepEqual(await canvasPixels(page, [[1000, 120]]), dim);
  },

  async 'the wipe follows pointer and keys'(page) {
    const value = () => page.getAttribute('#divider', 'aria-valuenow').then(Number);
    const box = await page.locator('#divider').boundingBox();
    await page.mouse.move(box.x + 12, box.y + 100);
    await page.mouse.down();
    await page.mouse.move(box.x - 296, box.y + 100, {steps: 3});
    await page.mouse.up();
    await settle(page);
    assert.equal(await value(), 25);
    await page.focus('#divider');
    await page.keyboard.press('ArrowRight');
    await settle(page);
    assert.equal(await value(), 27);
    await press(page, 'Shift+ArrowLeft');
    assert.equal(await value(), 25);
  },

  async 'the table sorts and marks the best'(page) {
    const first = () => page.locator('#error-table tbody th').allTextContents();
    const heading = page.getByRole('button', {name: 'Sort by against path, RMSE, radiance, lower is better'});
    await heading.click();
    assert.equal((await first())[0], 'hierarchical "fine" </script>');
    assert.equal(await page.locator('th[aria-sort="ascending"]').count(), 1);
    await heading.press('Enter');
    assert.equal((await first())[0], 'none');
    await page.getByRole('button', {name: 'against screen, PSNR'}).click();
    assert.equal(await page.locator('th[aria-sort="descending"]').count(), 1);
    // One for each column with a number: two times, and three metrics against two references.
    assert.equal(await page.locator('#error-table .best').count(), 8);
    assert.equal(await page.locator('#error-table tbody tr', {hasText: 'none'}).locator('td').first().textContent(), '0');
  },

  async 'the plot shows each entry'(page) {
    assert.equal(await page.locator('#scatter-plot .dot').count(), 2);
    assert.equal(await page.locator('#scatter-plot .baseline').count(), 1);
    assert.match(await page.textContent('#scatter-plot'), /RMSE in radiance \(lower is better\)/);
    await page.selectOption('#scatter-metric', 'psnr');
    assert.match(await page.textContent('#scatter-plot'), /PSNR in dB \(higher is better\)/);
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
        return {id: element.id, name: element.outerHTML.slice(0, 80), visible: outlined(null) || outlined('::after')};
      });
      if (focused === null) break;
      assert.ok(focused.visible, `no focus is seen on ${focused.name}`);
      reached.push(focused.id);
    }
    for (const id of ['left', 'swap', 'right', 'exposure', 'tone-map', 'stage', 'divider', 'map-scale', 'scatter-metric', 'copy'])
      assert.ok(reached.includes(id), `${id} is not reached`);
  },

  async 'every control has a name'(page) {
    const nameless = await page.evaluate(() => [...document.querySelectorAll('button, select, input, [tabindex]')]
      .filter((e) => !(e.labels?.length || e.getAttribute('aria-label') || e.textContent.trim()))
      .map((e) => e.outerHTML.slice(0, 80)));
    assert.deepEqual(nameless, []);
  },

  async 'the command is copied'(page) {
    await page.click('#copy');
    await page.waitForFunction(() => document.getElementById('copy').textContent === 'Copied');
  },
};

// Contrast as WCAG 2 defines it, of an element's text against the page.
const contrast = (page, selector) => page.evaluate((s) => {
  const light = (color) => {
    const [r, g, b] = color.match(/\d+/g).map((code) => (code / 255 <= 0.04045 ? code / 255 / 12.92 : ((code / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const [a, b] = [getComputedStyle(document.querySelector(s)).color, getComputedStyle(document.body).backgroundColor].map(light);
  return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
}, selector);

const otherPages = {
  async 'light and dark can be read'() {
    const backgrounds = [];
    for (const dark of [false, true]) {
      const page = await open('full', {dark});
      await settle(page);
      assert.ok(await contrast(page, 'body') > 12);
      for (const quiet of ['dt', 'thead th', '.best']) assert.ok(await contrast(page, quiet) > 4.5, quiet);
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
        await page.setViewportSize({width, height: 900});
        await settle(page);
        assert.ok(await overflow(page) <= 0, `${name} at ${width} px`);
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
    const page = await open('full', {before: () => { delete globalThis.DecompressionStream; }});
    assert.match(await page.textContent('#warnings'), /lacks DecompressionStream/);
    assert.ok(await page.isHidden('#viewer'));
    assert.equal(await page.locator('#error-table tbody tr').count(), 3);
    assert.deepEqual(page.faults, []);
    await page.close();
  },

  async 'figures have pictures, marks, curves and tables'() {
    const page = await open('figures');
    assert.deepEqual(await page.evaluate(() => [...document.images].map((image) => image.naturalWidth)), [192, 192]);
    assert.equal(await page.locator('.mark.over').count(), 1);
    assert.equal(await page.locator('.curve').count(), 3);
    assert.deepEqual(await page.locator('tbody tr').nth(1).locator('td').allTextContents(), ['–', '61']);
    assert.equal(await page.title(), 'Figures of <a paper>');
    await page.close();
  },
};

let failed = 0;
async function run(name, test) {
  const start = performance.now();
  try {
    await test();
    console.log(`ok      ${name} (${Math.round(performance.now() - start)} ms)`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}\n${error.stack}`);
  }
}

const page = await open('full');
for (const [name, test] of Object.entries(tests))
  await run(name, async () => {
    page.faults.length = 0;
    await page.reload();
    await settle(page);
    await test(page);
    assert.deepEqual(page.faults, []);
  });
await page.close();
for (const [name, test] of Object.entries(otherPages)) await run(name, test);

await browser.close();
rmSync(folder, {recursive: true});
process.exit(failed === 0 ? 0 : 1);
