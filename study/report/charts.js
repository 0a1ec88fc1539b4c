'use strict';
// Small drawings in SVG: histograms of differences and the solver's convergence.

// Pixels by their largest difference. The heights are logarithmic, since most pixels are equal or
// one step apart and the few far ones matter.
function histogram(comparison) {
  const [width, height, left, bottom, top] = [340, 130, 34, 22, 14];
  const counts = comparison.histogram;
  const slots = Math.max(counts.length, 16);
  const decades = Math.max(1, Math.ceil(Math.log10(Math.max(...counts, 1) + 1)));
  const x = (step) => left + (width - left) * step / slots;
  const y = (count) => height - bottom - (height - bottom - top) * Math.log10(count + 1) / decades;
  const slot = (width - left) / slots;
  const bar_width = slot < 3 ? slot : slot - 0.8;
  const bars = counts.map((count, step) => count === 0 ? null : svg(
      'rect', {x: x(step), y: y(count), width: bar_width, height: height - bottom - y(count),
               class: 'bar'},
      svg('title', {}, `${step} steps: ${whole(count)} pixels`)));
  return svg('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img',
                     'aria-label': histogram_text(comparison)},
             ...decade_lines(decades, y, left, width), ...bars,
             ...step_labels(slots, x, slot, height - 7));
}

function histogram_text(c) {
  return `Histogram of differences between ${c.picture} and ${c.reference}: ` +
         `${whole(c.differing)} of ${whole(c.compared)} pixels differ, at most by ${c.max} steps`;
}

// At most four lines, so that their labels stay apart.
function decade_lines(decades, y, left, right) {
  const lines = [];
  for (let d = 0; d <= decades; d += Math.ceil(decades / 4)) {
    const at = y(10 ** d - 1);
    lines.push(svg('line', {x1: left, x2: right, y1: at, y2: at, class: 'grid'}));
    const label = d === 0 ? '0' : power_of_ten(d);
    lines.push(svg('text', {x: left - 6, y: at + 3.5, class: 'end'}, label));
  }
  return lines;
}

function step_labels(slots, x, slot_width, y) {
  const every = [1, 2, 4, 8, 16, 32, 64].find((n) => slots / n <= 8);
  const labels = [];
  for (let step = 0; step < slots; step += every) {
    labels.push(svg('text', {x: x(step) + slot_width / 2, y, class: 'middle'}, String(step)));
  }
  return labels;
}

const channel_names = ['red', 'green', 'blue'];

// Relative residual after each iteration, on a logarithmic scale.
function convergence(material) {
  const histories = material.channels.map((channel) => channel.history);
  const drawable = histories.flat().filter((value) => value !== null && value > 0);
  if (drawable.length === 0) return null;
  const plot = convergence_scales(histories, drawable);
  const lines = histories.map((history, channel) => svg(
      'polyline', {points: plot_points(history, plot), class: `line ${channel_names[channel]}`}));
  return element(
      'figure', {class: 'convergence'},
      element('figcaption', {}, 'Relative residual over iterations ', ...channel_names.map(
          (name) => element('span', {class: 'key'}, svg('svg', {
            viewBox: '0 0 26 8', width: 26, height: 8, 'aria-hidden': 'true'}, svg('line', {
              x1: 0, x2: 26, y1: 4, y2: 4, class: `line ${name}`})), name))),
      svg('svg', {viewBox: `0 0 ${plot.width} ${plot.height}`, role: 'img',
                  'aria-label': convergence_text(material)},
          ...residual_grid(plot), ...iteration_labels(plot), ...lines));
}

function convergence_text(material) {
  const ends = material.channels.map(
      (fit, c) => `${channel_names[c]} ${fit.iterations} iterations to ${number(fit.residual)}`);
  return `Convergence of ${material.name}: ${ends.join(', ')}`;
}

function convergence_scales(histories, drawable) {
  const [width, height, left, bottom, top, right] = [720, 240, 46, 26, 10, 12];
  const logs = drawable.map(Math.log10);
  const low = Math.floor(logs.reduce((a, b) => Math.min(a, b)));
  const high = Math.max(low + 1, Math.ceil(logs.reduce((a, b) => Math.max(a, b))));
  const last = Math.max(1, ...histories.map((history) => history.length));
  const x = (iteration) => left + (width - left - right) * iteration / last;
  const y = (log) => top + (height - bottom - top) * (high - log) / (high - low);
  return {width, height, left, right, low, high, last, x, y};
}

function plot_points(history, {x, y}) {
  return history.map((value, i) => value > 0
      ? `${x(i + 1).toFixed(1)},${y(Math.log10(value)).toFixed(1)}` : '').join(' ');
}

function residual_grid({low, high, left, right, width, y}) {
  const lines = [];
  for (let log = low; log <= high; log += Math.ceil((high - low) / 6)) {
    lines.push(svg('line', {x1: left, x2: width - right, y1: y(log), y2: y(log), class: 'grid'}));
    lines.push(svg('text', {x: left - 8, y: y(log) + 4, class: 'end'}, power_of_ten(log)));
  }
  return lines;
}

function iteration_labels({last, height, x}) {
  const rough = 10 ** Math.floor(Math.log10(last));
  const steps = [0.1, 0.2, 0.5, 1].map((part) => Math.max(1, part * rough));
  const step = steps.find((s) => last / s <= 10) ?? rough;
  const labels = [];
  for (let i = 0; i <= last; i += step) {
    labels.push(svg('text', {x: x(i), y: height - 8, class: 'middle'}, String(i)));
  }
  return labels;
}

// Horizontal bars: a step's name, its share of the time and the figure.
function time_bars(steps) {
  const total = steps.reduce((sum, step) => sum + (step.seconds ?? 0), 0);
  const longest = steps.reduce((most, step) => Math.max(most, step.seconds ?? 0), 0) || 1;
  const row = (step) => element(
      'li', {}, element('span', {}, step.name),
      element('span', {class: 'track', 'aria-hidden': 'true'}, element('span', {
        style: `width: ${100 * (step.seconds ?? 0) / longest}%`})),
      element('span', {class: 'figure'}, seconds(step.seconds)),
      element('span', {class: 'figure share'}, percent(step.seconds, total)));
  return element('ul', {class: 'times'}, ...steps.map(row),
                 element('li', {class: 'total'}, element('span', {}, 'together'), element('span'),
                         element('span', {class: 'figure'}, seconds(total)), element('span')));
}
