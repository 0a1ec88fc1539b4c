'use strict';
// The page of a study: its figures are there already; this makes their points open pictures, and
// adds what is best looked up than drawn.

const data = JSON.parse(document.getElementById('data').textContent);
const cells = new Map(data.cells.map((cell) => [cell.id, cell]));

// --- Pictures of any two cells ---------------------------------------------------------------

const heat_full_scale = 32;

function rgb_of(text) {
  return text.match(/\d+/g).map(Number);
}

// As the program's own heat maps: one step already stands off from equality.
function heat_rgb(steps) {
  const [none, ...ramp] = data.heatColors.map(rgb_of);
  if (steps === 0) return none;
  const along = Math.min(1, (steps - 1) / (heat_full_scale - 1)) * (ramp.length - 1);
  const [from, to] = [ramp[Math.floor(along)], ramp[Math.ceil(along)]];
  return from.map((value, c) => Math.round(value + (to[c] - value) * (along % 1)));
}

function heat_url(a, b) {
  const {width, height} = a;
  const canvas = element('canvas', {width, height});
  const context = canvas.getContext('2d');
  const image = context.createImageData(width, height);
  const outline = rgb_of(data.coverageColor);
  for (let i = 0; i < image.data.length; i += 4) {
    const [p, q] = [a.data.subarray(i, i + 4), b.data.subarray(i, i + 4)];
    const most = Math.max(...p.map((value, c) => Math.abs(value - q[c])));
    const covered = [p[3] !== 0, q[3] !== 0];
    if (!covered[0] && !covered[1]) continue;
    image.data.set(covered[0] === covered[1] ? heat_rgb(most) : outline, i);
    image.data[i + 3] = 255;
  }
  context.putImageData(image, 0, 0);
  return canvas.toDataURL();
}

class StudyViewer extends Viewer {
  has_heat() {
    return true;
  }

  // The right picture stands in until the map is computed.
  heat_image() {
    const key = `heat ${this.left} against ${this.right}`;
    if (this.images.has(key)) return this.images.get(key);
    this.make_heat_image(key, this.left, this.right);
    return this.picture('right', this.right);
  }

  async make_heat_image(key, left, right) {
    const [a, b] = [await this.pixels_of(left), await this.pixels_of(right)];
    if (this.images.has(key)) return;
    this.images.set(key, element('img', {
      src: heat_url(a, b), alt: `Heat map of ${left} and ${right}`, draggable: 'false'}));
    if (this.heat_shown) this.show();
  }

  source(name) {
    return this.data.pictures.find((picture) => picture.name === name).src;
  }

  label() {
    super.label();
    chosen(this.right);
  }
}

function picture_list() {
  return data.cells.filter((cell) => !cell.failed).map(
      (cell) => ({name: cell.name, src: data.sources[cell.hash]}));
}

let viewer = null;

function open_cell(id) {
  const cell = cells.get(id);
  if (!viewer || cell.failed) return;
  viewer.choose(viewer.left, cell.name);
}

// Marks the cell in every figure and describes it.
function chosen(name) {
  const cell = data.cells.find((one) => one.name === name);
  for (const point of document.querySelectorAll('.point')) {
    point.classList.toggle('chosen', point.dataset.cell === cell.id);
  }
  document.getElementById('details')?.replaceChildren(...details(cell));
}

// --- A cell in words -------------------------------------------------------------------------

function steps_text(errors) {
  if (!errors) return null;
  return `${fixed(errors.rms_steps, 3)} steps RMS, at most ${errors.max_steps}, ` +
         `${decibel(errors.psnr_db, errors.differing_pixels)}`;
}

function share(value) {
  return value === null || value === undefined ? missing : percent(value, 1);
}

function frame_text(cell) {
  const times = cell.frameTimes;
  const [low, high] = times.processor.quartiles;
  return `${seconds(cell.frame)} (least of ${times.rounds} rounds ` +
         `${seconds(times.processor.least)}, median ${seconds(times.processor.median)}, quartiles ` +
         `${seconds(low)} to ${seconds(high)}; wall ${seconds(times.wall.median)})`;
}

function details(cell) {
  const {exact, ideal, work} = cell;
  const facts = fact_list([
    ['Cell', element('code', {}, cell.id)],
    ['Drawn', [cell.preset, cell.technique, cell.way, cell.filter].join(', ')],
    ['Against exact', steps_text(exact)],
    ['Relative RMS', exact ? number(exact.relative_rms) : null],
    ['Clipped, vanished', exact ? `${share(exact.clipped_share)}, ${share(exact.vanished_share)}` : null],
    ['Against ideal64', steps_text(ideal)],
    ['A frame', frame_text(cell)],
    ['Before the first frame', cell.before === null ? null : seconds(cell.before)],
    ['On the card (model)', cell.card === null ? null : seconds(cell.card)],
    ['Passes, texel fetches, textures', work ? `${work.passes}, ${whole(work.texel_fetches)}, ` +
                                               `${whole(work.texture_bytes)} bytes` : null],
    ['Warnings', cell.warnings.join('; ')]]);
  const errors = exact ?? ideal;
  const chart = errors && histogram({
    picture: cell.name, reference: exact ? 'exact' : 'ideal64', histogram: errors.histogram,
    differing: errors.differing_pixels, compared: errors.pixels_compared, max: errors.max_steps});
  return [element('div', {}, element('h3', {}, cell.name), element('dl', {class: 'facts'}, ...facts)),
          element('div', {}, chart,
                  element('p', {class: 'caption'}, 'Pixels by difference in steps of 1/255'))];
}

function build_viewer() {
  const pictures = picture_list();
  if (pictures.length === 0) return;
  const place = document.getElementById('viewer');
  place.append(element('div', {id: 'details', class: 'details', 'aria-live': 'polite'}));
  viewer = new StudyViewer({...data, pictures, comparisons: []});
  const exact = data.cells.find((cell) => cell.technique === 'exact' && !cell.failed);
  const base = cells.get(data.base);
  if (!base.failed) {
    [viewer.left, viewer.right] = [(exact ?? base).name, base.name];
    viewer.left_choice.querySelector('select').value = viewer.left;
    viewer.right_choice.querySelector('select').value = viewer.right;
    viewer.show();
  }
  place.prepend(viewer.node);
}

// --- Figures ---------------------------------------------------------------------------------

const tip = element('div', {class: 'tip', role: 'status', hidden: true});

function show_tip(point) {
  tip.textContent = point.querySelector('title').textContent;
  const box = point.getBoundingClientRect();
  tip.hidden = false;
  tip.style.left = `${Math.min(box.right + 8 + scrollX, scrollX + innerWidth - tip.offsetWidth - 16)}px`;
  tip.style.top = `${box.top + scrollY - tip.offsetHeight - 6}px`;
}

function enliven_point(point) {
  point.setAttribute('aria-label', point.querySelector('title').textContent);
  const open = () => open_cell(point.dataset.cell);
  for (const event of ['pointerenter', 'focus']) point.addEventListener(event, () => show_tip(point));
  for (const event of ['pointerleave', 'blur']) point.addEventListener(event, () => { tip.hidden = true; });
  point.addEventListener('click', open);
  point.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    open();
  });
}

function trade_controls() {
  const plots = [...document.querySelectorAll('#trade .plot')];
  if (plots.length === 0) return [];
  const show = (id) => plots.forEach((plot) => { plot.hidden = plot.id !== id; });
  show(plots[0].id);
  const names = {'plot-error-frame': 'A frame here', 'plot-error-before': 'Before the first frame',
                 'plot-error-card': 'A frame on the card'};
  const choice = radio_group('Time', 'time', plots.map((plot) => [plot.id, names[plot.id]]),
                             plots[0].id, show);
  const toggle = (name) => (event) => {
    for (const series of document.querySelectorAll(`#trade [data-axis="${name}"]`)) {
      series.classList.toggle('off', !event.target.checked);
    }
  };
  const boxes = data.axes.map((axis) => element(
      'label', {}, element('input', {type: 'checkbox', checked: true, onchange: toggle(axis.name)}),
      ` ${axis.title}`));
  return [element('div', {class: 'controls'}, choice),
          element('div', {class: 'filters', role: 'group', 'aria-label': 'Shown axes'}, ...boxes)];
}

// --- The page --------------------------------------------------------------------------------

function navigation() {
  return [...document.querySelectorAll('main section')].map((part) => element(
      'a', {href: `#${part.id}`}, part.querySelector('h2').textContent));
}

function build() {
  document.getElementById('version').textContent = data.version;
  for (const id of ['budget', 'settings']) {
    if (!document.querySelector(`#${id} .plot`)) document.getElementById(id).remove();
  }
  document.getElementById('trade-controls').append(...trade_controls());
  document.body.append(tip);
  document.querySelectorAll('.point').forEach(enliven_point);
  build_viewer();
  const rest = [scale_section(), claim_section(data, cells), cells_section(),
                hard_cases_section(data), provenance_section()];
  document.getElementById('rest').replaceChildren(...rest.filter((part) => part !== null));
  document.getElementById('navigation').append(...navigation());
}

// The outcome is left on the root element, where a test without a screen can read it.
async function main() {
  page.dataset.painted = String(performance.now());
  build();
  const images = [...document.images];
  const results = await Promise.all(images.map((image) => image.decode().then(() => true, () => false)));
  if (results.includes(false)) count_error();
  page.dataset.images = String(results.filter((ok) => ok).length);
  page.dataset.ready = '1';
}

main();
