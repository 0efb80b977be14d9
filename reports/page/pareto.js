// SPDX-License-Identifier: Apache-2.0
// Cost against error: a plot for each effect, record and backend, the frontier drawn. A dot leads to its pictures.
if (page && section_of('pareto')) {
  const section = section_of('pareto');
  const knows = (all, cost) => all.some(one => one[cost] !== null);
  const costs = [['ms', 'time of a frame'], ['fetches', 'fetches a pixel']].filter(([cost]) => knows(page.cells, cost));
  const shown = {against: 'baseline', metric: 0, view: null};  // view null: the mean over all
  [shown.cost] = costs.find(([cost]) => knows(page.rows, cost)) ?? costs[0];
  // A sweep that times or counts at some of its points has no mean over all of them.
  if (!knows(page.rows, shown.cost)) shown.view = page.views[0];
  const bit_of = () =>
      ((shown.against === 'truth' ? page.metrics.length : 0) + shown.metric) * 2 + (shown.cost === 'ms' ? 0 : 1);

  // Where figures stand on the axis: nines of SSIM, decibels, decades of an error. What is perfect has no place there (PSNR is
  // infinite, an error 0) and stands by itself at the end.
  const nines =
      [0, 0.5, 0.8, 0.9, 0.95, 0.98, ...d3.range(2, 6).flatMap(k => [1, 0.5, 0.2].map(f => +(1 - f * 10 ** -k).toFixed(7)))];
  const scales = {
    ssim: {
      place: v => -Math.log10(1 - v),
      value: at => 1 - 10 ** -at,
      least: 0.6,
      perfect: 1,
      words: '1',
      ticks: ([low, high]) => high - low < 2 ? nines : [0, 0.5, 0.9, 0.99, 0.999, 0.9999, 0.99999, 0.999999]
    },
    psnr_db: {
      place: v => v,
      value: at => at,
      least: 6,
      perfect: null,
      words: 'same',
      ticks: ([low, high]) => d3.ticks(low, high, 8)
    },
  };
  const decade_scale = {
    place: Math.log10,
    value: at => 10 ** at,
    least: 0.6,
    perfect: 0,
    words: '0',
    ticks: ([low, high]) => [1, 2, 5].flatMap(f => decades([10 ** low, 10 ** high], f))
  };
  const scale_of = () => scales[page.metrics[shown.metric].name] ?? decade_scale;
  // The axis over these points: its domain, where the perfect stand, and ticks as a map from place to words.
  function error_axis(points) {
    const scale = scale_of(), up = page.metrics[shown.metric].more_is_closer ? 1 : -1;
    const places = points.filter(p => p.value !== scale.perfect).map(p => scale.place(p.value));
    let [low, high] = places.length ? d3.extent(places) : [0, 1];
    const lacking = Math.max(0, scale.least - (high - low)) / 2;  // figures nearly alike must not look far apart
    low -= lacking, high += lacking;
    const room = 0.14 * (high - low);
    const perfect = (up > 0 ? high : low) + 1.6 * up * room;
    const has_perfect = points.some(p => p.value === scale.perfect);
    const domain =
        up > 0 ? [low - room, (has_perfect ? perfect : high) + room] : [(has_perfect ? perfect : low) - room, high + room];
    const inside = [low - room, high + room];
    const ticks = new Map(
        scale.ticks(inside)
            .map(v => [scale.place(v), `${+ v.toPrecision(8)}`])
            .filter(([at]) => at >= inside[0] && at <= inside[1] && (!has_perfect || Math.abs(at - perfect) > room / 2)));
    if (ticks.size < 3)
      for (const value of d3.ticks(...d3.extent(inside.map(scale.value)), 4))
        ticks.set(scale.place(value), `${+ value.toPrecision(6)}`);
    if (has_perfect) ticks.set(perfect, scale.words);
    return {domain, ticks, place: value => value === scale.perfect ? perfect : scale.place(value)};
  }

  function points_of(effect) {
    const from = shown.view === null ?
        page.rows :
        page.cells.filter(cell => cell.view === shown.view && cell.point === chosen.point && !cell.failed);
    const points =
        from.filter(one => one.effect === effect && one[shown.against] && (shown.cost === 'ms' ? one.ms : one.fetches !== null))
            .map(one => ({
                   one,
                   name: one.variant,
                   frontier: (one.frontier >>> bit_of() & 1) === 1,
                   not_told: ((one.not_told ?? 0) >>> bit_of() & 1) === 1,
                   x: shown.cost === 'ms' ? one.ms[0] : one.fetches,
                   low: shown.cost === 'ms' ? one.ms[1] : one.fetches,
                   high: shown.cost === 'ms' ? one.ms[2] : one.fetches,
                   value: one[shown.against][shown.metric],
                 }));
    const axis = error_axis(points);
    for (const point of points) point.y = axis.place(point.value);
    return [points, axis];
  }

  const standing_words = point => point.frontier ? 'worth having' :
      point.not_told                             ? 'not told apart from a closer one: more rounds would tell' :
      point.one.beyond_limit                     ? 'beyond the limit of error: not recommended' :
                                                   'dominated';
  const words_of = point => {
    const metric = page.metrics[shown.metric];
    const cost = shown.cost === 'ms' ? interval_words(point.one.ms, 'ms') : `${digits(point.x)} fetches/px`;
    const error = point.value === null ? `the same picture as the ${shown.against}` :
                                         `${metric.words} ${figure_words(metric, point.value)} to the ${shown.against}`;
    return `${point.name}${point.one.is_baseline ? ' (baseline)' : ''}\n${cost}\n${error}\n${
        standing_words(point)}`;
  };
  const lead_to_pictures = point => {
    const view = shown.view ?? chosen.view;
    choose_near({record: point.one.record, effect: point.one.effect, backend: point.one.backend, view, variant: point.name});
    section_of('pictures').scrollIntoView({block: 'start'});
    section_of('pictures').querySelector('select, input, button')?.focus({preventScroll: true});
  };

  function draw_group(grid, effect, points, cost_domain, axis) {
    const metric = page.metrics[shown.metric], {record, backend} = points[0].one;
    const title = [name_of_record(record), effect, backend].filter(Boolean).join(', ');
    const error_words = `${metric.words} to the ${shown.against}: ${metric.more_is_closer ? 'higher' : 'lower'} is closer`;
    const log = cost_domain[0] > 0,
          cost_words = `${shown.cost === 'ms' ? 'time of a frame, ms: left is faster' : 'fetches a pixel: left is cheaper'}${
              log ? ' (log scale)' : ''}`;
    const svg = draw_plot(plot_place(grid), title, {
      ariaLabel: `${title}: ${error_words}, over ${cost_words}`,
      x: {
        label: cost_words,
        labelAnchor: 'center',
        labelArrow: 'none',
        labelOffset: 38,
        grid: true,
        domain: cost_domain,
        ...(log ? {type: 'log', ticks: [1, 2, 5].flatMap(f => decades(cost_domain, f)), tickFormat: tick} : {})
      },
      y: {
        label: error_words,
        labelArrow: 'none',
        grid: true,
        domain: axis.domain,
        ticks: [...axis.ticks.keys()],
        tickFormat: at => axis.ticks.get(at)
      },
      marks: [
        Plot.line(
            points.filter(p => p.frontier),
            {x: 'x', y: 'y', sort: 'x', curve: 'step-after', stroke: 'var(--accent)', strokeWidth: 1.5}),
        Plot.ruleY(points, {y: 'y', x1: 'low', x2: 'high', strokeWidth: 2, strokeOpacity: 0.6}),
        Plot.dot(points, {
          x: 'x',
          y: 'y',
          r: 5,
          stroke: 'var(--accent)',
          fill: dot_fill,
          strokeOpacity: p => p.one.beyond_limit && !p.frontier ? 0.35 : 1,
          title: words_of,
          tip: true,
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
      drop_down('Cost', costs, shown.cost, value => change('cost', value)),
      drop_down('Error', page.metrics.map((metric, i) => [i, metric.words]), shown.metric, value => change('metric', value)),
      drop_down(
          'Against', [['baseline', 'the baseline'], ...(truth ? [['truth', 'the truth']] : [])], shown.against,
          value => change('against', value)),
      drop_down(
          'Over', [[null, 'all views (mean)'], ...page.views.map(view => [view, `view ${view}`])], shown.view,
          value => change('view', value)),
    ]);
    section.querySelector('.plots')?.remove();
    section.querySelector('.caption')?.remove();
    section.append(grid);
    let drawn = 0;
    const left_out = [];
    for (const effect of unique(page.rows.map(row => row.effect))) {
      const [points, axis] = points_of(effect);
      for (const row of page.rows)
        if (row.effect === effect &&
            !points.some(p => p.name === row.variant && p.one.record === row.record && p.one.backend === row.backend))
          left_out.push([name_of_record(row.record), `${row.variant} on ${row.backend}${
              row.failed?.startsWith('not a picture') ? ' (not a picture)' : row.failed ? ' (failed)' : ''}`].filter(Boolean).join(', '));
      if (!points.length) continue;
      const low = d3.min(points, p => p.low), high = d3.max(points, p => p.high);
      const cost_domain = low > 0 && high > 5 * low ? [low / 1.3, high * (high / low) ** 0.3] : [0, high * 1.3];
      for (const group of d3.group(points, p => `${p.one.record} ${p.one.backend}`).values())
        drawn += (draw_group(grid, effect, group, cost_domain, axis), 1);
    }
    const at_point = shown.view !== null && page.points.length > 1 ? ` At the point ${point_words(chosen.point)}.` :
        shown.view === null && page.points.length > 1 ? ' Means over all points too.' :
                                                        '';
    const more = left_out.length > 6 ? `; and ${left_out.length - 6} more` : '';
    const without_place = left_out.length ?
        ` Without a place, since ${shown.cost === 'ms' ? 'their time' : 'their fetches'} or error is not known: ${
            left_out.slice(0, 6).join('; ')}${more}.` :
        '';
    section.append(element('p', {
      className: 'note caption',
      textContent: drawn ? 'Filled dots on the line are worth having: nothing closer is as cheap. Hollow ones are dominated; ' +
              'half-filled ones are not told apart from a closer one, and faint ones are beyond the limit of error. ' +
              'Bars are 95% intervals of the time; a dot leads to its pictures. The axis of errors is stretched so that small ' +
              'ones stay apart; what is perfect stands at its end.' + at_point + without_place :
                           'The record has nothing to draw here: no such cost or error is known.' + at_point
    }));
  }
  drawn_on_choice(draw);
}
