// SPDX-License-Identifier: MIT
// The page of a contact sheet. `open` opens a sample page by name.
import assert from 'node:assert/strict';
import {overflow} from './browser.mjs';

const frame = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
const visibleCards = (page) => page.locator('.card:not([hidden])');
const loadedPictures = (page) =>
  page.evaluate(() => [...document.images].filter((image) => image.naturalWidth > 0).length);

// Runs a test on a page of its own, which must not do what pages should not do.
const onSheet = (open, test) => async () => {
  const page = await open('sheet');
  await page.locator('.card img[src]').first().waitFor();
  await test(page);
  assert.deepEqual(page.faults, []);
  await page.close();
};

export function sheetTests(open) {
  const tests = {
    // 20 scenes of each count from one to three cameras.
    async 'a sheet shows each camera, and what was not drawn'(page) {
      assert.equal(await page.locator('.card').count(), 120);
      assert.equal(await page.locator('.card .scene-warnings').count(), 24);
      assert.deepEqual(await page.locator('#refusals li span:first-child').allTextContents(), [
        'models/bad.glb',
        'models/<b>worse</b>.gltf',
      ]);
      assert.match(await page.textContent('#facts'), /not drawn2/);
    },

    async 'a sheet is no wider than its window'(page) {
      for (const width of [1280, 400]) {
        await page.setViewportSize({width, height: 640});
        await frame(page);
        assert.ok((await overflow(page)) <= 0, `${width} px`);
        await page.locator('.open').first().click();
        await frame(page);
        const box = await page.locator('#large').boundingBox();
        assert.ok(box.x >= 0 && box.x + box.width <= width, `large at ${width} px`);
        await page.click('#close');
      }
    },

    async 'pictures of a sheet come when they are near'(page) {
      const before = await loadedPictures(page);
      assert.ok(before >= 4 && before < 60, `${before} pictures at first`);
      await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
      await page.locator('.card img[src]').last().waitFor();
      await page.waitForFunction(
        (count) => document.querySelectorAll('.card img[src]').length > count,
        before,
      );
      assert.ok((await page.locator('.card img[src]').count()) < 120);
      await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
      assert.equal(await page.locator('.card img[src]').count(), 120);
    },

    async 'the search of a sheet finds names, paths, warnings and reasons'(page) {
      const found = async (text) => {
        await page.fill('#filter', text);
        return [await visibleCards(page).count(), await page.textContent('#shown')];
      };
      assert.deepEqual(await found('SUN added'), [24, '24 of 122']);
      assert.deepEqual(await found('scene 59'), [3, '3 of 122']);
      assert.deepEqual(await found('JSON'), [0, '1 of 122']);
      assert.deepEqual(await found(''), [120, '']);
    },

    async 'a picture of a sheet opens large'(page) {
      const name = () => page.textContent('#large-name');
      await page.locator('.open').nth(1).click();
      await frame(page);
      assert.equal(await name(), 'scene 1');
      assert.ok(await page.evaluate(() => document.getElementById('large').matches(':modal')));
      const [small, large] = await page.evaluate(() =>
        ['.card:nth-child(2) img', '#large-picture'].map((selector) => {
          const image = document.querySelector(selector);
          return {src: image.src, width: image.getBoundingClientRect().width};
        }),
      );
      assert.equal(small.src, large.src);
      assert.ok(large.width > 2 * small.width);
      const facts = await page.textContent('#large-facts');
      assert.match(facts, /camera 0 · 1,001 triangles · loaded in 0.30 ms · exposure −1.50 EV/);
      // Backwards over the beginning to the end.
      await page.keyboard.press('ArrowLeft');
      assert.equal(await name(), 'scene 0');
      assert.equal(await page.locator('#large-warnings li').count(), 2);
      await page.click('#previous');
      assert.equal(await name(), 'scene 59');
      await page.click('#next');
      await page.keyboard.press('Escape');
      assert.ok(await page.isHidden('#large'));
      assert.equal(
        await page.evaluate(() => document.activeElement.querySelector('img')?.alt),
        'scene 0, camera 0',
      );
    },

    async 'a large picture goes on among what the search shows'(page) {
      await page.fill('#filter', 'scene 5');
      await page.locator('.open:visible').last().click();
      await page.keyboard.press('ArrowRight');
      assert.equal(await page.textContent('#large-name'), 'scene 5');
    },
  };
  return Object.fromEntries(
    Object.entries(tests).map(([name, test]) => [name, onSheet(open, test)]),
  );
}
