// SPDX-License-Identifier: MIT
// What one does with the pictures of the page `full` of sample_pages.
import assert from 'node:assert/strict';
import {settle} from './browser.mjs';

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
const canvasPixels = (page, places) =>
  page.evaluate((at) => {
    const {width, height} = document.getElementById('canvas');
    const copy = new OffscreenCanvas(width, height).getContext('2d', {willReadFrequently: true});
    copy.drawImage(document.getElementById('canvas'), 0, 0);
    const {data} = copy.getImageData(0, 0, width, height);
    return at.map(([x, y]) => [...data.subarray((y * width + x) * 4, (y * width + x) * 4 + 3)]);
  }, places);

// Where the picture's corner lies at 1:1.
const cornerAtOne = (page) =>
  page.evaluate(({width, height}) => {
    const canvas = document.getElementById('canvas');
    return [Math.round(canvas.width / 2 - width / 2), Math.round(canvas.height / 2 - height / 2)];
  }, kPicture);

// Tests by name; each gets a page that has just been loaded. `expected` are the pixels that
// sample_pages wrote down.
export const viewerTests = (expected) => ({
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
        const pixels = expected.filter(
          (pixel) => pixel.tone_map === toneMap && pixel.stops === stops,
        );
        const shown = await canvasPixels(
          page,
          pixels.map(({x, y}) => [left + x, top + y]),
        );
        // The page's light is off by up to 1 / 400, less than half a code of the steepest curve, so
        // rounding may fall on the neighbour.
        shown.forEach((rgb, i) =>
          rgb.forEach((code, c) =>
            assert.ok(
              Math.abs(code - pixels[i].display[c]) <= 1,
              `${toneMap}, ${stops} stops: ${rgb} is not that of ${JSON.stringify(pixels[i])}`,
            ),
          ),
        );
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
      linear.forEach((value, c) =>
        assert.ok(
          Math.abs(Number(cells[c]) / value - 1) < 1 / 400 + 1 / 200,
          `${cells[c]} is not ${value}`,
        ),
      );
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
    assert.ok(Math.abs((await zoomOf(page)) / fit - 2) < 0.02);
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
    assert.ok((await zoomOf(page)) > fit * 1.5);
    assert.equal(
      /pixel .*/.exec(await stageText(page))[0],
      /pixel .*/.exec(below)[0],
      'the pixel below the pointer stays',
    );
    await page.mouse.down();
    await page.mouse.move(stage.x + 400, stage.y + 200, {steps: 4});
    await page.mouse.up();
    await settle(page);
    assert.equal(
      /pixel .*/.exec(await stageText(page))[0],
      /pixel .*/.exec(below)[0],
      'and goes along when dragged',
    );
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
    const row = await canvasPixels(
      page,
      Array.from({length: 160}, (_, x) => [300 + x, 200]),
    );
    const changes = row.slice(1).filter((rgb, i) => String(rgb) !== String(row[i])).length;
    assert.ok(changes > 5 && changes <= 20, `${changes} changes of colour in 20 magnified pixels`);
  },

  async 'exposure brightens both pictures and resets'(page) {
    const places = [
      [200, 200],
      [1000, 200],
    ];
    const before = await canvasPixels(page, places);
    await press(page, ']', ']', ']');
    assert.match(await page.textContent('#exposure-value'), /\+1\.50 stops \(EV 2\.00\)/);
    const after = await canvasPixels(page, places);
    after.forEach((rgb, i) =>
      assert.ok(rgb[1] > before[i][1], `${rgb} is not brighter than ${before[i]}`),
    );
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
});
