// SPDX-License-Identifier: Apache-2.0
// A headless chromium whose pages note what goes wrong: console errors, exceptions, and requests that leave the disk.
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
