// SPDX-License-Identifier: Apache-2.0
// Elements and the controls that the sections are made of.
function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children.filter(child => child !== null));
  return made;
}
const section_of = name => document.getElementById(name);

// A labelled list to choose from. options: [[value, words]]; a list of one is words alone.
function drop_down(label, options, value, change) {
  const list = element('select');
  options.forEach(([, words], i) => list.append(element('option', {value: i, textContent: words})));
  list.value = Math.max(0, options.findIndex(([known]) => known === value));
  list.addEventListener('change', () => change(options[list.value][0]));
  return element('label', {className: 'control'}, element('span', {textContent: label}), list);
}

// Puts controls into a place, and the keyboard back to where it was: on the control with the same label.
function replace_controls(place, controls) {
  const had = [...place.children].findIndex(child => child.contains(document.activeElement));
  const label = had < 0 ? null : place.children[had].textContent.split('\n')[0].slice(0, 4);
  place.replaceChildren(...controls.filter(control => control));
  if (label === null) return;
  const same = [...place.children].find(child => child.textContent.startsWith(label));
  same?.querySelector('select, input, button')?.focus();
}

// Adds a slider over the points that the choice has cells for; moving it moves charts and pictures. It stays the same element
// while it is dragged. Returns what brings it up to date.
function add_point_slider(place) {
  const input = element('input', {type: 'range', min: 0, step: 1}), words = element('output');
  const label =
      place.appendChild(element('label', {className: 'control scrub'}, element('span', {textContent: 'Point'}), input, words));
  let points = [];
  input.addEventListener('input', () => choose_near({point: points[input.value]}));
  return () => {
    points = unique(like_chosen({point: undefined}).map(cell => cell.point));
    label.hidden = points.length < 2;
    input.max = points.length - 1;
    input.value = points.indexOf(chosen.point);
    words.textContent = point_words(chosen.point);
    input.setAttribute('aria-valuetext', words.textContent);
  };
}
