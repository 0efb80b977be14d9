// SPDX-License-Identifier: Apache-2.0
// The page does what it says, by mouse and by keyboard, and shows the record's numbers.
import assert from 'node:assert/strict';
import {readFileSync, statSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {folder, launch, open} from './browser.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const record = name =>
    readFileSync(join(folder, name, 'record.jsonl'), 'utf8').trim().split('\n').map(line => JSON.parse(line));
const median = values => {
  const sorted = [...values].sort((a, b) => a - b), half = sorted.length >> 1;
  return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
};
const choose = (page, section, label, words) =>
    page.locator(`#${section} label.control`, {hasText: label}).first().locator('select').selectOption({label: words});

test('every chart draws, and nothing goes wrong', async () => {
  for (const name of ['compare', 'gate', 'single', 'two', 'sweep', 'evil']) {
    const page = await open(browser, name);
    const own = {sweep: ['sweeps'], gate: ['strips']};
    for (const section of ['pareto', 'passes', 'samples', ...(own[name] ?? [])]) {
      const charts = page.locator(`#${section} svg[role=group]`);
      assert.ok(await charts.count() > 0, `${name}: #${section} has no chart`);
      for (const chart of await charts.all())
        assert.ok(await chart.locator('circle, path, rect, line').count() > 2, `${name}: #${section} is empty`);
    }
    assert.deepEqual(page.faults, [], name);
    await page.context().close();
  }
});

test('the pareto chart\'s figures are the record\'s', async () => {
  const cells = record('compare').filter(line => line.kind === 'cell');
  const page = await open(browser, 'compare');
  await choose(page, 'pareto', 'Over', 'view grazing');
  const words =
      await page.locator('#pareto circle[role=button]').evaluateAll(dots => dots.map(dot => dot.getAttribute('aria-label')));
  const shown = cells.filter(cell => cell.view === 'grazing' && cell.status === 'ok');
  assert.equal(words.length, shown.length);
  for (const cell of shown) {
    const ms = median(cell.passes[0].ms.map((first, i) => first + cell.passes[1].ms[i]));
    const ssim = cell.baseline ? 1 : cell.error.baseline.ssim;
    assert.ok(
        words.some(
            label => label.startsWith(cell.variant) && label.includes(`, ${+ ms.toPrecision(4)} [`) &&
                label.includes(`SSIM ${+ ssim.toPrecision(4)} `)),
        `${cell.variant}: ${ms} ${ssim} in ${words}`);
  }
  assert.ok(words.find(label => label.startsWith('normal_map_taps')).includes('dominated'));
  assert.ok(words.find(label => label.startsWith('vertex_normal')).includes('worth having'));
  await choose(page, 'pareto', 'Cost', 'fetches a pixel');
  await choose(page, 'pareto', 'Error', 'FLIP');
  const label = await page.locator('#pareto circle[aria-label^="vertex_normal"]').first().getAttribute('aria-label');
  assert.match(label, /8 fetches\/px, FLIP 0.05 to the baseline/);
  await page.context().close();
});

test('the chart names what has no place on it', async () => {
  const page = await open(browser, 'compare');
  assert.match(await page.locator('#pareto .caption').textContent(), /Without a place, .* not known: broken on osmesa\.$/);
  const two = await open(browser, 'two');
  assert.match(
      await two.locator('#pareto .caption').textContent(), /not known: A: abc1234, broken on osmesa; B: def5678, broken/);
  await page.context().close();
  await two.context().close();
});

test('a legend holds what its chart shows, in the colours of the chart beside it', async () => {
  const page = await open(browser, 'compare');
  const legends = await page.locator('#passes div[class*="swatches"]')
                      .evaluateAll(
                          all => all.map(
                              one => [...one.querySelectorAll('span[class*="swatch"]')].map(
                                  swatch => [swatch.textContent, swatch.querySelector('svg').getAttribute('fill')])));
  assert.deepEqual(legends[0], [['composite', 'var(--series-0)'], ['light', 'var(--series-1)']]);
  assert.deepEqual(legends[2], [...legends[0], ['seeds (once)', 'var(--series-2)']], 'what is done once is in no frame');
  await page.context().close();
});

test('a gate\'s answer, what regressed and every check are on the page, with and without a script', async () => {
  for (const script of [true, false]) {
    const page = await open(browser, 'compare', {script});
    assert.match(await page.locator('.verdict').innerText(), /^Gate FAILED: 2 checks: 1 regressed, 1 the same/);
    assert.match(
        await page.locator('details.verdicts[open]').innerText(), /slower \(time\) the composite pass takes 10% longer/);
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

test('a gate\'s strips are drawn, process by process, beside the interval of all', async () => {
  const page = await open(browser, 'gate');
  const section = page.locator('#strips');
  assert.match(await section.locator('h4').textContent(), /vertex_normal on vulkan, view front, pass composite: slower$/);
  assert.equal(await section.locator('g[data-marks="dot"] circle').count(), 16);
  const names = await section.locator('g[data-marks="y-axis tick label"] text').allTextContents();
  assert.deepEqual(names, ['process 1', 'process 2', 'all']);
  await choose(page, 'strips', 'Comparison', 'A/A vertex_normal on vulkan, view front, pass composite');
  assert.deepEqual(
      await section.locator('g[data-marks="y-axis tick label"] text').allTextContents(), ['process 1', 'process 2'],
      'an A/A arm is judged by its frame');
  const bare = await open(browser, 'gate', {script: false});
  await bare.locator('summary', {hasText: 'What each process measured'}).click();
  const table = await bare.locator('table', {hasText: 'by the strips of one process'}).textContent();
  for (const words of ['+10.0% [+8.0%, +12.0%]', '+9.00% ± 0.0', '+11.00% ± 0.0', '+0.00% ± 0.0'])
    assert.ok(table.includes(words), `${words} is not in: ${table}`);
  assert.deepEqual(page.faults, []);
  for (const each of [page, bare]) await each.context().close();
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

test('3,000 cells and 600 pictures open and answer within 3 s, in less than 5 MB', async () => {
  assert.ok(statSync(join(folder, 'large/index.html')).size < 5e6, `${statSync(join(folder, 'large/index.html')).size} bytes`);
  // Seconds of processor time, which other work on the machine does not lengthen as it does the clock's.
  const session = await browser.newBrowserCDPSession();
  const renderers = async () =>
      (await session.send('SystemInfo.getProcessInfo')).processInfo.filter(one => one.type === 'renderer');
  const known = (await renderers()).map(one => one.id);
  const spent_s = async () =>
      (await renderers()).filter(one => !known.includes(one.id)).reduce((sum, one) => sum + one.cpuTime, 0);
  const page = await open(browser, 'large');
  await page.waitForSelector('#samples svg');
  const opened_s = await spent_s();
  assert.ok(opened_s > 0 && opened_s < 3, `opened in ${opened_s} s`);
  await page.locator('#pictures .scrub input').focus();
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => document.querySelector('#pictures output').textContent.includes('thickness 1'));
  const answered_s = await spent_s() - opened_s;
  assert.ok(answered_s < 3, `answered in ${answered_s} s`);
  assert.deepEqual(page.faults, []);
  console.log(`opened in ${opened_s.toFixed(2)} s, answered in ${answered_s.toFixed(2)} s of processor time`);
  await page.context().close();
});
