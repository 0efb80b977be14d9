// SPDX-License-Identifier: Apache-2.0
// A headless chromium whose pages note what goes wrong: console errors, exceptions, and requests that leave the disk.
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {chromium} from 'playwright-core';

export const folder = process.env.LAMINA_PAGES;
export const launch = () => chromium.launch({executablePath: '/usr/bin/chromium', args: ['--no-sandbox']});

// The page of the folder `name`, opened from disk. page.faults gathers what went wrong.
export async function open(browser, name, options = {}) {
  const context = await browser.newContext({
    viewport: {width: options.width ?? 1200, height: 900},
    colorScheme: options.scheme ?? 'light',
    javaScriptEnabled: options.script ?? true
  });
  const page = await context.newPage();
  page.faults = [];
  page.on('console', message => message.type() === 'error' && page.faults.push(message.text()));
  page.on('pageerror', error => page.faults.push(error.message));
  page.on('request', request => !/^(file|data|blob):/.test(request.url()) && page.faults.push(`request of ${request.url()}`));
  page.on('requestfailed', request => page.faults.push(`failed request of ${request.url()}`));
  await page.goto(`file://${join(folder, name, 'index.html')}`);
  return page;
}

// The lines of the record of the folder `name`.
export const record = name =>
    readFileSync(join(folder, name, 'record.jsonl'), 'utf8').trim().split('\n').map(line => JSON.parse(line));
export const median = values => {
  const sorted = [...values].sort((a, b) => a - b), half = sorted.length >> 1;
  return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
};
// Chooses from the list of this label in a section.
export const choose = (page, section, label, words) =>
    page.locator(`#${section} label.control`, {hasText: label}).first().locator('select').selectOption({label: words});
// Moves the pictures to the next point of a sweep and waits until they are there.
export async function scrub(page) {
  await page.locator('#pictures .scrub input').focus();
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => document.querySelector('#pictures output').textContent.includes('thickness 1'));
}
