// SPDX-License-Identifier: Apache-2.0
// The page does what it says, by mouse and by keyboard, and shows the record's numbers.
import assert from 'node:assert/strict';
import {statSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {choose, folder, launch, median, open, record, scrub} from './browser.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

test('a gate\'s answer, what regressed and every check are on the page, with and without a script', async () => {
  for (const script of [true, false]) {
    const page = await open(browser, 'compare', {script});
    assert.match(await page.locator('.verdict').innerText(), /^Gate FAILED: 2 checks: 1 regressed, 1 the same/);
    assert.match(
        await page.locator('details.verdicts[open]').innerText(), /slower \(time, interval\) the composite pass takes 10% longer/);
    assert.equal(await page.locator('details.printed[open] tr.bad').count(), 1);
    await page.context().close();
  }
});

test('a dot leads to its pictures, by mouse and by keyboard', async () => {
  for (const press of [dot => dot.click(), async dot => (await dot.focus(), dot.press('Enter'))]) {
    const page = await open(browser, 'compare');
    await press(page.locator('#pareto svg[aria-label*="osmesa"] circle[aria-label^="vertex_normal"]'));
    assert.match(await page.locator('#pictures h3').textContent(), /vertex_normal on osmesa/);
    assert.match(await page.locator('#pictures .over').getAttribute('src'), /vertex_normal-osmesa-front\.png$/);
    await page.waitForFunction(() => document.querySelector('#pictures').getBoundingClientRect().top < 500);
    await page.context().close();
  }
});

test('numbers next to the pictures are the record\'s', async () => {
  const page = await open(browser, 'compare');
  await choose(page, 'pictures', 'View', 'grazing');
  await choose(page, 'pictures', 'Right', 'vertex_normal');
  const cell = record('compare').find(
      line => line.variant === 'vertex_normal' && line.view === 'grazing' && line.backend === 'vulkan' && line.kind === 'cell');
  const words = await page.locator('#pictures .viewer dl').textContent();
  for (const value
           of [cell.error.baseline.ssim, cell.error.baseline.flip, cell.ratio_to_baseline.median, cell.ratio_to_baseline.low,
               cell.fetches_per_pixel])
    assert.ok(words.match(/\d+(\.\d+)?/g).map(Number).includes(+value.toPrecision(4)), `${value} is not in: ${words}`);
  assert.ok(words.includes('from 32, 0'));
  const box = await page.locator('#pictures .compare .tile').evaluate(tile => [tile.style.left, tile.style.width]);
  assert.deepEqual(box, ['50%', '50%']);
  await page.context().close();
});

test('slider and flip work by mouse and keyboard', async () => {
  const page = await open(browser, 'compare');
  const clip = () => page.locator('#pictures .over').evaluate(image => image.style.clipPath);
  const wipe = page.locator('#pictures .wipe input');
  await wipe.focus();
  await page.keyboard.press('Home');
  assert.match(await clip(), /0%\)$/);
  await page.keyboard.press('ArrowRight');
  assert.match(await clip(), / 1%\)$/);
  const box = await wipe.boundingBox();
  await page.mouse.click(box.x + box.width * 0.75, box.y + box.height / 2);
  const at = +(await clip()).match(/([\d.]+)%\)$/)[1];
  assert.ok(at > 70 && at < 80, `${at}`);
  const button = page.locator('#pictures .flip-key');
  await button.click();
  assert.match(await clip(), /100%\)$/);
  assert.equal(await button.getAttribute('aria-pressed'), 'true');
  await page.keyboard.press('f');
  assert.match(await clip(), / 0%\)$|\(0(px)? 0(px)? 0(px)? 0%\)$/);
  assert.match(await button.textContent(), /showing normal_map_taps/);
  await page.context().close();
});

test('a gate\'s pictures begin with before and after', async () => {
  const page = await open(browser, 'gate');
  const left = page.locator('#pictures label.control', {hasText: 'Left'}).locator('select');
  const chosen = () => left.evaluate(select => select.selectedOptions[0].textContent);
  await choose(page, 'pictures', 'Right', 'normal_map_taps');
  assert.equal(await chosen(), 'normal_map_taps before the change');
  const sources = await page.locator('#pictures .compare img').evaluateAll(images => images.map(image => image.src));
  assert.match(sources[0], /before-light_map\.png$/);
  assert.match(sources[1], /normal_map_taps-vulkan-front\.png$/);
  await page.locator('#pictures .compare .stage').focus();
  await page.keyboard.press('ArrowRight');
  await page.waitForSelector('#pictures .values');
  assert.match(await page.locator('#pictures .values').first().textContent(), /^sRGB \d+, \d+, 10$/, 'pixels of before');
  await left.selectOption({label: 'light_map (baseline)'});
  assert.match(await page.locator('#pictures .compare img').first().getAttribute('src'), /light_map-vulkan-front\.png$/);
  await choose(page, 'pictures', 'Right', 'vertex_normal');
  assert.equal(await chosen(), 'light_map (baseline)', 'nothing is known of it before');
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test('the magnifier shows the same pixel of every picture', async () => {
  for (const name of ['compare', 'single', 'two']) {
    const page = await open(browser, name);
    const stage = page.locator('#pictures .difference .stage');
    await stage.scrollIntoViewIfNeeded();
    const box = await stage.boundingBox();
    await page.mouse.move(box.x + box.width * (20.5 / 64), box.y + box.height * (10.5 / 48));
    await page.waitForSelector('#pictures .values');
    assert.match(await page.locator('#pictures .viewer > .note').textContent(), /Pixel 20, 10/);
    const values = () => page.locator('#pictures .values').allTextContents();
    assert.deepEqual((await values()).slice(0, 2), ['sRGB 20, 10, 10', 'sRGB 20, 10, 200'], name);
    assert.equal((await values())[2], '2.5, 1.3, 0 of 255');
    assert.equal(await page.locator('#pictures .cross:visible').count(), 3);
    await page.locator('#pictures .compare .stage').focus();
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Shift+ArrowDown');
    await page.waitForFunction(() => document.querySelector('#pictures .values')?.textContent === 'sRGB 21, 20, 10');
    assert.deepEqual(page.faults, [], name);
    await page.context().close();
  }
});

test('scrubbing the parameter moves through the pictures', async () => {
  const page = await open(browser, 'sweep');
  const picture = () => page.locator('#pictures .over').getAttribute('src');
  assert.match(await picture(), /-0-0\.png$/);
  await page.locator('#sweeps input[type=range]').focus();
  for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
  assert.match(await picture(), /-0-3\.png$/);
  assert.equal(await page.locator('#sweeps output').textContent(), 'objects.heart.thickness 3 texels');
  assert.match(await page.locator('#sweeps').textContent(), /keeps SSIM at least 0.98 up to thickness 4.8 texels/);
  await page.locator('#pictures .scrub input').focus();
  await page.keyboard.press('End');
  assert.match(await picture(), /-0-11\.png$/);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

const ms_words = ms => ms.toFixed(ms >= 100 ? 1 : ms >= 10 ? 2 : 3);
test('the tables hold the record\'s figures, cell by cell', async () => {
  for (const script of [true, false]) {
    const page = await open(browser, 'compare', {script});
    const tables =
        await page.locator('details.group')
            .evaluateAll(
                groups => groups.map(
                    group => [group.querySelector('summary').textContent, group.querySelector('table').textContent]));
    const cells = record('compare').filter(line => line.kind === 'cell');
    for (const cell of cells) {
      const [, table] = tables.find(([words]) => words.startsWith(`${cell.effect} on ${cell.backend}, view ${cell.view} `));
      const figures = cell.status === 'failed' ? [cell.reason] : [
        ms_words(median(cell.passes[0].ms.map((first, i) => first + cell.passes[1].ms[i]))),
        cell.fetches_per_pixel.toFixed(1),
        ...(cell.baseline ? [] :
                            [
                              cell.error.baseline.ssim.toFixed(4),
                              cell.error.baseline.flip.toFixed(4),
                              cell.error.baseline.psnr_db.toFixed(1),
                              cell.ratio_to_baseline.median.toFixed(3),
                            ]),
      ];
      for (const figure of [cell.variant, ...figures]) assert.ok(table.includes(figure), `${figure} is not in ${table}`);
    }
    await page.context().close();
  }
});

test('every round stands in a strip without a script', async () => {
  const cells = record('compare').filter(line => line.kind === 'cell');
  const page = await open(browser, 'compare', {script: false});
  const strip = page.locator('details[open] .rounds svg').first();
  await strip.scrollIntoViewIfNeeded();
  assert.ok((await strip.boundingBox()).width > 200);
  assert.match(await strip.getAttribute('aria-label'), new RegExp(`^${cells[0].passes[0].ms.length} rounds, `));
  assert.equal((await strip.locator('.dots').getAttribute('d')).match(/m/g).length, cells[0].passes[0].ms.length);
  await page.context().close();
});

test('text of the record stays text', async () => {
  const page = await open(browser, 'evil');
  for (const control of await page.locator('#pareto select').all()) await control.selectOption({index: 0});
  assert.equal(await page.evaluate(() => window.evil), undefined);
  assert.equal(await page.locator('img[src="x"]').count(), 0);
  assert.ok((await page.locator('h1').textContent()).length > 0);
  assert.ok((await page.locator('#pictures h3').textContent()).includes('<script>window.evil=1</script>'));
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test('tables and pictures read without a script', async () => {
  const page = await open(browser, 'compare', {script: false});
  assert.ok(await page.locator('table').count() > 3);
  assert.match(await page.locator('body').innerText(), /vertex_normal/);
  const picture = page.locator('details[open] img').first();
  await picture.scrollIntoViewIfNeeded();
  assert.ok(await picture.evaluate(image => image.width) > 50);
  assert.match(await page.locator('noscript').first().innerText(), /drawn by a script/);
  await page.context().close();
});

test('two records stand side by side', async () => {
  const page = await open(browser, 'two');
  const words = await page.locator('body').innerText();
  assert.match(words, /A: abc1234/);
  assert.match(words, /B: def5678/);
  assert.equal(await page.locator('#pareto svg[role=group]').count(), 4);
  await choose(page, 'pictures', 'Record', 'B: def5678');
  await choose(page, 'pictures', 'Left', 'normal_map_taps of A: abc1234');
  assert.match(await page.locator('#pictures .compare img').first().getAttribute('src'), /^\.\/a\/images/);
  assert.match(await page.locator('#pictures .over').getAttribute('src'), /^\.\/b\/images/);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

// How long it takes is measured by bench/page.mjs; what makes it long, the size of the file and of the page, is held here.
test('3,000 cells and 600 pictures open and answer, in less than 5 MB and 32 elements a cell', async () => {
  assert.ok(statSync(join(folder, 'large/index.html')).size < 5e6, `${statSync(join(folder, 'large/index.html')).size} bytes`);
  const page = await open(browser, 'large');
  await page.waitForSelector('#samples svg');
  await scrub(page);
  const elements = await page.locator('*').count();
  assert.ok(elements > 3000 && elements < 32 * 3000, `${elements} elements`);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});
