// SPDX-License-Identifier: Apache-2.0
// The page's style and script, kept in the page so that one file is all.
#include "reports/html.h"

namespace lamina {

// Magma, for the legend of FLIP's maps: nine samples, an eighth apart, of the colour map by van der Walt and Smith (2015, CC0).
const std::string_view html_style = R"css(
:root {
  --page: #f6f6f4; --card: #ffffff; --ink: #1c1d1f; --soft: #5d6167; --line: #d9dadc; --accent: #2458a6;
  --bad: #a3201b; --warn-page: #fff3d1; --warn-ink: #5c4300; color-scheme: light dark;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #17181a; --card: #202225; --ink: #e7e7e4; --soft: #a2a6ac; --line: #3a3d42; --accent: #8db7f5;
    --bad: #ff9a92; --warn-page: #3d3112; --warn-ink: #ffe2a0;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; padding: 2rem clamp(1rem, 3vw, 3rem) 4rem; max-width: 100rem; background: var(--page); color: var(--ink);
  font: 1rem/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif;
}
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 1rem; }
h2 { font-size: 1.25rem; margin: 2.75rem 0 .75rem; padding-top: .75rem; border-top: 1px solid var(--line); }
h3 { font-size: 1.05rem; margin: 1.75rem 0 .5rem; }
h4 { font-size: 1rem; margin: 0 0 .5rem; overflow-wrap: anywhere; }
h4 small { font-weight: normal; color: var(--soft); }
p { max-width: 75ch; }
.headlines { padding-left: 1.2rem; margin: 1rem 0; max-width: 95ch; }
.headlines li { margin: .4rem 0; font-size: 1.08rem; }
.warning { background: var(--warn-page); color: var(--warn-ink); border-radius: .4rem; padding: .6rem .9rem; margin: .5rem 0; }
.note { color: var(--soft); font-size: .9rem; margin: .4rem 0; max-width: 110ch; }
.bad { color: var(--bad); }
.scroll { overflow-x: auto; }
.scroll + .scroll { margin-top: 1.2rem; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .93rem; }
caption { text-align: left; color: var(--soft); font-size: .9rem; padding-bottom: .35rem; }
th, td {
  text-align: left; padding: .32rem .9rem .32rem 0; border-bottom: 1px solid var(--line); vertical-align: top;
  white-space: nowrap;
}
thead th { color: var(--soft); font-weight: 600; }
table.wide { font-size: .85rem; }
table.wide th, table.wide td { padding-right: .6rem; }
table.wide caption { white-space: normal; max-width: 75rem; }
table.wide thead th { white-space: normal; vertical-align: bottom; }
.num { text-align: right; }
.wrap { white-space: normal; min-width: 16rem; overflow-wrap: anywhere; }
tr.baseline th, tr.baseline td { font-weight: 600; }
ul.shares { list-style: none; margin: 0; padding: 0; }
.shots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(17rem, 100%), 1fr)); gap: 1rem; align-items: start; }
.shot { background: var(--card); border: 1px solid var(--line); border-radius: .5rem; padding: .9rem; min-width: 0; }
.shot figure { margin: 0 0 .7rem; }
.shot img, .shot .missing { display: block; width: 100%; height: auto; background: #0c0d0e; border-radius: .25rem; }
.shot .missing { aspect-ratio: 2; color: #b9bcc0; display: grid; place-items: center; font-size: .9rem; }
.shot figcaption { color: var(--soft); font-size: .85rem; margin-top: .25rem; }
.flip { display: block; width: 100%; padding: 0; border: 0; background: none; font: inherit; color: inherit; cursor: pointer; }
.flip:focus-visible { outline: 3px solid var(--accent); outline-offset: 2px; }
.figures { width: 100%; font-size: .87rem; }
.figures th { font-weight: normal; color: var(--soft); white-space: normal; }
.figures th, .figures td { padding: .2rem 0 .2rem .6rem; }
.figures th:first-child { padding-left: 0; }
.maps { display: grid; grid-template-columns: 1fr 1fr; gap: .7rem; }
.legend { display: flex; align-items: center; gap: .5rem; font-size: .85rem; color: var(--soft); margin-top: .15rem; }
.magma {
  flex: 1; height: .8rem; border-radius: .2rem;
  background: linear-gradient(to right, #000004, #1c1044, #4f127b, #812581, #b5367a, #e55064, #fb8761, #fec287, #fcfdbf);
}
.strip { display: block; width: 100%; height: 2.6rem; color: var(--accent); }
.strip text { fill: var(--soft); font-size: 9px; }
.diverging { flex: 0 1 14rem; height: .8rem; border: 1px solid var(--line); background: linear-gradient(to right, #00f, #fff, #f00); }
.chart { margin: 1rem 0; }
.chart figcaption { margin-top: .6rem; color: var(--soft); font-size: .9rem; max-width: 110ch; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(34rem, 100%), 35rem)); gap: 1.5rem; }
.plots svg { overflow: visible; }
details { margin: .7rem 0; }
summary { cursor: pointer; color: var(--accent); }
tr.group th { padding-top: .9rem; color: var(--soft); white-space: normal; }
.slices { display: grid; grid-template-columns: 9rem repeat(4, minmax(0, 12rem)); gap: .3rem 1rem; align-items: center; margin: .6rem 0; }
.slices figure { margin: 0; }
.slices img { display: block; width: 100%; height: auto; border: 1px solid var(--line); }
.slices figcaption { color: var(--soft); font-size: .85rem; }
@media (max-width: 40rem) { .slices { grid-template-columns: 1fr 1fr; } .slices h4 { grid-column: 1 / -1; margin: 0; } }
dl.facts { display: grid; grid-template-columns: max-content 1fr; gap: .25rem 1.25rem; margin: 0; }
dl.facts dt { color: var(--soft); }
dl.facts dd { margin: 0; overflow-wrap: anywhere; }
@media (max-width: 40rem) { dl.facts { grid-template-columns: 1fr; } dl.facts dd { margin-bottom: .5rem; } }
)css";

const std::string_view html_script = R"js(
// A variant's picture shows the baseline in its place while pressed; the key b does so for all of them.
const show = (button, baseline) => {
  const image = button.querySelector('img');
  image.src = baseline ? button.dataset.baseline : button.dataset.own;
  button.setAttribute('aria-pressed', baseline);
  button.nextElementSibling.textContent = baseline ? button.dataset.baselineWords : button.dataset.ownWords;
};
const buttons = [...document.querySelectorAll('button.flip')];
for (const button of buttons) {
  button.disabled = false;
  button.dataset.ownWords = button.nextElementSibling.textContent;
  button.addEventListener('click', () => show(button, button.getAttribute('aria-pressed') !== 'true'));
}
document.addEventListener('keydown', event => {
  if (event.key !== 'b' || event.ctrlKey || event.metaKey || event.altKey) return;
  const baseline = buttons.some(button => button.getAttribute('aria-pressed') !== 'true');
  for (const button of buttons) show(button, baseline);
});
)js";

}  // namespace lamina
