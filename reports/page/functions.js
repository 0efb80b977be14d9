// SPDX-License-Identifier: Apache-2.0
// Draws the data of each figure.chart, the functions': y over x, both logarithmic, a plot for each group on common axes.
// Data: {x, y: the axes' labels, points: [{group, name, x, low, high, y, frontier, not_told}]}; low and high are x's interval.
for (const figure of document.querySelectorAll('figure.chart')) {
  const data = JSON.parse(figure.querySelector('script').textContent);
  const x = [d3.min(data.points, p => p.low) / 1.5, d3.max(data.points, p => p.high) * 1.5];
  const y = [d3.min(data.points, p => p.y) / 3, d3.max(data.points, p => p.y) * 3];
  const axis = {type: 'log', labelArrow: 'none', tickFormat: tick, grid: true};
  for (const [group, points] of d3.group(data.points, p => p.group)) {
    const words = p => `${p.name}\n${digits(p.x)} [${digits(p.low)}, ${digits(p.high)}] ns\nerror up to ${digits(p.y)}`;
    const svg = draw_plot(plot_place(figure.querySelector('.plots')), group, {
      ariaLabel: `${data.y} over ${data.x}, ${group}`,
      x: {
        ...axis,
        domain: x,
        label: data.x,
        labelAnchor: 'center',
        labelOffset: 38,
        ticks: [1, 2, 5].flatMap(f => decades(x, f)),
      },
      y: {...axis, domain: y, label: data.y, ticks: decades(y)},
      marks: [
        Plot.line(points.filter(p => p.frontier), {
          x: 'x',
          y: 'y',
          sort: 'x',
          curve: 'step-after',
          stroke: 'var(--accent)',
          strokeWidth: 1.5,
        }),
        Plot.ruleY(points, {y: 'y', x1: 'low', x2: 'high', strokeWidth: 2, strokeOpacity: 0.6}),
        Plot.dot(points, {
          x: 'x',
          y: 'y',
          r: 4.5,
          stroke: 'var(--accent)',
          fill: dot_fill,
          tip: true,
          title: words,
        }),
      ],
    });
    name_points(svg, points);
  }
}
