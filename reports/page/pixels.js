// SPDX-License-Identifier: Apache-2.0
// Pictures by their path in the record, and the values of their pixels. A browser does not let a page read the pixels of a
// picture file on disk, so the pictures beside the page are also written as scripts, PICTURE.js, which call lamina_pixels().
const picture_urls = new Map(
    [...document.querySelectorAll('img[data-picture]')].map(image => [image.dataset.picture, image.getAttribute('src')]));
const pixel_callers = new Map();
window.lamina_pixels = (path, url) => pixel_callers.get(path)?.(url);

const known_pixels = new Map();
const max_known = 24;
// The picture's ImageData, 8-bit sRGB; null where it cannot be read.
function pixels_of(path) {
  if (known_pixels.has(path)) return known_pixels.get(path);
  if (known_pixels.size >= max_known) known_pixels.delete(known_pixels.keys().next().value);
  const url = picture_urls.get(path) ?? '';
  const data_url = url.startsWith('data:') ? Promise.resolve(url) : new Promise((resolve, reject) => {
    pixel_callers.set(path, resolve);
    document.head.append(element('script', {src: `${url}.js`, onerror: reject}));
  });
  const pixels = data_url
                     .then(async data => {
                       const image = element('img', {src: data});
                       await image.decode();
                       const canvas = element('canvas', {width: image.naturalWidth, height: image.naturalHeight});
                       const context = canvas.getContext('2d', {willReadFrequently: true});
                       context.drawImage(image, 0, 0);
                       return context.getImageData(0, 0, canvas.width, canvas.height);
                     })
                     .catch(() => null);
  known_pixels.set(path, pixels);
  return pixels;
}
