// SPDX-License-Identifier: Apache-2.0
// The strips behind a gate's times. page.strips: comparisons {record, words, margin, processes: [{number, ratio, error, strips:
// [ratio]}]}, and where one was judged {verdict, interval: [median, low, high, strips, coverage]}.
if (page && page.strips.length) {
  const section = section_of('strips');
  section.append(element('p', {
    className: 'note',
    textContent:
        'Each dot is the time of one strip of the new tree over that of the same strip of the old, timed right beside it; the first strip of a process stands at the bottom of its row. The bar of a process is its ratio with twice the standard error, that of all is the interval the verdict rests on. The band is the margin. Dots at an edge lie beyond it.'
  }));
  const controls = section.appendChild(element('div', {className: 'controls'}));
  const grid = section.appendChild(element('div', {className: 'plots'}));
  const words = one => `${one.words}${one.verdict ? `: ${one.verdict}` : ''}`;
  let shown = page.strips.find(one => one.verdict && one.verdict !== 'same') ?? page.strips[0];

  function draw() {
    replace_controls(controls, [drop_down('Comparison', page.strips.map(one => [one, words(one)]), shown, one => {
                       shown = one;
                       draw();
                     })]);
    const rows = shown.processes.map(process => ({
                                       name: `process ${process.number + 1}`,
                                       middle: process.ratio,
                                       low: process.ratio * Math.exp(-2 * process.error),
                                       high: process.ratio * Math.exp(2 * process.error),
                                       samples: process.strips
                                     }));
    if (shown.interval) {
      const [middle, low, high] = shown.interval;
      rows.push({name: 'all', middle, low, high, samples: []});
    }
    const all = d3.sort(rows.flatMap(row => row.samples)), margin = shown.margin ?? 0;
    const low = Math.min(1 - 2 * margin, d3.quantileSorted(all, 0.05), d3.min(rows, row => row.low));
    const high = Math.max(1 + 2 * margin, d3.quantileSorted(all, 0.95), d3.max(rows, row => row.high));
    grid.replaceChildren();
    draw_strip_plot(plot_place(grid), [name_of_record(shown.record), words(shown)].filter(Boolean).join(', '), rows, {
      x: {label: 'time of a strip over the old one\'s', domain: [low, high], clamp: true},
      margin_left: 90,
      bar_words: row => `${row.name}: ${digits(row.middle)} [${digits(row.low)}, ${digits(row.high)}]`,
      behind: [Plot.rect(
          [margin], {x1: 1 - margin, x2: 1 + margin, y1: -0.6, y2: rows.length - 0.4, fill: 'currentColor', fillOpacity: 0.08})]
    });
  }
  drawn_on_choice(draw);
}
