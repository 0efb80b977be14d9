// SPDX-License-Identifier: Apache-2.0
// The magnifier: the same pixels of every picture, enlarged, with the values of the one in the middle.
const lens_pixels = 11, lens_zoom = 12;  // across, and screen pixels for each
const magma = page ? d3.range(256).map(i => d3.rgb(d3.interpolateMagma(i / 255))) : [];
const flip_at = ([r, g, b]) => d3.minIndex(magma, c => (c.r - r) ** 2 + (c.g - g) ** 2 + (c.b - b) ** 2) / 255;

// pictures: [{title, path, kind: 'display' | 'difference' | 'flip'}]; gain: what difference pictures were multiplied by.
function magnifier(place) {
  let drawing = 0;
  return async (pictures, x, y, gain) => {
    const mine = ++drawing;
    const all = await Promise.all(pictures.map(picture => pixels_of(picture.path)));
    if (mine !== drawing) return;
    place.replaceChildren(...pictures.map((picture, i) => {
      const canvas = element('canvas', {width: lens_pixels * lens_zoom, height: lens_pixels * lens_zoom});
      canvas.setAttribute('aria-hidden', 'true');
      const words = element('output', {className: 'values'});
      const lens = element('div', {className: 'lens'}, element('strong', {textContent: picture.title}), canvas, words);
      const pixels = all[i];
      if (!pixels) {
        words.textContent = 'its pixels cannot be read here';
        return lens;
      }
      const half = (lens_pixels - 1) / 2, context = canvas.getContext('2d');
      const at =
          (column, row) => [...pixels.data.subarray(4 * (row * pixels.width + column), 4 * (row * pixels.width + column) + 3)];
      for (let row = -half; row <= half; ++row)
        for (let column = -half; column <= half; ++column) {
          const inside = x + column >= 0 && y + row >= 0 && x + column < pixels.width && y + row < pixels.height;
          context.fillStyle = inside ? `rgb(${at(x + column, y + row)})` : '#808080';
          context.fillRect((column + half) * lens_zoom, (row + half) * lens_zoom, lens_zoom, lens_zoom);
        }
      context.strokeStyle = '#fff';
      context.strokeRect(half * lens_zoom - 0.5, half * lens_zoom - 0.5, lens_zoom + 1, lens_zoom + 1);
      const value = at(x, y);
      words.textContent = picture.kind === 'flip' ?
          `FLIP ${flip_at(value).toFixed(2)}` :
          picture.kind === 'difference' ?
          `${value.map(v => +(v / gain).toFixed(1)).join(', ')} of 255${value.includes(255) ? ' or more' : ''}` :
          `sRGB ${value.join(', ')}`;
      return lens;
    }));
  };
}
