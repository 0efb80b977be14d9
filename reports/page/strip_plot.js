// SPDX-License-Identifier: Apache-2.0
// Samples in rows, each row with its estimate and interval: for every round's time, and for the strips behind a gate's.
// Rows: [{name, middle, low, high, samples}]; the first sample stands at the bottom of its row. words(row, i): what a sample's
// tip says; of a row's bar where bar_words is given. `behind`: marks below all others.
function draw_strip_plot(place, title, rows, {x, margin_left, words, bar_words, behind = []}) {
  const dots = rows.flatMap(
      (row, at) => row.samples.map(
          (sample, i) => ({sample, y: at + 0.35 - 0.7 * (i + 0.5) / row.samples.length, words: words?.(row, i)})));
  const span = {y1: (_, i) => i - 0.45, y2: (_, i) => i + 0.45};
  const tip = (title, given) => given ? {tip: true, title} : {};
  draw_plot(
      place, title, {
        height: 100 + 56 * rows.length,
        marginLeft: margin_left,
        marginTop: 10,
        x: {labelAnchor: 'center', labelArrow: 'none', labelOffset: 38, grid: true, ...x},
        y: {label: null, domain: [rows.length - 0.4, -0.6], ticks: d3.range(rows.length), tickFormat: i => rows[i]?.name ?? ''},
        marks: [
          ...behind,
          Plot.rect(rows, {
            x1: 'low',
            x2: 'high',
            ...span,
            fill: 'var(--accent)',
            fillOpacity: 0.25,
            ...tip(row => bar_words(row), bar_words)
          }),
          Plot.link(rows, {x1: 'middle', x2: 'middle', ...span, stroke: 'var(--accent)', strokeWidth: 2}),
          Plot.dot(dots, {x: 'sample', y: 'y', r: 2, fill: 'currentColor', fillOpacity: 0.6, ...tip(dot => dot.words, words)}),
        ],
      },
      900);
}
