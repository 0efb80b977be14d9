// SPDX-License-Identifier: Apache-2.0
// Where the time goes: passes stacked for each variant, beside them operations by class, fetches by texture, and what a fetch
// costs.
if (page) {
  const section = section_of('passes');
  // A legend of these names alone, of which each has its colour by its place in all.
  const colour_of = (name, all) => `var(--series-${all.indexOf(name) % 10})`;
  const legend_of = (names, all) => ({legend: true, domain: names, range: names.map(name => colour_of(name, all))});
  const bars = (place, title, label, rows, x, fill, words, all) => draw_plot(place, title, {
    height: 110 + 34 * unique(rows.map(row => row.variant)).length,
    marginLeft: 130,
    marginTop: 10,
    x: {label, labelAnchor: 'center', labelArrow: 'none', labelOffset: 38, grid: true, nice: true},
    y: {label: null, domain: unique(rows.map(row => row.variant))},
    color: legend_of(unique(rows.map(row => row[fill])), all),
    marks: [
      Plot.barX(rows, {y: 'variant', x, fill, title: words, tip: true, stroke: 'var(--page)', strokeWidth: 1}), Plot.ruleX([0])
    ],
  });

  function draw() {
    section.querySelector('.passes-of')?.remove();
    const all = element('div', {className: 'passes-of'});
    section.append(all);
    for (const passes of d3.group(page.passes, p => JSON.stringify([p.record, p.effect, p.backend])).values()) {
      const {record, effect, backend} = passes[0];
      all.append(element('h3', {textContent: [name_of_record(record), effect, backend].filter(Boolean).join(', ')}));
      const grid = all.appendChild(element('div', {className: 'plots'}));
      const names = unique(passes.map(p => p.pass));
      const timed = passes.filter(p => p.ms !== null && !p.once);
      if (timed.length)
        bars(
            plot_place(grid), 'Time of a frame, by pass', 'ms', timed, 'ms', 'pass',
            p => `${p.variant}: ${p.pass}\n${digits(p.ms)} ms`, names);
      const operations = passes.filter(p => !p.once)
                             .flatMap(p => p.operations.map(one => ({...one, variant: p.variant, pass: p.pass})))
                             .sort((a, b) => d3.ascending(a.group, b.group));
      if (operations.length)
        bars(
            plot_place(grid), 'Operations a pixel, by class', 'operations a covered pixel', operations, 'per_pixel', 'group',
            o => `${o.variant}: ${o.operation}\n${digits(o.per_pixel)} a pixel, in ${o.pass}`,
            unique(operations.map(o => o.group)));
      const shares =
          passes.filter(p => !p.once)
              .flatMap(
                  p => p.shares.map(
                      share => ({...share, variant: p.variant, pass: p.pass, key: `${share.texture} (${share.format})`})));
      if (shares.length)
        bars(
            plot_place(grid), 'Fetches a pixel, by texture and format', 'fetches a covered pixel', shares, 'per_pixel', 'key',
            s => `${s.variant}: ${s.texture}\n${s.format}, ${s.filter}${s.level === null ? '' : `, level ${digits(s.level)}`}\n${
                digits(s.per_pixel)} a pixel, in ${s.pass}`,
            unique(shares.map(s => s.key)));
      const costs = passes.filter(p => p.ns_per_fetch !== null).map(p => ({...p, label: p.pass + (p.once ? ' (once)' : '')}));
      const labels = unique(costs.map(p => p.label));
      // Where passes of the same kind of work pay very different prices, fetches are not what costs there.
      const max_price_ratio = 4;
      const [min, max] = d3.extent(costs, p => p.ns_per_fetch);
      if (costs.length && max > max_price_ratio * min)
        all.append(element('p', {
          className: 'note',
          textContent: `Fetches are not what costs here: a pass takes from ${digits(min)} to ${
              digits(max)} ns for each of its fetches, so their price is not drawn.`
        }));
      else if (costs.length)
        draw_plot(plot_place(grid), 'What a fetch costs, all of its pass counted in', {
          height: 110 + 34 * unique(costs.map(p => p.variant)).length,
          marginLeft: 130,
          marginTop: 10,
          x: {
            label: 'ns a fetch',
            labelAnchor: 'center',
            labelArrow: 'none',
            labelOffset: 38,
            grid: true,
            zero: true,
            nice: true
          },
          y: {label: null, domain: unique(costs.map(p => p.variant)), type: 'band'},
          color: {
            legend: true,
            domain: labels,
            range: labels.map(label => colour_of(costs.find(p => p.label === label).pass, names))
          },
          // A variant's passes stand on a slant within its band, so that those that cost alike do not hide each other.
          marks: d3.groups(
                       costs,
                       p => {
                         const own = costs.filter(other => other.variant === p.variant), last = own.length - 1;
                         return last ? 18 * own.indexOf(p) / last - 9 : 0;
                       })
                     .map(([dy, dots]) => Plot.dot(dots, {
                       y: 'variant',
                       x: 'ns_per_fetch',
                       fill: 'label',
                       r: 4.5,
                       dy,
                       tip: true,
                       title: p => `${p.variant}: ${p.label}\n${digits(p.ns_per_fetch)} ns a fetch`
                     })),
        });
    }
    if (page.passes.length && page.points.length > 1)
      all.append(
          element('p', {className: 'note', textContent: 'Means over the points at which passes were timed or counted.'}));
    if (!page.passes.length) all.append(element('p', {className: 'note', textContent: 'No pass was measured.'}));
  }
  let width = 0;
  drawn_on_choice(() => {
    if (window.innerWidth !== width) draw();
    width = window.innerWidth;
  });
}
