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
    const rows = cells.map(({variant, ms, samples}) => ({name: variant, middle: ms[0], low: ms[1], high: ms[2], samples, ms}));
    draw_strip_plot(
        plot_place(grid), [name_of_record(chosen.record), `${chosen.backend}, view ${chosen.view}`].filter(Boolean).join(', '),
        rows, {
          x: {label: 'time of a frame, ms', zero: true},
          margin_left: 130,
          words: (row, i) => `${row.name}, round ${i + 1}\n${digits(row.samples[i])} ms\nmedian ${
              interval_words(row.ms, 'ms')} of ${row.ms[3]}`
        });
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
