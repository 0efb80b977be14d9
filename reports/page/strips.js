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
    const rows = shown.processes.map((process, i) => ({
                                       name: `process ${process.number + 1}`,
                                       row: i,
                                       ratio: process.ratio,
                                       low: process.ratio * Math.exp(-2 * process.error),
                                       high: process.ratio * Math.exp(2 * process.error),
                                       strips: process.strips
                                     }));
    if (shown.interval)
      rows.push({
        name: 'all',
        row: rows.length,
        ratio: shown.interval[0],
        low: shown.interval[1],
        high: shown.interval[2],
        strips: []
      });
    const dots = rows.flatMap(
        row => row.strips.map((ratio, i) => ({ratio, y: row.row + 0.35 - 0.7 * (i + 0.5) / row.strips.length, row, i})));
    const all = d3.sort(dots.map(dot => dot.ratio)), margin = shown.margin ?? 0;
    const low = Math.min(1 - 2 * margin, d3.quantileSorted(all, 0.05), d3.min(rows, row => row.low));
    const high = Math.max(1 + 2 * margin, d3.quantileSorted(all, 0.95), d3.max(rows, row => row.high));
    grid.replaceChildren();
    draw_plot(
        plot_place(grid), [name_of_record(shown.record), words(shown)].filter(Boolean).join(', '), {
          height: 100 + 56 * rows.length,
          marginLeft: 90,
          marginTop: 10,
          x: {
            label: 'time of a strip over the old one\'s',
            labelAnchor: 'center',
            labelArrow: 'none',
            labelOffset: 38,
            grid: true,
            domain: [low, high],
            clamp: true
          },
          y: {
            label: null,
            domain: [rows.length - 0.4, -0.6],
            ticks: d3.range(rows.length),
            tickFormat: i => rows[i]?.name ?? ''
          },
          marks:
              [
                Plot.rect(
                    [margin],
                    {x1: 1 - margin, x2: 1 + margin, y1: -0.6, y2: rows.length - 0.4, fill: 'currentColor', fillOpacity: 0.08}),
                Plot.rect(rows, {
                  x1: 'low',
                  x2: 'high',
                  y1: row => row.row - 0.45,
                  y2: row => row.row + 0.45,
                  fill: 'var(--accent)',
                  fillOpacity: 0.3,
                  tip: true,
                  title: row => `${row.name}: ${digits(row.ratio)} [${digits(row.low)}, ${digits(row.high)}]`
                }),
                Plot
                    .link(
                        rows, {
                          x1: 'ratio',
                          x2: 'ratio',
                          y1: row => row.row - 0.45,
                          y2: row => row.row + 0.45,
                          stroke: 'var(--accent)',
                          strokeWidth: 2
                        }),
                Plot.dot(dots, {x: 'ratio', y: 'y', r: 2, fill: 'currentColor', fillOpacity: 0.6}),
              ],
        },
        900);
  }
  drawn_on_choice(draw);
}
