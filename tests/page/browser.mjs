// SPDX-License-Identifier: MIT
// A headless Chromium that cannot reach the network, and pages that report what they should not do.
import {existsSync} from 'node:fs';
import {pathToFileURL} from 'node:url';
import {skip} from '../support/node_test.mjs';

const kBrowser = process.env.LUEUR_CHROMIUM ?? '/usr/bin/chromium';

export async function startBrowser() {
  if (!existsSync(kBrowser)) skip(`${kBrowser} is missing: run \`./run setup\``);
  const playwright = await import('playwright-core').catch(() =>
    skip('playwright-core is missing: run `./run test`, or `npm ci` in tests/page'),
  );
  try {
    return await playwright.chromium.launch({
      executablePath: kBrowser,
      timeout: 15000,
      args: [
        '--headless',
        '--no-sandbox',
        '--disable-gpu',
        '--disable-quic',
        '--no-first-run',
        '--disable-background-networking',
        '--disable-component-update',
        '--disable-sync',
        '--host-resolver-rules=MAP * ~NOTFOUND',
      ],
    });
  } catch (error) {
    return skip(`${kBrowser} does not start: ${error.message.split('\n')[0]}`);
  }
}

// Opens a file. `page.faults` lists errors, dialogs and requests for anything else.
export async function openPage(browser, file, {width = 1280, dark = false, before} = {}) {
  const page = await browser.newPage({
    viewport: {width, height: 640},
    colorScheme: dark ? 'dark' : 'light',
  });
  page.setDefaultTimeout(5000);
  const url = pathToFileURL(file).href;
  page.faults = [];
  page.on('pageerror', (error) => page.faults.push(`error: ${error.message}`));
  page.on('console', (message) => page.faults.push(`console: ${message.text()}`));
  page.on('request', (request) => {
    if (
      request.url() !== url &&
      !request.url().startsWith('data:') &&
      !request.url().startsWith('blob:')
    )
      page.faults.push(`request: ${request.url()}`);
  });
  page.on('dialog', (dialog) => {
    page.faults.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  if (before) await page.addInitScript(before);
  await page.goto(url);
  return page;
}

// Waits until everything has been drawn that is going to be.
export async function settle(page) {
  await page.waitForFunction(
    () => document.querySelectorAll('script[id^="picture-"]').length === 0,
  );
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );
}

// By how many pixels the page is wider than its window.
export const overflow = (page) =>
  page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
