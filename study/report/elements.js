'use strict';
// What every part of the page uses: counting of errors, making of elements, writing of numbers.

const page = document.documentElement;
page.dataset.errors = '0';

function count_error() {
  page.dataset.errors = String(Number(page.dataset.errors) + 1);
}

// Capturing, because a picture that does not load reports to itself only.
addEventListener('error', count_error, true);
addEventListener('unhandledrejection', count_error);

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value === true) node.setAttribute(name, '');
    else if (value !== false && value !== null) node.setAttribute(name, value);
  }
  node.append(...children.filter((child) => child !== null));
  return node;
}

// Text is only ever appended as text: nothing of the data is parsed as HTML.
function element(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

function svg(tag, attributes = {}, ...children) {
  return fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);
}

function section(id, title, ...children) {
  return element('section', {id, 'aria-labelledby': `${id}-title`},
                 element('h2', {id: `${id}-title`}, title), ...children);
}

// Pairs of term and description; those without a description are left out.
function fact_list(pairs) {
  return pairs.filter(([, value]) => value !== null && value !== '').map(
      ([name, value]) => element('div', {}, element('dt', {}, name), element('dd', {}, value)));
}

function table(label, head, rows) {
  const header = (text) => element('th', {scope: 'col'}, text);
  const body = rows.map(([first, ...rest]) => element(
      'tr', {}, element('th', {scope: 'row'}, first),
      ...rest.map((cell) => element('td', {}, cell))));
  return element('div', {class: 'wide', role: 'region', tabindex: '0', 'aria-label': label},
                 element('table', {}, element('thead', {}, element('tr', {}, ...head.map(header))),
                         element('tbody', {}, ...body)));
}

function swatch(color) {
  return element('span', {class: 'swatch', style: `background: ${color}`, 'aria-hidden': 'true'});
}

// A missing number is one that was not finite.
const missing = '–';

function whole(n) {
  return n === null ? missing : n.toLocaleString('en');
}

function fixed(x, digits) {
  return x === null ? missing : x.toFixed(digits);
}

const superscripts = {'-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷',
                      8: '⁸', 9: '⁹'};

function power_of_ten(exponent) {
  return '10' + [...String(exponent)].map((c) => superscripts[c]).join('');
}

// Three significant digits; powers of ten where zeros would have to be counted.
function number(x) {
  if (x === null) return missing;
  const size = Math.abs(x);
  if (size === 0 || (size >= 1e-3 && size < 1e5)) return String(Number(x.toPrecision(3)));
  const [digits, exponent] = x.toExponential(1).split('e');
  return `${digits}·${power_of_ten(Number(exponent))}`;
}

// A share that is not zero never reads as zero.
function percent(part, total) {
  if (!total || !part) return '0 %';
  const share = 100 * part / total;
  return share < 0.01 ? '< 0.01 %' : `${share.toFixed(share < 10 ? 2 : 1)} %`;
}

function decibel(psnr, differing) {
  return differing === 0 ? '∞' : psnr === null ? missing : `${psnr.toFixed(2)} dB`;
}

// Seconds with a resolution that fits their size.
function seconds(s) {
  if (s === null) return missing;
  return s < 0.1 ? `${(1000 * s).toFixed(1)} ms` : `${s.toFixed(s < 10 ? 2 : 1)} s`;
}
