// SPDX-License-Identifier: Apache-2.0
// Every chart draws, answers to mouse and keyboard, and shows the record's numbers.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';

import {choose, launch, median, open, record} from './browser.js';

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

test('every chart draws, and nothing goes wrong', async () => {
  for (const name of ['compare', 'gate', 'single', 'two', 'sweep', 'evil', 'truth']) {
    const page = await open(browser, name);
    const own = {sweep: ['#sweeps'], gate: ['#strips'], truth: ['figure.chart']};
    for (const section of ['#pareto', '#passes', '#samples', ...(own[name] ?? [])]) {
      const charts = page.locator(`${section} svg[role=group]`);
      assert.ok(await charts.count() > 0, `${name}: ${section} has no chart`);
      for (const chart of await charts.all())
        assert.ok(await chart.locator('circle, path, rect, line').count() > 2, `${name}: ${section} is empty`);
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

test('the price of a fetch is drawn only where fetches are what costs', async () => {
  for (const [name, drawn] of [['compare', true], ['computing', false]]) {
    const page = await open(browser, name);
    assert.equal(await page.locator('#passes', {hasText: 'What a fetch costs'}).count() > 0, drawn, name);
    assert.equal(await page.locator('#passes', {hasText: 'Fetches are not what costs here'}).count() > 0, !drawn, name);
    await page.context().close();
  }
});

test('no cost is offered that nothing is known of', async () => {
  const costs = page => page.locator('#pareto label.control', {hasText: 'Cost'}).locator('option').allTextContents();
  for (const [name, words] of [['sweep', ['time of a frame', 'fetches a pixel']], ['counted', ['fetches a pixel']]]) {
    const page = await open(browser, name);
    assert.deepEqual(await costs(page), words);
    assert.ok(await page.locator('#pareto circle[role=button]').count() > 0, name);
    await page.context().close();
  }
  const page = await open(browser, 'errors');
  assert.equal(await page.locator('#pareto').count(), 0);
  assert.ok(await page.locator('#sweeps svg[role=group] path').count() > 0);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test('a sweep\'s dashed line says of which view it is, and stands where its figure is shown', async () => {
  const page = await open(browser, 'sweep');
  const words = () => page.locator('#sweeps .caption').allTextContents();
  const dashes = () => page.locator('#sweeps line[stroke-dasharray="4 3"], #sweeps g[stroke-dasharray="4 3"] line').count();
  for (const view of ['view1', 'view0']) {
    await choose(page, 'sweeps', 'View', view);
    assert.deepEqual(await words(), [`Dashed: crossing of the worst view, at each point whichever of 2 that is; view ${
                                        view}'s curve may cross elsewhere. Dotted: the limit.`]);
    assert.equal(await dashes(), 1);
  }
  await choose(page, 'sweeps', 'Figure', 'time of a frame, ms');
  assert.deepEqual([await words(), await dashes()], [[], 0]);
  const single = await open(browser, 'errors');
  assert.deepEqual(
      await single.locator('#sweeps .caption').allTextContents(), ['Dashed: crossing of the curves. Dotted: the limit.']);
  await single.context().close();
  await page.context().close();
});

test('of a grid a chart shows the crossings at the values that are held', async () => {
  const page = await open(browser, 'grid');
  const shown = () => page.locator('#sweeps .plot li').allTextContents();
  const sentence = (variant, at, gain) =>
      `${variant} keeps SSIM at least 0.98 up to thickness ${at} texels (within 0), at gain ${gain} on vulkan`;
  const both = (at, gain) => ['normal_map_taps', 'vertex_normal'].map(variant => sentence(variant, at, gain));
  const first = await shown();
  assert.deepEqual(first.map(words => words.replace(/within [^)]*/, 'within 0')), both(8, 1));
  await page.locator('#sweeps input[type=range]').focus();
  await page.keyboard.press('ArrowRight');
  assert.deepEqual((await shown()).map(words => words.replace(/within [^)]*/, 'within 0')), both(4, 2));
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test('every tick of a logarithmic axis has its number', async () => {
  const page = await open(browser, 'truth');
  await choose(page, 'pareto', 'Cost', 'fetches a pixel');
  await choose(page, 'pareto', 'Over', 'view front');
  const labels = await page.locator('#pareto g[data-marks="x-axis tick label"] text').allTextContents();
  assert.deepEqual([...labels].sort((a, b) => a - b), ['5', '10', '20', '50', '100', '200', '500']);
  await page.context().close();
});

test('the chart names what has no place on it', async () => {
  const page = await open(browser, 'compare');
  assert.match(await page.locator('#pareto .caption').textContent(), /Without a place, .* not known: broken on osmesa \(failed\)\.$/);
  const two = await open(browser, 'two');
  assert.match(
      await two.locator('#pareto .caption').textContent(), /not known: A: abc1234, broken on osmesa \(failed\); B: def5678, broken/);
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

test('switches of cost, error and what it is against work by keyboard, and show the record\'s figures', async () => {
  const cells = record('truth').filter(line => line.kind === 'cell');
  const page = await open(browser, 'truth');
  const list = label => page.locator('#pareto label.control', {hasText: label}).locator('select');
  const words = () =>
      page.locator('#pareto circle[role=button]').evaluateAll(dots => dots.map(dot => dot.getAttribute('aria-label')));
  const shows = async (name, field, against) => {
    for (const cell of cells) {
      const error = cell.error[against]?.[field];
      if (error === undefined) continue;
      const label = (await words()).find(one => one.startsWith(cell.variant));
      assert.ok(label.includes(`${name} ${+ error.toPrecision(4)} to the ${against}`), `${name} ${error} is not in ${label}`);
    }
  };
  await list('Against').focus();
  await page.keyboard.press('ArrowDown');
  await shows('SSIM', 'ssim', 'truth');
  await list('Error').focus();
  for (const [name, field] of [
           ['PSNR, dB', 'psnr_db'], ['FLIP', 'flip'], ['max, linear', 'max_linear'], ['RMSE, linear', 'rmse_linear']]) {
    await page.keyboard.press('ArrowDown');
    assert.match(
        await page.locator('#pareto svg[role=group]').getAttribute('aria-label'), new RegExp(`: ${name} to the truth`));
    await shows(name, field, 'truth');
  }
  await list('Against').focus();
  await page.keyboard.press('ArrowUp');
  await shows('RMSE, linear', 'rmse_linear', 'baseline');
  await list('Over').focus();
  await page.keyboard.press('ArrowDown');
  await list('Cost').focus();
  await page.keyboard.press('ArrowDown');
  for (const cell of cells)
    assert.ok(
        (await words()).some(one => one.startsWith(cell.variant) && one.includes(`${cell.fetches_per_pixel} fetches/px`)));
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test('a switch works by mouse', async () => {
  const page = await open(browser, 'truth');
  const list = page.locator('#pareto label.control', {hasText: 'Error'}).locator('select');
  await list.scrollIntoViewIfNeeded();  // the table of choices stands above it
  const box = await list.boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await page.waitForFunction(
      () => document.querySelector('#pareto svg[role=group]').getAttribute('aria-label').includes('PSNR, dB to the baseline'));
  await page.context().close();
});

test('the frontier joins what is worth having, by the error that is chosen', async () => {
  const page = await open(browser, 'truth');
  const filled = () => page.locator('#pareto circle[role=button]')
                           .evaluateAll(
                               dots => dots.filter(dot => dot.getAttribute('aria-label').includes('worth having'))
                                           .map(dot => dot.getAttribute('aria-label').split(',')[0]));
  assert.deepEqual((await filled()).sort(), ['light_map (baseline)', 'vertex_normal']);
  await choose(page, 'pareto', 'Against', 'the truth');
  assert.deepEqual(await filled(), ['vertex_normal'], 'closest to the truth, and fastest');
  await page.context().close();
});

test('hovering says what stands there: a cell, a pass, a sample', async () => {
  const cells = record('compare').filter(line => line.kind === 'cell');
  const page = await open(browser, 'compare');
  const tip_of = async (section, mark) => {
    const chart = page.locator(`${section} svg[role=group]`).first();
    await chart.scrollIntoViewIfNeeded();
    const box = await chart.locator(mark).first().boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2, {steps: 3});
    const tip = chart.locator('g[aria-label="tip"]');
    await page.waitForFunction(tip => tip.textContent !== '', await tip.first().elementHandle());
    return (await tip.allTextContents()).join(' ');
  };
  assert.match(await tip_of('#pareto', 'circle[aria-label^="vertex_normal"]'), /vertex_normal.*ms.*SSIM 0\.9 to the baseline/s);
  const pass = cells[0].passes[0], views = cells.filter(cell => cell.backend === 'vulkan' && cell.variant === 'light_map');
  const ms = views.reduce((sum, cell) => sum + median(cell.passes[0].ms), 0) / views.length;
  const bar = await tip_of('#passes', 'g[data-marks="bar"] rect');
  assert.ok(bar.includes(`light_map: ${pass.name}`) && bar.includes(`${+ ms.toPrecision(4)} ms`), `${ms}: ${bar}`);
  assert.match(await tip_of('#samples', 'g[data-marks="dot"] circle'), /light_map, round \d+.*ms/s);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test('functions: the chart, the table and the failed inputs are the record\'s', async () => {
  const lines = record('truth');
  const page = await open(browser, 'truth');
  for (const backend of ['vulkan', 'osmesa']) {
    const svg = page.locator(`figure.chart svg[aria-label$="${backend}"]`);
    const timed = lines.filter(line => line.kind === 'function_time' && line.backend === backend);
    assert.equal(await svg.locator('g[data-marks="dot"] circle').count(), timed.length);
    const table = await page.locator('table', {hasText: `${backend}, llvmpipe: 1000 points of 'overlaps'`}).textContent();
    for (const line of timed) {
      assert.ok((await svg.textContent()).includes(line.variant));
      assert.ok(table.includes(`${+ line.ns_per_call.median.toPrecision(3)} [`), `${line.ns_per_call.median}: ${table}`);
    }
    for (const line of lines.filter(line => line.kind === 'function' && line.backend === backend))
      assert.ok(table.includes(`${+ line.max_over.toPrecision(3)}`.replace('0.000001', '1e-06')), `${line.max_over}: ${table}`);
  }
  const words = await page.locator('ul.verdicts').first().innerText();
  assert.match(words, /naive_cap.*FAILS on 1: overlaps.*the first at 3 2 1/s);
  assert.ok(await page.locator('.slices img').count() >= 6);
  assert.deepEqual(page.faults, []);
  const bare = await open(browser, 'truth', {script: false});
  const strips = await bare.locator('.rounds svg[aria-label$="ns a call"]')
                     .evaluateAll(all => all.map(strip => ({
                                                   label: strip.getAttribute('aria-label'),
                                                   dots: strip.querySelector('.dots').getAttribute('d').split('m').length - 1,
                                                   height: strip.getBoundingClientRect().height
                                                 })));
  const times = lines.filter(line => line.kind === 'function_time');
  assert.equal(strips.length, times.length);
  times.forEach((line, i) => {
    assert.equal(strips[i].dots, line.ns.length);
    assert.ok(strips[i].height > 10);
    assert.equal(
        strips[i].label,
        `12 rounds, ${+ Math.min(...line.ns).toPrecision(3)} to ${+ Math.max(...line.ns).toPrecision(3)} ns a call`);
  });
  await bare.context().close();
  await page.context().close();
});
