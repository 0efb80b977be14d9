// SPDX-License-Identifier: Apache-2.0
// node page.mjs FOLDER: what it costs to open the page of 3,000 cells and 600 pictures, and to move its pictures one point on, in
// seconds of processor time, and how many times that of a page of 72 cells. FOLDER holds what make_pages makes.
process.env.LAMINA_PAGES = process.argv[2];
const {launch, median, open, scrub} = await import('../tests/browser/browser.js');

const rounds = 5;
const browser = await launch();
const session = await browser.newBrowserCDPSession();
const renderers = async () =>
    (await session.send('SystemInfo.getProcessInfo')).processInfo.filter(one => one.type === 'renderer');
const spent_s = async known =>
    (await renderers()).filter(one => !known.includes(one.id)).reduce((sum, one) => sum + one.cpuTime, 0);

async function cost_of(name) {
  const known = (await renderers()).map(one => one.id);
  const page = await open(browser, name);
  await page.waitForSelector('#samples svg');
  const opened = await spent_s(known);
  await scrub(page);
  const answered = await spent_s(known) - opened;
  await page.context().close();
  return {opened, answered};
}

const small = [], large = [];
for (let round = 0; round < rounds; ++round) small.push(await cost_of('sweep')), large.push(await cost_of('large'));
for (const what of ['opened', 'answered']) {
  const of = costs => median(costs.map(cost => cost[what]));
  const ratios = large.map((cost, round) => cost[what] / small[round][what]);
  console.log(`${what}: ${of(large).toFixed(2)} s of processor time, ${median(ratios).toFixed(1)} times the small page's`);
}
await browser.close();
