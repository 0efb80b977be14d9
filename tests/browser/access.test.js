// SPDX-License-Identifier: Apache-2.0
// axe-core finds no serious fault, and nothing is wider than the screen, at every width and in both colour schemes.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath} from 'node:url';

import {launch, open} from './browser.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());
const axe = readFileSync(join(dirname(fileURLToPath(import.meta.url)), 'node_modules/axe-core/axe.min.js'), 'utf8');

for (const [name, widths] of [
         ['compare', [400, 1200, 2400]], ['sweep', [400, 1200, 2400]], ['two', [400]], ['gate', [400, 1200]],
         ['truth', [400, 1200, 2400]], ['evil', [400]]])
  for (const width of widths)
    for (const scheme of ['light', 'dark'])
      test(`${name} at ${width} px, ${scheme}`, async () => {
        const page = await open(browser, name, {width, scheme});
        await page.waitForSelector('#samples svg');
        await page.evaluate(axe);
        const found = await page.evaluate(() => window.axe.run({resultTypes: ['violations']}));
        const faults = found.violations.filter(fault => ['serious', 'critical'].includes(fault.impact));
        assert.deepEqual(
            faults.map(
                fault =>
                    `${fault.id}: ${fault.nodes.slice(0, 3).map(node => `${node.html.slice(0, 200)} ${node.failureSummary}`)}`),
            []);
        const [wide, shown] =
            await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
        assert.ok(wide <= shown, `${wide} px wide on ${shown}`);
        assert.deepEqual(page.faults, []);
        await page.context().close();
      });
