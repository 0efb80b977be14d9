// SPDX-License-Identifier: Apache-2.0
// The viewer: baseline (or truth, another variant, or what it was before a change) and variant under a slider and a flip key,
// difference and FLIP map with their scales, the worst tile marked, and a magnifier over all of them.
if (page) {
  const section = section_of('pictures');
  const place = section.appendChild(element('div', {className: 'controls'}));
  const update_slider = add_point_slider(section);
  const of_gate = page.cells.some(cell => cell.before_image);
  const shown = {left: of_gate ? 'before' : 'the baseline', flipped: false, x: null, y: null};
  const cursor_words = element('p', {className: 'note'});
  cursor_words.setAttribute('aria-live', 'polite');
  const lenses = element('div', {className: 'lenses'});
  const magnify = magnifier(lenses);
  let panels = [], pictures = [], right = null;

  // A picture with marks over it; `images` lie on top of each other.
  function panel(name, caption, scale, ...images) {
    const stage = element(
        'div', {className: 'stage', tabIndex: 0}, ...images, element('div', {className: 'tile', hidden: true}),
        element('div', {className: 'cross', hidden: true}));
    stage.setAttribute('role', 'group');
    stage.setAttribute('aria-label', `${name}; the arrow keys move the magnifier`);
    stage.addEventListener('pointermove', event => {
      const box = stage.getBoundingClientRect(), [width, height] = right.size;
      move(
          Math.floor((event.clientX - box.left) / box.width * width),
          Math.floor((event.clientY - box.top) / box.height * height));
    });
    stage.addEventListener('keydown', event => {
      const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
      if (!step) return;
      event.preventDefault();
      const far = event.shiftKey ? 10 : 1;
      move((shown.x ?? right.size[0] >> 1) + far * step[0], (shown.y ?? right.size[1] >> 1) + far * step[1]);
    });
    const figure = element('figure', {className: `panel ${name}`}, stage, element('figcaption', {}, caption, scale));
    return figure;
  }
  const image_of = (path, alt) => element('img', {src: picture_urls.get(path) ?? '', alt, draggable: false});
  const scale_bar = (kind, low, high) => element('span', {className: 'legend'}, low, element('span', {className: kind}), high);

  function move(x, y) {
    if (!right) return;
    const [width, height] = right.size;
    shown.x = Math.max(0, Math.min(width - 1, x));
    shown.y = Math.max(0, Math.min(height - 1, y));
    for (const cross of section.querySelectorAll('.cross')) {
      cross.hidden = false;
      cross.style.left = `${100 * (shown.x + 0.5) / width}%`;
      cross.style.top = `${100 * (shown.y + 0.5) / height}%`;
    }
    cursor_words.textContent = `Pixel ${shown.x}, ${shown.y} (from the upper left)`;
    magnify(pictures, shown.x, shown.y, +page.records[right.record].gain || 1);
  }

  const flip_button = element('button', {type: 'button', className: 'flip-key'});
  const wipe = element('input', {type: 'range', min: 0, max: 100, value: 50});
  wipe.setAttribute('aria-label', 'where the pictures meet, percent from the left');
  const wipe_to = () => {
    const over = section.querySelector('.over');
    const at = shown.flipped === 'left' ? 100 : shown.flipped === 'right' ? 0 : wipe.value;
    if (over) over.style.clipPath = `inset(0 0 0 ${at}%)`;
    section.querySelector('.seam')?.style.setProperty('left', `${at}%`);
    flip_button.setAttribute('aria-pressed', shown.flipped === 'left');
    flip_button.textContent =
        shown.flipped ? `Flip (f): showing ${shown.flipped === 'left' ? shown.left_name : right?.variant}` : 'Flip (f)';
  };
  const flip = () => {
    shown.flipped = shown.flipped === 'left' ? 'right' : 'left';
    wipe_to();
  };
  flip_button.addEventListener('click', flip);
  wipe.addEventListener('input', () => {
    shown.flipped = false;
    wipe_to();
  });
  document.addEventListener('keydown', event => {
    if (event.key === 'f' && !event.ctrlKey && !event.metaKey && !event.altKey &&
        !['SELECT', 'TEXTAREA'].includes(event.target.tagName))
      flip();
  });

  // What the left may be: words and the picture's path.
  function left_choices() {
    const cells = like_chosen({variant: undefined});
    const choices = [];
    const now = cells.find(cell => cell.variant === chosen.variant);
    if (now?.before_image) choices.push(['before', `${now.variant} before the change`, now.before_image]);
    const baseline = cells.find(cell => cell.is_baseline);
    if (baseline?.image) choices.push(['the baseline', `${baseline.variant} (baseline)`, baseline.image]);
    const truth = cells.find(cell => cell.truth_image);
    if (truth) choices.push(['the truth', 'the truth', truth.truth_image]);
    for (const cell of cells)
      if (!cell.is_baseline && cell.image && cell.variant !== chosen.variant)
        choices.push([cell.variant, cell.variant, cell.image]);
    for (const cell of page.cells)
      if (cell.record !== chosen.record && cell.image &&
          ['effect', 'variant', 'backend', 'view', 'point'].every(f => cell[f] === chosen[f]))
        choices.push([`record ${cell.record}`, `${cell.variant} of ${name_of_record(cell.record)}`, cell.image]);
    for (const cell of page.cells)
      if (cell.record === chosen.record && cell.backend !== chosen.backend && cell.image &&
          ['effect', 'variant', 'view', 'point'].every(f => cell[f] === chosen[f]))
        choices.push([`on ${cell.backend}`, `${cell.variant} on ${cell.backend}`, cell.image]);
    return choices;
  }

  function figures(cell) {
    if (cell.failed) return element('p', {className: 'bad', textContent: `${cell.variant} failed: ${cell.failed}`});
    const list = element('dl', {className: 'facts'});
    const add = (label, words) => list.append(element('dt', {textContent: label}), element('dd', {textContent: words}));
    add('Frame', interval_words(cell.ms, 'ms'));
    if (cell.ratio) add('Over the baseline\'s', interval_words(cell.ratio, 'times'));
    if (cell.fetches !== null) add('Fetches a pixel', digits(cell.fetches));
    for (const against of ['baseline', 'truth'])
      if (cell[against] && !(against === 'baseline' && cell.is_baseline))
        add(`To the ${against}`,
            page.metrics
                .map(
                    (metric, i) => `${metric.words} ${
                        cell[against][i] === null ? 'inf (the same picture)' : figure_words(metric, cell[against][i])}`)
                .join('; '));
    const tile = cell.worst_tile;
    if (tile)
      add('Worst tile',
          `mean FLIP ${digits(tile.flip)} in the ${tile.size} x ${tile.size} pixels from ${tile.x}, ${tile.y}: the dashed box`);
    return list;
  }

  function draw_controls() {
    const options = field => {
      const order = ['record', 'effect', 'backend', 'view', 'variant'];
      const before = order.slice(0, order.indexOf(field));
      const values = unique(page.cells.filter(cell => before.every(f => cell[f] === chosen[f])).map(cell => cell[field]));
      return values.map(value => [value, field === 'record' ? name_of_record(value) : value]);
    };
    const choices = left_choices();
    if (!choices.some(([key]) => key === shown.left)) shown.left = choices[0]?.[0];
    const list = (label, field) => options(field).length > 1 ?
        drop_down(label, options(field), chosen[field], value => choose_near({[field]: value})) :
        null;
    replace_controls(place, [
      list('Record', 'record'),
      list('Effect', 'effect'),
      list('Backend', 'backend'),
      list('View', 'view'),
      choices.length ? drop_down(
                           'Left', choices.map(([key, words]) => [key, words]), shown.left,
                           value => {
                             shown.left = value;
                             draw();
                           }) :
                       null,
      list('Right', 'variant'),
    ]);
    return choices.find(([key]) => key === shown.left);
  }

  function draw() {
    right = like_chosen({variant: chosen.variant})[0];
    const left = draw_controls();
    update_slider();
    section.querySelector('.viewer')?.remove();
    const viewer = section.appendChild(element('div', {className: 'viewer'}));
    viewer.append(
        element('h3', {
          textContent: [
            name_of_record(right.record), `${right.variant} on ${right.backend}, view ${right.view}`
          ].filter(Boolean).join(', ')
        }),
        figures(right));
    pictures = [];
    shown.left_name = left?.[1];
    if (right.image) {
      const over = image_of(right.image, `${right.variant}, view ${right.view}`);
      const images =
          left ? [image_of(left[2], `${left[1]}, view ${right.view}`), over, element('div', {className: 'seam'})] : [over];
      if (left) over.className = 'over';
      if (left) pictures.push({title: left[1], path: left[2], kind: 'display'});
      pictures.push({title: right.variant, path: right.image, kind: 'display'});
      const row = viewer.appendChild(element('div', {className: 'panels'}));
      const main = panel('compare', left ? `left ${left[1]}, right ${right.variant}` : right.variant, null, ...images);
      if (left) main.append(element('div', {className: 'wipe'}, wipe, flip_button));
      row.append(main);
      const gain = +page.records[right.record].gain || 1;
      if (right.difference) {
        row.append(panel(
            'difference', `difference from the baseline, each channel, times ${gain}`,
            scale_bar('ramp', '0', `${digits(255 / gain)} of 255 or more`),
            image_of(right.difference, `difference of ${right.variant} from the baseline`)));
        pictures.push({title: 'difference', path: right.difference, kind: 'difference'});
      }
      if (right.flip) {
        row.append(panel(
            'flip', 'FLIP, how much a person would notice', scale_bar('magma', '0', '1'),
            image_of(right.flip, `FLIP map of ${right.variant}`)));
        pictures.push({title: 'FLIP', path: right.flip, kind: 'flip'});
      }
      for (const box of viewer.querySelectorAll('.tile')) {
        const tile = right.worst_tile, [width, height] = right.size;
        box.hidden = !tile;
        if (tile)
          Object.assign(box.style, {
            left: `${100 * tile.x / width}%`,
            top: `${100 * tile.y / height}%`,
            width: `${100 * Math.min(tile.size, width - tile.x) / width}%`,
            height: `${100 * Math.min(tile.size, height - tile.y) / height}%`
          });
      }
      viewer.append(cursor_words, lenses);
      cursor_words.textContent ||= 'Point at a picture, or move over it with the arrow keys, to see its pixels.';
    } else
      viewer.append(element('p', {className: 'note', textContent: 'The record holds no picture of this.'}));
    wipe_to();
    if (shown.x !== null && pictures.length) move(shown.x, shown.y);
  }
  drawn_on_choice(draw);
}
