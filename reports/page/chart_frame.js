// SPDX-License-Identifier: Apache-2.0
// What the charts have in common: size, axes, ticks, and names that stay off each other.
const superscript = text => text.replace(/./g, c => '⁰¹²³⁴⁵⁶⁷⁸⁹'[c] ?? '⁻');
const tick = value =>
    value >= 0.001 && value < 10000 ? `${+ value.toPrecision(3)}` : `10${superscript(`${Math.round(Math.log10(value))}`)}`;
// factor times the powers of ten between low and high.
const decades = ([low, high], factor = 1) =>
    d3.range(Math.ceil(Math.log10(low / factor)), Math.floor(Math.log10(high / factor)) + 1).map(e => factor * 10 ** e);

const margins = {
  left: 70,
  right: 24,
  top: 40,
  bottom: 55
};
const chart_style = {
  background: 'none',
  color: 'inherit',
  fontSize: '12px',
  fontFamily: 'inherit',
  overflow: 'visible',
  '--plot-background': 'var(--card)'
};
// A plot of the page's look; its width is the place's, at most `most`.
function draw_plot(place, title, options, most = 560) {
  const width = Math.min(most, Math.max(280, (place.clientWidth || most)));
  const svg = Plot.plot({
    width,
    height: 420,
    marginLeft: margins.left,
    marginRight: margins.right,
    marginTop: margins.top,
    marginBottom: margins.bottom,
    style: chart_style,
    ...options,
  });
  const image = svg.tagName === 'FIGURE' ? [...svg.querySelectorAll('svg')].at(-1) : svg;
  image.setAttribute('role', 'group');
  image.setAttribute('aria-label', options.ariaLabel ?? title);
  for (const mark of image.querySelectorAll('g[aria-label]')) {  // a group of marks has no role that a label could be of
    mark.dataset.marks = mark.getAttribute('aria-label');
    mark.removeAttribute('aria-label');
  }
  // On a long logarithmic axis D3 blanks the labels of some ticks; those that are asked for are wanted.
  for (const axis of ['x', 'y']) {
    const labels = image.querySelectorAll(`g[data-marks="${axis}-axis tick label"] text`);
    if (options[axis].type === 'log')
      options[axis].ticks.forEach((value, i) => labels[i].textContent = options[axis].tickFormat(value));
  }
  place.append(element('h4', {textContent: title}), svg);
  return image;
}
// A place for a plot in a grid.
const plot_place = grid => grid.appendChild(element('div', {className: 'plot'}));

// Full where it is worth having, half where it is not told apart from a closer one, hollow else.
const dot_fill = point => point.frontier ? 'var(--accent)' :
    point.not_told                       ? 'color-mix(in srgb, var(--accent) 45%, var(--page))' :
                                           'var(--page)';

// Writes each name where it covers no dot, no interval, no line and no other name: to the right if it can, else around the dot;
// a thin line leads to a name that stands away from its dot.
function name_points(svg, points) {
  const x = svg.scale('x').apply, y = svg.scale('y').apply;
  const width_of_svg = +svg.getAttribute('width'), height_of_svg = +svg.getAttribute('height');
  const frame =
      {left: margins.left, right: width_of_svg - margins.right, top: margins.top, bottom: height_of_svg - margins.bottom};
  const taken = points.flatMap(
      p => [
          [x(p.x) - 6, y(p.y) - 6, x(p.x) + 6, y(p.y) + 6],
          [x(p.low), y(p.y) - 3, x(p.high), y(p.y) + 3],
  ]);
  for (const [p, next] of d3.pairs(d3.sort(points.filter(p => p.frontier), p => p.x)))
    taken.push(
        [x(p.x), y(p.y) - 2, x(next.x), y(p.y) + 2],
        [x(next.x) - 2, Math.min(y(p.y), y(next.y)), x(next.x) + 2, Math.max(y(p.y), y(next.y))]);
  const shared = (a, b) =>
      Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0])) * Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));
  const outside = box => Math.max(0, frame.left - box[0], box[2] - frame.right, frame.top - box[1], box[3] - frame.bottom);
  for (const p of points) {
    // Beneath the dots, and so beneath what hovering shows.
    const text = d3.select(svg)
                     .insert('text', 'g[data-marks="dot"]')
                     .text(p.name)
                     .attr('fill', 'currentColor')
                     .attr('pointer-events', 'none');
    text.attr('text-anchor', 'start').attr('font-weight', p.frontier ? 600 : null);
    const width = text.node().getComputedTextLength(), height = 14;
    const right = x(p.high) + 9, left = x(p.low) - 9 - width, middle = x(p.x) - width / 2, beside = y(p.y) - 7;
    const rows = d3.range(5).flatMap(i => [y(p.y) - 22 - 16 * i, y(p.y) + 8 + 16 * i]);
    const boxes = [[right, beside], [left, beside], ...d3.cross([middle, right, left], rows)].map(
        ([a, b]) => [a, b, a + width, b + height]);
    const end = b => [Math.max(b[0], Math.min(b[2], x(p.x))), Math.max(b[1] + 2, Math.min(b[3], y(p.y)))];
    const away = b => Math.hypot(end(b)[0] - x(p.x), end(b)[1] - y(p.y));
    const box = boxes[d3.minIndex(boxes, b => 1000 * outside(b) + 10 * d3.sum(taken, t => shared(b, t)) + away(b))];
    taken.push(box);
    text.attr('x', box[0]).attr('y', box[3] - 3);
    const beside_it = box[1] === beside, length = away(box);
    if (beside_it || length < 10) continue;
    const [to_x, to_y] = end(box), edge = 5 / length;
    d3.select(svg)
        .insert('line', 'g[data-marks="dot"]')
        .attr('class', 'leader')
        .attr('x1', x(p.x) + edge * (to_x - x(p.x)))
        .attr('y1', y(p.y) + edge * (to_y - y(p.y)))
        .attr('x2', to_x)
        .attr('y2', to_y)
        .attr('stroke', 'currentColor')
        .attr('stroke-opacity', 0.5)
        .attr('pointer-events', 'none');
  }
}

// Dots that keyboard and mouse can press: the nth is act(points[n]). A press of the mouse pins the plot's tip, which then lies
// over the dot, so that the click goes to whichever dot is nearest.
function press_dots(svg, points, words, act) {
  svg.addEventListener('click', event => {
    const box = svg.getBoundingClientRect(), shrink = box.width / svg.getAttribute('width');
    const away = p => Math.hypot(
        box.left + svg.scale('x').apply(p.x) * shrink - event.clientX,
        box.top + svg.scale('y').apply(p.y) * shrink - event.clientY);
    const nearest = points[d3.minIndex(points, away)];
    if (away(nearest) < 12) act(nearest);
  });
  svg.querySelectorAll('g[data-marks="dot"] circle').forEach((dot, i) => {
    dot.setAttribute('tabindex', 0);
    dot.setAttribute('role', 'button');
    dot.setAttribute('aria-label', words(points[i]));
    dot.addEventListener('keydown', event => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      act(points[i]);
    });
  });
}

// Draws again when the choice changes or the page gets another width.
function drawn_on_choice(draw) {
  watchers.push(draw);
}
let page_width = window.innerWidth;
window.addEventListener('resize', () => {
  if (!page || window.innerWidth === page_width) return;
  page_width = window.innerWidth;
  choose({});
});
