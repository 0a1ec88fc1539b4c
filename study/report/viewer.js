'use strict';
// The large picture: two of the run's pictures on top of each other, divided by a movable line.

// Pixels of a picture as stored, without colour management. A canvas multiplies by alpha, so values
// are exact where alpha is 255, and where it is 0 only alpha is.
async function read_pixels(image) {
  await image.decode();
  const {naturalWidth: width, naturalHeight: height} = image;
  const bitmap = await createImageBitmap(image, {colorSpaceConversion: 'none'});
  const context = element('canvas', {width, height}).getContext('2d', {willReadFrequently: true});
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, width, height);
}

function pixel_at(pixels, x, y) {
  return [...pixels.data.slice(4 * (y * pixels.width + x), 4 * (y * pixels.width + x) + 4)];
}

function choice(label, names, chosen, onchange) {
  const options = names.map((name) => element('option', {selected: name === chosen}, name));
  return element('label', {}, `${label} `, element('select', {onchange}, ...options));
}

function radio_group(legend, name, choices, chosen, onchange) {
  const radio = ([value, text]) => element(
      'label', {}, element('input', {type: 'radio', name, value, checked: value === chosen,
                                     onchange: () => onchange(value)}),
      element('span', {}, text));
  return element('fieldset', {}, element('legend', {}, legend), ...choices.map(radio));
}

class Viewer {
  constructor(data) {
    this.data = data;
    this.names = data.pictures.filter((p) => p.src).map((p) => p.name);
    this.images = new Map();
    this.pixels = new Map();
    this.zoom = 'fit';
    this.view = 'slider';
    this.right = this.names.includes('nv17') ? 'nv17' : this.names[this.names.length - 1];
    this.left = this.names.find((name) => name !== this.right) ?? this.right;
    this.build();
    this.show();
  }

  build() {
    const choose = (side) => (event) => { this[side] = event.target.value; this.show(); };
    this.left_choice = choice('Left', this.names, this.left, choose('left'));
    this.right_choice = choice('Right', this.names, this.right, choose('right'));
    const views = [['slider', 'Pictures'], ['heat', 'Heat map']];
    this.view_choice = radio_group('View', 'view', views, this.view, (view) => this.set_view(view));
    const zooms = [['fit', 'Fit'], ...['1', '2', '4', '8'].map((z) => [z, `${z}×`])];
    this.controls = element(
        'div', {class: 'controls'}, this.left_choice, this.right_choice, this.view_choice,
        radio_group('Zoom', 'zoom', zooms, this.zoom, (zoom) => this.set_zoom(zoom)));
    this.build_stage();
    this.legend = heat_legend(this.data);
    this.readout = element('p', {class: 'readout', 'aria-live': 'polite'});
    this.readout.append('Point at the picture, or focus it and press the arrow keys, ' +
                        'to read the values of a pixel.');
    this.node = element('div', {}, this.controls, this.frame, this.legend, this.readout);
  }

  build_stage() {
    this.canvas = element('div', {class: 'canvas'});
    this.marker = element('div', {class: 'marker', hidden: true});
    this.stage = element('div', {class: 'stage', tabindex: '0', role: 'group',
                                 onscroll: () => this.place_divider(),
                                 onkeydown: (event) => this.step_marker(event)}, this.canvas);
    this.divider = element('div', {class: 'divider', 'aria-hidden': 'true'});
    this.left_tag = element('span', {class: 'tag left', 'aria-hidden': 'true'});
    this.right_tag = element('span', {class: 'tag right', 'aria-hidden': 'true'});
    this.range = element('input', {type: 'range', min: 0, max: 1000, value: 500,
                                   'aria-label': 'Dividing line between left and right picture',
                                   oninput: () => this.place_divider()});
    this.window = element('div', {class: 'window', onpointerdown: (event) => this.grab(event),
                                  onpointermove: (event) => this.move(event)},
                          this.stage, this.divider, this.left_tag, this.right_tag);
    this.frame = element('div', {class: 'frame'}, this.window, this.range);
    new ResizeObserver(() => this.place_divider()).observe(this.stage);
  }

  comparison() {
    const pairs = [[this.left, this.right], [this.right, this.left]];
    return this.data.comparisons.find(
        (c) => pairs.some(([a, b]) => c.picture === a && c.reference === b));
  }

  has_heat() {
    return Boolean(this.comparison()?.heat);
  }

  heat_image() {
    const {picture, reference, heat} = this.comparison();
    return this.image('heat', `${picture} against ${reference}`, heat);
  }

  // One element for each use of a picture, kept, so that changing back does not decode again.
  image(role, name, src) {
    const key = `${role} ${name}`;
    if (!this.images.has(key)) {
      const alt = role === 'heat' ? `Heat map of ${name}` : `Picture ${name}`;
      this.images.set(key, element('img', {src, alt, draggable: 'false'}));
    }
    return this.images.get(key);
  }

  picture(role, name) {
    return this.image(role, name, this.data.pictures.find((p) => p.name === name).src);
  }

  show() {
    const has_heat = this.has_heat();
    if (!has_heat) this.view = 'slider';
    for (const radio of this.view_choice.querySelectorAll('input')) {
      radio.checked = radio.value === this.view;
      radio.disabled = radio.value === 'heat' && !has_heat;
    }
    this.heat_shown = this.view === 'heat';
    const shown = this.heat_shown
        ? [this.heat_image()]
        : [this.picture('right', this.right), this.picture('left', this.left)];
    this.canvas.replaceChildren(...shown, this.marker);
    this.label();
    this.lay_out();
    this.update_readout();
  }

  label() {
    this.frame.classList.toggle('heat', this.heat_shown);
    this.legend.hidden = !this.heat_shown;
    this.left_tag.textContent = this.left;
    this.right_tag.textContent = this.right;
    this.stage.setAttribute('aria-label', this.heat_shown
        ? `Heat map of ${this.left} and ${this.right}`
        : `${this.left} on the left, ${this.right} on the right`);
  }

  // Small pictures are enlarged by a whole factor to fit, so that their pixels stay squares.
  lay_out() {
    const image = this.canvas.querySelector('img');
    image.decode().then(() => {
      const natural = image.naturalWidth;
      const scale = this.zoom === 'fit' ? Math.ceil(600 / natural) : Number(this.zoom);
      this.frame.style.width = `min(100%, ${natural * scale}px)`;
      this.canvas.style.width = this.zoom === 'fit' ? '100%' : `${natural * scale}px`;
      this.stage.classList.toggle('enlarged', scale > 1);
      this.place_divider();
    });
  }

  // Shows a pair from elsewhere on the page, menus included.
  choose(left, right) {
    [this.left, this.right] = [left, right];
    this.left_choice.querySelector('select').value = left;
    this.right_choice.querySelector('select').value = right;
    this.show();
    this.node.scrollIntoView({block: 'start'});
  }

  set_view(view) {
    this.view = view;
    this.show();
  }

  // The middle of the visible part stays in the middle.
  set_zoom(zoom) {
    const {stage} = this;
    const middle_x = (stage.scrollLeft + stage.clientWidth / 2) / stage.scrollWidth;
    const middle_y = (stage.scrollTop + stage.clientHeight / 2) / stage.scrollHeight;
    this.zoom = zoom;
    this.lay_out();
    requestAnimationFrame(() => {
      stage.scrollLeft = middle_x * stage.scrollWidth - stage.clientWidth / 2;
      stage.scrollTop = middle_y * stage.scrollHeight - stage.clientHeight / 2;
    });
  }

  // The line keeps its place in the window; the pictures under it may be scrolled.
  place_divider() {
    const share = this.range.value / 1000;
    const along = share * this.stage.clientWidth;
    const cut = 100 * (this.stage.scrollLeft + along) / (this.canvas.clientWidth || 1);
    this.divider.style.left = `${along}px`;
    this.range.setAttribute('aria-valuetext', `${Math.round(100 * share)} % ${this.left}`);
    if (this.heat_shown) return;
    const [right, left] = this.canvas.querySelectorAll('img');
    left.style.clipPath = `inset(0 ${100 - cut}% 0 0)`;
    right.style.clipPath = `inset(0 0 0 ${cut}%)`;
  }

  // A mouse drags the line from anywhere; a finger only by its handle, elsewhere it scrolls.
  grab(event) {
    const on_divider = event.target === this.divider;
    const on_scroll_bar = event.target === this.stage;
    if (this.heat_shown || on_scroll_bar || (event.pointerType !== 'mouse' && !on_divider)) return;
    this.window.setPointerCapture(event.pointerId);
    this.drag_to(event);
  }

  move(event) {
    if (this.window.hasPointerCapture(event.pointerId)) this.drag_to(event);
    const box = this.canvas.getBoundingClientRect();
    const {naturalWidth, naturalHeight} = this.canvas.querySelector('img');
    this.inspect(Math.floor((event.clientX - box.left) / box.width * naturalWidth),
                 Math.floor((event.clientY - box.top) / box.height * naturalHeight));
  }

  drag_to(event) {
    const box = this.stage.getBoundingClientRect();
    this.range.value = Math.round(1000 * (event.clientX - box.left) / box.width);
    this.place_divider();
  }

  step_marker(event) {
    const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
    if (!(event.key in step)) return;
    event.preventDefault();
    const {naturalWidth, naturalHeight} = this.canvas.querySelector('img');
    const [x, y] = this.at ?? [naturalWidth >> 1, naturalHeight >> 1];
    const [dx, dy] = step[event.key].map((d) => d * (event.shiftKey ? 10 : 1));
    this.inspect(Math.min(naturalWidth - 1, Math.max(0, x + dx)),
                 Math.min(naturalHeight - 1, Math.max(0, y + dy)));
    this.marker.scrollIntoView({block: 'nearest', inline: 'nearest'});
  }

  inspect(x, y) {
    const {naturalWidth, naturalHeight} = this.canvas.querySelector('img');
    if (x < 0 || y < 0 || x >= naturalWidth || y >= naturalHeight) return;
    this.at = [x, y];
    this.marker.hidden = false;
    this.marker.style.cssText =
        `left: ${100 * x / naturalWidth}%; top: ${100 * y / naturalHeight}%;` +
        `width: ${100 / naturalWidth}%; height: ${100 / naturalHeight}%`;
    this.update_readout();
  }

  async pixels_of(name) {
    if (!this.pixels.has(name)) this.pixels.set(name, read_pixels(this.picture('left', name)));
    return this.pixels.get(name);
  }

  // While the pixels are read the pointer may move on: only the newest answer is shown.
  async update_readout() {
    if (!this.at) return;
    const asked = this.asked = {at: this.at, left: this.left, right: this.right};
    const [a, b] = [await this.pixels_of(asked.left), await this.pixels_of(asked.right)];
    if (asked !== this.asked) return;
    const [p, q] = [pixel_at(a, ...asked.at), pixel_at(b, ...asked.at)];
    this.readout.replaceChildren(
        element('span', {}, `x ${asked.at[0]}, y ${asked.at[1]}`),
        color_text(asked.left, p), color_text(asked.right, q),
        element('span', {}, `difference ${p.map((v, c) => Math.abs(v - q[c])).join(' ')}`));
  }
}

function color_text(name, [r, g, b, a]) {
  return element('span', {}, swatch(`rgb(${r} ${g} ${b} / ${a / 255})`),
                 `${name} ${a === 0 ? 'not covered' : `${r} ${g} ${b} ${a}`}`);
}

// The full scale of the heat maps in words, where it is stated and the same for all.
function full_scale(data) {
  const scales = new Set(data.comparisons.filter((c) => c.heat).map((c) => c.fullScale));
  const [scale] = scales;
  return scales.size === 1 && scale > 0 ? `${scale} steps or more` : 'full scale';
}

// The key to all heat maps; colours come from the program that drew them.
function heat_legend(data) {
  const [none, ...ramp] = data.heatColors;
  return element(
      'p', {class: 'legend'}, element('span', {}, swatch(none), 'equal'),
      element('span', {}, '1 step', element('span', {
        class: 'ramp', style: `background: linear-gradient(90deg, ${ramp.join(', ')})`,
        'aria-hidden': 'true'}), full_scale(data)),
      element('span', {}, swatch(data.coverageColor), 'covered in only one'));
}
