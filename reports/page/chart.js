// SPDX-License-Identifier: Apache-2.0
// Draws the data of each figure.chart with Observable Plot: y over x, both logarithmic, a plot for each group on common axes.
// Data: {x, y: the axes' labels, points: [{group, name, x, low, high, y, frontier}]}; low and high are x's interval.
const frame = {left: 60, right: 545, top: 40, bottom: 365, width: 560, height: 420};

const digits = value => value.toPrecision(3);
const superscript = text => text.replace(/./g, c => '⁰¹²³⁴⁵⁶⁷⁸⁹'[c] ?? '⁻');
const tick = value =>
  value >= 0.001 && value < 10000 ? `${+value.toPrecision(3)}` : `10${superscript(`${Math.round(Math.log10(value))}`)}`;
// factor times the powers of ten between low and high.
const decades = ([low, high], factor = 1) =>
  d3.range(Math.ceil(Math.log10(low / factor)), Math.floor(Math.log10(high / factor)) + 1).map(e => factor * 10 ** e);

// Writes each name where it covers no dot, no interval, no line and no other name: to the right if it can, else around the dot.
function name_points(svg, points) {
  const x = svg.scale('x').apply, y = svg.scale('y').apply;
  const taken = points.flatMap(p => [
    [x(p.x) - 6, y(p.y) - 6, x(p.x) + 6, y(p.y) + 6],
    [x(p.low), y(p.y) - 3, x(p.high), y(p.y) + 3],
  ]);
  for (const [p, next] of d3.pairs(d3.sort(points.filter(p => p.frontier), p => p.x)))
    taken.push([x(p.x), y(p.y) - 2, x(next.x), y(p.y) + 2], [x(next.x) - 2, y(p.y), x(next.x) + 2, y(next.y)]);
  const shared = (a, b) =>
    Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0])) * Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));
  const outside = box => Math.max(0, frame.left - box[0], box[2] - frame.right, frame.top - box[1], box[3] - frame.bottom);
  for (const p of points) {
    const text = d3.select(svg).append('text').text(p.name);
    text.attr('text-anchor', 'start').attr('font-weight', p.frontier ? 600 : null);
    const width = text.node().getComputedTextLength(), height = 14;
    const right = x(p.high) + 7, left = x(p.low) - 7 - width, middle = x(p.x) - width / 2;
    const above = y(p.y) - 22, beside = y(p.y) - 7, below = y(p.y) + 8;
    const boxes = [
      [right, beside], [left, beside], [middle, above], [middle, below], [right, above], [right, below], [left, above],
      [left, below],
    ].map(([a, b]) => [a, b, a + width, b + height]);
    const box = boxes[d3.minIndex(boxes, b => 1000 * outside(b) + d3.sum(taken, t => shared(b, t)))];
    taken.push(box);
    text.attr('x', box[0]).attr('y', box[3] - 3);
  }
}

for (const figure of document.querySelectorAll('figure.chart')) {
  const data = JSON.parse(figure.querySelector('script').textContent);
  const x = [d3.min(data.points, p => p.low) / 1.5, d3.max(data.points, p => p.high) * 1.5];
  const y = [d3.min(data.points, p => p.y) / 3, d3.max(data.points, p => p.y) * 3];
  const axis = {type: 'log', labelArrow: 'none', tickFormat: tick, grid: true};
  for (const [group, points] of d3.group(data.points, p => p.group)) {
    const svg = Plot.plot({
      width: frame.width,
      height: frame.height,
      marginLeft: frame.left,
      marginRight: frame.width - frame.right,
      marginTop: frame.top,
      marginBottom: frame.height - frame.bottom,
      ariaLabel: `${data.y} over ${data.x}, ${group}`,
      style: {background: 'none', color: 'inherit', fontSize: '12px', fontFamily: 'inherit', '--plot-background': 'var(--card)'},
      x: {
        ...axis, domain: x, label: data.x, labelAnchor: 'center', labelOffset: 38, ticks: [1, 2, 5].flatMap(f => decades(x, f)),
      },
      y: {...axis, domain: y, label: data.y, ticks: decades(y)},
      marks: [
        Plot.line(points.filter(p => p.frontier), {
          x: 'x', y: 'y', sort: 'x', curve: 'step-after', stroke: 'var(--accent)', strokeWidth: 1.5,
        }),
        Plot.ruleY(points, {y: 'y', x1: 'low', x2: 'high', strokeWidth: 2, strokeOpacity: 0.6}),
        Plot.dot(points, {
          x: 'x', y: 'y', r: 4.5, stroke: 'var(--accent)', fill: p => p.frontier ? 'var(--accent)' : 'var(--page)', tip: true,
          title: p => `${p.name}\n${digits(p.x)} [${digits(p.low)}, ${digits(p.high)}] ns\nerror up to ${digits(p.y)}`,
        }),
      ],
    });
    const place = figure.querySelector('.plots').appendChild(document.createElement('div'));
    place.append(Object.assign(document.createElement('h4'), {textContent: group}), svg);
    name_points(svg, points);
  }
}
