// SPDX-License-Identifier: Apache-2.0
// Curves over a swept parameter, with the crossovers that the record holds; the slider moves through the points and pictures.
if (page && section_of('sweeps')) {
  const section = section_of('sweeps');
  const parameters = unique(page.sweeps.map(sweep => sweep.path));
  // `crossing`: the metric of the record's crossovers that are those of these curves.
  const quantities = [
    {
      words: 'time of a frame, ms',
      crossing: 'ratio',
      of: cell => cell.ms?.[0],
      low: cell => cell.ms?.[1],
      high: cell => cell.ms?.[2]
    },
    {
      words: 'time over the baseline\'s',
      crossing: 'ratio',
      of: cell => cell.is_baseline ? null : cell.ratio?.[0],
      low: cell => cell.ratio?.[1],
      high: cell => cell.ratio?.[2]
    },
    {words: 'fetches a pixel', of: cell => cell.fetches},
    ...['baseline', 'truth'].flatMap(
        against => page.metrics.map((metric, i) => ({
                                      words: `${metric.words} to the ${against}`,
                                      metric: metric.name,
                                      crossing: against === 'truth' ? `truth.${metric.name}` : metric.name,
                                      of: cell => cell.is_baseline && against === 'baseline' ? null : cell[against]?.[i]
                                    }))),
  ].filter(quantity => page.cells.some(cell => typeof quantity.of(cell) === 'number'));
  const shown = {parameter: parameters[0], quantity: quantities.find(q => q.metric === 'ssim') ?? quantities[0]};

  // Cells of one curve: all other parameters stand where the choice has them.
  const on_curve = cell => Object.entries(page.points[cell.point])
                               .every(
                                   ([path, value]) => path === shown.parameter || !parameters.includes(path) ||
                                       page.points[chosen.point][path] === value);

  // Figures nearly alike must not look far apart: an SSIM's axis spans 0.01 at least, another's a tenth of its greatest figure.
  function metric_domain(points) {
    const [low, high] = d3.extent(points, p => p.y), least = shown.quantity.metric === 'ssim' ? 0.01 : 0.1 * Math.abs(high);
    const lacking = Math.max(0.04 * (high - low), (least - (high - low)) / 2),
          perfect = shown.quantity.metric === 'ssim' ? 1 : Infinity;
    const top = Math.min(perfect, high + lacking);
    return [Math.min(low - 0.04 * (high - low), top - Math.max(least, high - low)), top];
  }

  // What the lines across the chart are: the record's crossovers are of all views together, the curves of one.
  function line_words(record, effect, crossovers) {
    const views = unique(page.cells.filter(cell => cell.record === record && cell.effect === effect).map(cell => cell.view));
    const timed = shown.quantity.crossing === 'ratio';
    let words = `Dashed: crossing of ${timed ? 'the times over the baseline\'s' : 'the curves'}`;
    if (views.length > 1)
      words = timed ? `${words}, the geometric mean over all ${views.length} views` :
                      `Dashed: crossing of the worst view, at each point whichever of ${views.length} that is; view ${
                          chosen.view}'s curve may cross elsewhere`;
    return `${words}.${crossovers.some(c => c.limit !== null) ? ' Dotted: the limit.' : ''}`;
  }

  function draw_group(grid, cells, crossovers) {
    const {record, effect, backend} = cells[0], unit = unit_of(shown.parameter);
    const value = cell => page.points[cell.point][shown.parameter];
    const points = cells
                       .map(cell => ({
                              cell,
                              x: value(cell),
                              y: shown.quantity.of(cell),
                              low: shown.quantity.low?.(cell),
                              high: shown.quantity.high?.(cell),
                              variant: cell.variant
                            }))
                       .filter(p => typeof p.y === 'number');
    if (!points.length) return;
    const all = unique(page.cells.map(cell => cell.variant)), variants = unique(points.map(p => p.variant));
    const title = [name_of_record(record), effect, backend, `view ${chosen.view}`].filter(Boolean).join(', ');
    const label = `${shown.parameter}${unit ? `, ${unit}` : ''}`;
    const sorted = d3.sort(points, p => p.x);
    draw_plot(plot_place(grid), title, {
      ariaLabel: `${title}: ${shown.quantity.words} over ${label}`,
      x: {label, labelAnchor: 'center', labelArrow: 'none', labelOffset: 38, grid: true},
      y: {
        label: shown.quantity.words,
        labelArrow: 'none',
        grid: true,
        ...(shown.quantity.metric ? {domain: metric_domain(points)} : {zero: true})
      },
      color: {legend: true, domain: variants, range: variants.map(variant => `var(--series-${all.indexOf(variant) % 10})`)},
      marks: [
        Plot.ruleX(
            crossovers,
            {x: 'at', stroke: 'currentColor', strokeDasharray: '4 3', strokeOpacity: 0.7, title: 'sentence', tip: true}),
        Plot.ruleY(
            unique(crossovers.map(c => c.limit).filter(limit => limit !== null)),
            {stroke: 'currentColor', strokeDasharray: '1 3'}),
        Plot.areaY(
            sorted.filter(p => typeof p.low === 'number'),
            {x: 'x', y1: 'low', y2: 'high', z: 'variant', fill: 'variant', fillOpacity: 0.2}),
        Plot.line(sorted, {x: 'x', y: 'y', stroke: 'variant', strokeWidth: 2}),
        Plot.ruleX([page.points[chosen.point][shown.parameter]], {stroke: 'var(--accent)', strokeWidth: 2, strokeOpacity: 0.5}),
        Plot.tip(sorted, Plot.pointer({
          x: 'x',
          y: 'y',
          title: p => `${p.variant}\n${shown.parameter} ${digits(p.x)} ${unit ?? ''}\n${shown.quantity.words} ${digits(p.y)}`
        })),
      ],
    });
    if (!crossovers.length) return;
    grid.lastChild.append(
        element('p', {className: 'note caption', textContent: line_words(record, effect, crossovers)}),
        element('ul', {className: 'note'}, ...crossovers.map(c => element('li', {textContent: c.sentence}))));
  }

  const place = section.appendChild(element('div', {className: 'controls'}));
  const update_slider = add_point_slider(section);
  function draw() {
    update_slider();
    const change = (field, value) => (shown[field] = value, draw());
    replace_controls(place, [
      drop_down('Parameter', parameters.map(path => [path, path]), shown.parameter, value => change('parameter', value)),
      drop_down('Figure', quantities.map(q => [q, q.words]), shown.quantity, value => change('quantity', value)),
      drop_down('View', page.views.map(view => [view, view]), chosen.view, view => choose_near({view})),
    ]);
    section.querySelector('.plots')?.remove();
    const grid = section.appendChild(element('div', {className: 'plots'}));
    const cells = page.cells.filter(
        cell => !cell.failed && cell.view === chosen.view && shown.parameter in page.points[cell.point] && on_curve(cell));
    for (const group of d3.group(cells, cell => JSON.stringify([cell.record, cell.effect, cell.backend])).values()) {
      const {record, effect, backend} = group[0];
      draw_group(
          grid, group,
          page.crossovers.filter(
              c => c.record === record && c.effect === effect && c.backend === backend && c.parameter === shown.parameter &&
                  c.at !== null && Object.entries(c.held).every(([path, value]) => page.points[chosen.point][path] === value) &&
                  (c.metric === shown.quantity.crossing ||
                   (shown.quantity.crossing === 'ratio' && c.metric.endsWith(',ratio')))));
    }
  }
  drawn_on_choice(draw);
}
