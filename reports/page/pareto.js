// SPDX-License-Identifier: Apache-2.0
// Cost against error: a plot for each effect, record and backend, the frontier drawn. A dot leads to its pictures.
if (page) {
  const section = section_of('pareto');
  const shown = {cost: 'ms', against: 'baseline', metric: 0, view: null};  // view null: the mean over all
  if (!page.rows.some(row => row.ms)) shown.cost = 'fetches';
  const bit_of = () => ((shown.against === 'truth' ? page.metrics.length : 0) + shown.metric) * 2 + (shown.cost === 'ms' ? 0 : 1);

  // A picture equal to its reference has no PSNR; it stands above all others.
  const top_psnr = points => 1.1 * Math.max(30, ...points.filter(p => p.y !== null).map(p => p.y));

  function points_of(effect) {
    const from = shown.view === null ? page.rows : page.cells.filter(cell => cell.view === shown.view && cell.point === chosen.point && !cell.failed);
    const points = from.filter(one => one.effect === effect && one[shown.against] && (shown.cost === 'ms' ? one.ms : one.fetches !== null)).map(one => ({
      one, name: one.variant, frontier: (one.frontier >>> bit_of() & 1) === 1,
      x: shown.cost === 'ms' ? one.ms[0] : one.fetches, low: shown.cost === 'ms' ? one.ms[1] : one.fetches,
      high: shown.cost === 'ms' ? one.ms[2] : one.fetches, y: one[shown.against][shown.metric],
    }));
    const top = top_psnr(points);
    for (const point of points) if (point.y === null) Object.assign(point, {y: top, identical: true});
    return points;
  }

  const words_of = point => {
    const metric = page.metrics[shown.metric];
    const cost = shown.cost === 'ms' ? interval_words(point.one.ms, 'ms') : `${digits(point.x)} fetches/px`;
    const error = point.identical ? 'the same picture' : `${metric.words} ${digits(point.y)} to the ${shown.against}`;
    return `${point.name}${point.one.is_baseline ? ' (baseline)' : ''}\n${cost}\n${error}\n${point.frontier ? 'worth having' : 'dominated'}`;
  };
  const lead_to_pictures = point => {
    const view = shown.view ?? chosen.view;
    choose_near({record: point.one.record, effect: point.one.effect, backend: point.one.backend, view, variant: point.name});
    section_of('pictures').scrollIntoView({block: 'start'});
    section_of('pictures').querySelector('select, input, button')?.focus({preventScroll: true});
  };

  function draw_group(grid, effect, points, domains) {
    const metric = page.metrics[shown.metric], {record, backend} = points[0].one;
    const title = [name_of_record(record), effect, backend].filter(Boolean).join(', ');
    const error_words = `${metric.words} to the ${shown.against}: ${metric.more_is_closer ? 'higher' : 'lower'} is closer`;
    const cost_words = shown.cost === 'ms' ? 'time of a frame, ms: left is faster' : 'fetches a pixel: left is cheaper';
    const svg = draw_plot(plot_place(grid), title, {
      ariaLabel: `${title}: ${error_words}, over ${cost_words}`,
      x: {label: cost_words, labelAnchor: 'center', labelArrow: 'none', labelOffset: 38, grid: true, domain: domains.x, nice: false},
      y: {label: error_words, labelArrow: 'none', grid: true, domain: domains.y},
      marks: [
        Plot.line(points.filter(p => p.frontier), {x: 'x', y: 'y', sort: 'x', curve: 'step-after', stroke: 'var(--accent)', strokeWidth: 1.5}),
        Plot.ruleY(points, {y: 'y', x1: 'low', x2: 'high', strokeWidth: 2, strokeOpacity: 0.6}),
        Plot.dot(points, {
          x: 'x', y: 'y', r: 5, stroke: 'var(--accent)', fill: p => p.frontier ? 'var(--accent)' : 'var(--page)', title: words_of, tip: true,
        }),
      ],
    });
    name_points(svg, points);
    press_dots(svg, points, point => words_of(point).replaceAll('\n', ', ') + ': show its pictures', lead_to_pictures);
  }

  function draw() {
    const grid = element('div', {className: 'plots'});
    const controls = element('div', {className: 'controls'});
    const change = (field, value) => (shown[field] = value, draw());
    const truth = page.rows.some(row => row.truth);
    replace_controls(section.querySelector('.controls') ?? section.appendChild(controls), [
      drop_down('Cost', [['ms', 'time of a frame'], ['fetches', 'fetches a pixel']], shown.cost, value => change('cost', value)),
      drop_down('Error', page.metrics.map((metric, i) => [i, metric.words]), shown.metric, value => change('metric', value)),
      drop_down('Against', [['baseline', 'the baseline'], ...(truth ? [['truth', 'the truth']] : [])], shown.against, value => change('against', value)),
      drop_down('Over', [[null, 'all views (mean)'], ...page.views.map(view => [view, `view ${view}`])], shown.view, value => change('view', value)),
    ]);
    section.querySelector('.plots')?.remove();
    section.querySelector('.caption')?.remove();
    section.append(grid);
    let drawn = 0;
    for (const effect of unique(page.rows.map(row => row.effect))) {
      const points = points_of(effect);
      if (!points.length) continue;
      const high = d3.max(points, p => p.high), y = d3.extent(points, p => p.y), room = (y[1] - y[0] || Math.abs(y[1]) || 1) * 0.12;
      const metric = page.metrics[shown.metric];
      const domains = {
        x: [0, high * 1.3],
        y: metric.more_is_closer ? [y[0] - room, metric.name === 'ssim' ? Math.min(y[1] + room / 2, 1 + room / 2) : y[1] + room / 2] : [-room / 3, y[1] + room],
      };
      for (const group of d3.group(points, p => `${p.one.record} ${p.one.backend}`).values()) drawn += (draw_group(grid, effect, group, domains), 1);
    }
    const at_point = shown.view !== null && page.points.length > 1 ? ` At the point ${point_words(chosen.point)}.` : shown.view === null && page.points.length > 1 ? ' Means over all points too.' : '';
    section.append(element('p', {className: 'note caption', textContent: drawn ? 'Filled dots on the line are worth having: nothing closer is as cheap. Hollow ones are dominated. Bars are 95% intervals of the time; a dot leads to its pictures.' + (page.metrics[shown.metric].name === 'psnr_db' ? ' A picture equal to its reference has no PSNR and is drawn at the top.' : '') + at_point : 'The record has nothing to draw here: no such cost or error is known.'}));
  }
  drawn_on_choice(draw);
}
