'use strict';
// What a reader does with a study's page, and whether it happens; a failure is an error of the page.

function expect(what, condition) {
  if (!condition) {
    count_error();
    console.error(`expected: ${what}`);
  }
}

// For what takes pictures to be decoded.
async function eventually(what, condition) {
  for (let i = 0; i < 200 && !condition(); ++i) await new Promise((resolve) => setTimeout(resolve, 20));
  expect(what, condition());
}

function fire(node, type, options = {}) {
  const kind = type.startsWith('pointer') ? PointerEvent : type.startsWith('key') ? KeyboardEvent : Event;
  node.dispatchEvent(new kind(type, {bubbles: true, ...options}));
}

function visible(node) {
  return node.getClientRects().length > 0;
}

async function use_page() {
  while (page.dataset.ready !== '1') await new Promise((resolve) => setTimeout(resolve, 20));
  page.dataset.ready = 'in use';

  // The figures are drawn before the script: the first is painted within a second.
  const paint = performance.getEntriesByName('first-contentful-paint')[0];
  expect('a first plot within a second', !paint || paint.startTime < 1000);
  expect('the first figure is shown alone', [...document.querySelectorAll('#trade .plot')].filter(visible).length === 1);

  // Hovering tells, clicking and Enter open.
  const point = document.querySelector('#settings .point[data-cell]');
  fire(point, 'pointerenter');
  expect('a tip that names the cell', !tip.hidden && tip.textContent === point.querySelector('title').textContent);
  fire(point, 'pointerleave');
  expect('the tip to go', tip.hidden);
  fire(point, 'click');
  expect('the clicked cell on the right', viewer.right === cells.get(point.dataset.cell).name);
  expect('its details', document.getElementById('details').textContent.includes(point.dataset.cell));
  expect('its points marked', point.classList.contains('chosen'));
  const other = [...document.querySelectorAll('.point')].find(
      (one) => one.dataset.cell !== point.dataset.cell && !cells.get(one.dataset.cell).failed);
  fire(other, 'keydown', {key: 'Enter'});
  expect('Enter to open a cell', viewer.right === cells.get(other.dataset.cell).name);

  // The slider, values under the pointer, the heat map, zoom.
  const range = document.querySelector('input[type=range]');
  range.value = 250;
  fire(range, 'input');
  expect('a quarter to the left', range.getAttribute('aria-valuetext').startsWith('25 %'));
  viewer.inspect(40, 30);
  await eventually('the values of a pixel', () => document.querySelector('.readout').textContent.includes('x 40, y 30'));
  viewer.choose(data.cells.find((cell) => cell.technique === 'exact').name, viewer.right);
  document.querySelector('input[name=view][value=heat]').click();
  await eventually('a heat map', () => document.querySelector('.canvas img').alt.startsWith('Heat map'));
  document.querySelector('input[name=zoom][value="4"]').click();
  await eventually('pixels four times as large', () => document.querySelector('.canvas').style.width === '384px');

  // Filters of the figure and of the table.
  const box = document.querySelector('.filters input');
  box.click();
  expect('a series switched off', document.querySelectorAll('#trade .series.off').length > 0);
  const filter = document.getElementById('filter');
  filter.value = 'map size';
  fire(filter, 'input');
  const rows = [...document.querySelectorAll('#cells tbody tr')];
  expect('the table filtered', rows.some((row) => row.hidden) && rows.some((row) => !row.hidden));

  document.querySelector('input[name=time][value="plot-error-card"]').click();
  expect('another time chosen', visible(document.getElementById('plot-error-card')));
  expect('claim, normalisation and hard cases', ['claim', 'scale', 'hard-cases', 'provenance'].every(
      (id) => document.getElementById(id)));
  page.dataset.images = String(document.images.length);
}

// Only a page that was used to the end is ready again.
use_page().then(() => { page.dataset.ready = '1'; }, (error) => { count_error(); console.error(error); });
