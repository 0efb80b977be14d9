// SPDX-License-Identifier: Apache-2.0
// Every round's frame time behind each interval, for what the pictures show; then the first drawing of the whole page.
if (page) {
  const section = section_of('samples');
  section.append(element('p', {
    className: 'note',
    textContent:
        'Each dot is the frame time of one round, the first round at the bottom of its row, so that drift shows as a slant. The bar is the median with its interval (* where it covers less than 95%). For the backend, view and point chosen above.'
  }));
  function draw() {
    section.querySelector('.plots')?.remove();
    const grid = section.appendChild(element('div', {className: 'plots'}));
    const cells = like_chosen().filter(cell => cell.samples.length);
    if (!cells.length) {
      grid.append(element('p', {className: 'note', textContent: 'No times are known here.'}));
      return;
    }
    const names = cells.map(cell => cell.variant);
    const dots = cells.flatMap(
        (cell, row) => cell.samples.map((ms, i) => ({ms, y: row + 0.35 - 0.7 * (i + 0.5) / cell.samples.length, cell, i})));
    draw_plot(
        plot_place(grid), [name_of_record(chosen.record), `${chosen.backend}, view ${chosen.view}`].filter(Boolean).join(', '),
        {
          height: 100 + 56 * cells.length,
          marginLeft: 130,
          marginTop: 10,
          x: {label: 'time of a frame, ms', labelAnchor: 'center', labelArrow: 'none', labelOffset: 38, grid: true, zero: true},
          y: {label: null, domain: [cells.length - 0.4, -0.6], ticks: d3.range(cells.length), tickFormat: i => names[i] ?? ''},
          marks: [
            Plot.rect(cells, {
              x1: c => c.ms[1],
              x2: c => c.ms[2],
              y1: (_, i) => i - 0.45,
              y2: (_, i) => i + 0.45,
              fill: 'var(--accent)',
              fillOpacity: 0.18
            }),
            Plot.link(cells, {
              x1: c => c.ms[0],
              x2: c => c.ms[0],
              y1: (_, i) => i - 0.45,
              y2: (_, i) => i + 0.45,
              stroke: 'var(--accent)',
              strokeWidth: 2
            }),
            Plot.dot(dots, {
              x: 'ms',
              y: 'y',
              r: 2,
              fill: 'currentColor',
              fillOpacity: 0.6,
              tip: true,
              title: d => `${d.cell.variant}, round ${d.i + 1}\n${digits(d.ms)} ms\nmedian ${
                  interval_words(d.cell.ms, 'ms')} of ${d.cell.ms[3]}`
            }),
          ],
        },
        900);
  }
  drawn_on_choice(draw);

  const first = page.cells.find(cell => !cell.is_baseline && cell.image && !cell.failed) ?? page.cells[0];
  choose({
    record: first.record,
    effect: first.effect,
    backend: first.backend,
    view: first.view,
    point: first.point,
    variant: first.variant
  });
}
