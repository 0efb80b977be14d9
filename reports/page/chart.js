// SPDX-License-Identifier: Apache-2.0
// Draws the data of each figure.chart with Observable Plot: y over x, both logarithmic, a plot for each group on common axes.
// Data: {x, y: the axes' labels, points: [{group, name, x, low, high, y, frontier}]}.
const superscript = text => text.replace(/./g, c => '⁰¹²³⁴⁵⁶⁷⁸⁹'[c] ?? '⁻');
const tick = value => value >= 0.001 && value < 10000 ? `${+value.toPrecision(3)}` : `10${superscript(`${Math.round(Math.log10(value))}`)}`;
const decades = ([low, high]) => d3.range(Math.ceil(Math.log10(low)), Math.floor(Math.log10(high)) + 1).map(e => 10 ** e);

// Names go where they cover no dot, no interval and no other name: to the right if they can, else around the dot.
function label(svg, points, size) {
  const [x, y] = ['x', 'y'].map(name => svg.scale(name).apply);
  const taken = points.flatMap(p => [[x(p.x) - 5, y(p.y) - 5, x(p.x) + 5, y(p.y) + 5], [x(p.low), y(p.y) - 3, x(p.high), y(p.y) + 3]]);
  const overlap = (a, b) => Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0])) * Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));
  const outside = box => 100 * (Math.max(0, size.left - box[0]) + Math.max(0, box[2] - size.right) + Math.max(0, size.top - box[1]) + Math.max(0, box[3] - size.bottom));
  for (const p of points) {
    const text = d3.select(svg).append('text').text(p.name).attr('fill', 'currentColor').attr('font-weight', p.frontier ? 600 : null);
    const width = text.node().getComputedTextLength(), height = 14;
    const right = x(p.high) + 7, left = x(p.low) - 7 - width, middle = x(p.x) - width / 2;
    const corners = [[right, y(p.y) - 7], [left, y(p.y) - 7], [middle, y(p.y) - 22], [middle, y(p.y) + 8],
      [right, y(p.y) - 19], [right, y(p.y) + 5], [left, y(p.y) - 19], [left, y(p.y) + 5]];
    const boxes = corners.map(([a, b]) => [a, b, a + width, b + height]);
    const box = boxes[d3.minIndex(boxes, b => outside(b) + d3.sum(taken, t => overlap(b, t)))];
    taken.push(box);
    text.attr('x', box[0]).attr('y', box[3] - 3);
  }
}

for (const figure of document.querySelectorAll('figure.chart')) {
  const data = JSON.parse(figure.querySelector('script').textContent);
  const x = [d3.min(data.points, p => p.low) / 1.5, d3.max(data.points, p => p.high) * 1.5];
  const y = [d3.min(data.points, p => p.y) / 3, d3.max(data.points, p => p.y) * 3];
  for (const [group, points] of d3.group(data.points, p => p.group)) {
    const size = {left: 60, right: 545, top: 40, bottom: 365};
    const svg = Plot.plot({
      width: 560, height: 420, marginLeft: size.left, marginRight: 15, marginTop: size.top, marginBottom: 55, ariaLabel: `${data.y} over ${data.x}, ${group}`,
      style: {background: 'none', color: 'inherit', fontSize: '12px', fontFamily: 'inherit', '--plot-background': 'var(--card)'},
      x: {type: 'log', domain: x, label: data.x, labelAnchor: 'center', labelArrow: 'none', ticks: decades(x).concat(decades(x.map(v => v / 2)).map(v => 2 * v), decades(x.map(v => v / 5)).map(v => 5 * v)), tickFormat: tick, grid: true},
      y: {type: 'log', domain: y, label: `${data.y}`, labelArrow: 'none', ticks: decades(y), tickFormat: tick, grid: true},
      marks: [
        Plot.line(points.filter(p => p.frontier), {x: 'x', y: 'y', sort: 'x', curve: 'step-after', stroke: 'var(--accent)', strokeWidth: 1.5}),
        Plot.ruleY(points, {y: 'y', x1: 'low', x2: 'high', stroke: 'currentColor', strokeWidth: 2, strokeOpacity: .6}),
        Plot.dot(points, {x: 'x', y: 'y', r: 4.5, stroke: 'var(--accent)', strokeWidth: 1.5, fill: p => p.frontier ? 'var(--accent)' : 'var(--page)',
          title: p => `${p.name}\n${p.x.toPrecision(3)} [${p.low.toPrecision(3)}, ${p.high.toPrecision(3)}] ns\nerror up to ${p.y.toPrecision(3)}`, tip: true}),
      ],
    });
    const place = figure.querySelector('.plots').appendChild(document.createElement('div'));
    place.append(Object.assign(document.createElement('h4'), {textContent: group}), svg);
    label(svg, points, size);
  }
}
