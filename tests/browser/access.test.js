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

// A page is opened once in each scheme, and then made wider.
for (const [name, widths] of [
         ['compare', [400, 1200, 2400]], ['sweep', [400, 1200, 2400]], ['two', [400]], ['gate', [400, 1200]],
         ['truth', [400, 1200, 2400]], ['evil', [400]]])
  for (const scheme of ['light', 'dark'])
    test(`${name} at ${widths.join(', ')} px, ${scheme}`, async () => {
      const page = await open(browser, name, {width: widths[0], scheme});
      await page.waitForSelector('#samples svg');
      await page.evaluate(axe);
      for (const width of widths) {
        await page.setViewportSize({width, height: 900});
        const found = await page.evaluate(() => window.axe.run({resultTypes: ['violations']}));
        const faults = found.violations.filter(fault => ['serious', 'critical'].includes(fault.impact));
        assert.deepEqual(
            faults.map(
                fault =>
                    `${fault.id}: ${fault.nodes.slice(0, 3).map(node => `${node.html.slice(0, 200)} ${node.failureSummary}`)}`),
            [], `${width} px`);
        const [wide, shown] =
            await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
        assert.ok(wide <= shown, `${wide} px wide on ${shown}`);
      }
      assert.deepEqual(page.faults, []);
      await page.context().close();
    });
