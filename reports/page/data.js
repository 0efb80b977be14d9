// SPDX-License-Identifier: Apache-2.0
// What the page draws, and what of it is chosen. page.rows are variants over all their views, page.cells single pictures; both
// have {record, effect, variant, backend, is_baseline, frontier, ms, ratio: [median, low, high, rounds, coverage], fetches,
// baseline, truth: figures in the order of page.metrics}; what is not known is null, "truth" is left out, and so are not_told
// (bits, as frontier), beyond_limit (true) and failed (the first reason) where they do not hold. A cell has
// besides {view, point: an index of page.points, samples in ms, size, worst_tile, failed: the reason, and the paths image,
// difference, flip, truth_image, before_image}. page.crossovers are the record's lines, with the values of the other parameters
// at which each was found, by path, in `held`.
const page_data = document.getElementById('page-data');
const page = page_data && JSON.parse(page_data.textContent);
if (page)
  for (const cell of page.cells)
    for (const [name, list] of [['effect', 'effects'], ['variant', 'variants'], ['backend', 'backends'], ['view', 'views']])
      cell[name] = page[list][cell[name]];

const unique = values => [...new Set(values)];
const digits = value => value === null || value === undefined ? 'unknown' : `${+value.toPrecision(4)}`;
// A figure of page.metrics; close to 1, SSIM needs all the digits that there are.
const figure_words = (metric, value) => metric.name === 'ssim' ? `${+value.toFixed(6)}` : digits(value);
const interval_words = (ms, unit) =>
    ms ? `${digits(ms[0])} [${digits(ms[1])}, ${digits(ms[2])}]${ms[4] < 0.95 ? '*' : ''} ${unit}` : 'not timed';
const name_of_record = record => page.records[record].name;

// The cell that the pictures show on the right, and what is beside it: 'baseline', 'truth' or another variant.
const chosen = {};
const watchers = [];
// Changes the choice and draws what depends on it again.
function choose(change) {
  Object.assign(chosen, change);
  for (const watcher of watchers) watcher();
}
// Cells that agree with the choice but for the fields given here.
const like_chosen = (fields = {}) => {
  const want = {
    record: chosen.record,
    effect: chosen.effect,
    backend: chosen.backend,
    view: chosen.view,
    point: chosen.point,
    ...fields
  };
  return page.cells.filter(
      cell => Object.entries(want).every(([field, value]) => value === undefined || cell[field] === value));
};
// Chooses, and keeps what else is chosen as far as there are cells of it: later fields give way to earlier ones.
function choose_near(change) {
  const next = {...chosen, ...change};
  let left = page.cells;
  for (const field of ['record', 'effect', 'backend', 'view', 'point', 'variant']) {
    const fit = left.filter(cell => cell[field] === next[field]);
    left = fit.length ? fit : left.filter(cell => cell[field] === left[0][field]);
    next[field] = left[0][field];
  }
  choose(next);
}
// What parts a point from the others; all that is known of it where it is the only one.
const varies = path => page.points.length < 2 || page.points.some(point => point[path] !== page.points[0][path]);
const unit_of = path => page.sweeps.find(sweep => sweep.path === path)?.unit;
const point_words = point => Object.entries(page.points[point])
                                 .filter(([path]) => varies(path))
                                 .map(([path, value]) => `${path} ${digits(value)}${unit_of(path) ? ` ${unit_of(path)}` : ''}`)
                                 .join(', ');
