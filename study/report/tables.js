'use strict';
// The tables of a study's page, over its data and cells (study.js).

function scale_section() {
  const axis = data.axes.find((one) => one.name === 'scale');
  if (!axis) return null;
  const pair = (c, field) => `${fixed(100 * c[field].t1, 1)}, ${fixed(100 * c[field].t2, 1)}`;
  const rows = axis.points.flatMap((point) => {
    const cell = cells.get(point.cell);
    if (cell.failed) return [];
    return cell.scales.map((scale) => [
      `${point.label}, ${scale.material}`, fixed(cell.exact?.rms_steps ?? null, 3),
      fixed(cell.ideal?.rms_steps ?? null, 3), `×${scale.combinerScale}`, whole(scale.doublings),
      scale.c.map(number).join(', '),
      scale.channels.map((c) => `${c.levels.t1}, ${c.levels.t2}`).join(' / '),
      scale.channels.map((c) => pair(c, 'zero')).join(' / '),
      scale.channels.map((c) => pair(c, 'clipped')).join(' / ')]);
  });
  return section(
      'scale', 'Normalisation',
      element('p', {class: 'lead'}, 'What the maps are divided by decides how many of the 255 levels are used, and what the combiner has to scale up again. Shares and levels are of t1, t2, red / green / blue.'),
      table('Normalisation', ['Rule', 'RMS exact', 'RMS ideal64', 'Scale', 'Doublings', 'c',
                              'Levels', 'Stored as 0, %', 'Clipped, %'], rows));
}

function cell_row(axis, point) {
  const cell = cells.get(point.cell);
  const label = [point.scene, point.label].filter((text) => text !== '').join(', ');
  const row = cell.failed
      ? [axis.title, label, cell.preset, `failed: ${cell.failed}`]
      : [axis.title, label, cell.preset, fixed(cell.exact?.rms_steps ?? null, 3),
         whole(cell.exact?.max_steps ?? null), fixed(cell.ideal?.rms_steps ?? null, 3),
         share(cell.exact?.clipped_share), share(cell.exact?.vanished_share), seconds(cell.frame),
         seconds(cell.before), seconds(cell.card), whole(cell.counts?.passes ?? null),
         whole(cell.counts?.texel_fetches ?? null)];
  return {row, open: () => open_cell(point.cell)};
}

function cells_section() {
  const rows = data.axes.flatMap((axis) => axis.points.map((point) => cell_row(axis, point)));
  const shown = table('Cells', ['Axis', 'Cell', 'Preset', 'RMS exact', 'Most', 'RMS ideal64', 'Clipped',
                                'Vanished', 'A frame', 'Before', 'Card (model)', 'Passes', 'Fetches'],
                      rows.map(({row}) => row));
  const lines = [...shown.querySelectorAll('tbody tr')];
  lines.forEach((line, i) => {
    line.tabIndex = 0;
    line.addEventListener('click', rows[i].open);
    line.addEventListener('keydown', (event) => { if (event.key === 'Enter') rows[i].open(); });
  });
  const filter = (event) => {
    const words = event.target.value.toLowerCase().split(/\s+/);
    for (const line of lines) {
      const text = line.textContent.toLowerCase();
      line.hidden = !words.every((word) => text.includes(word));
    }
  };
  return section('cells', 'All cells',
                 element('div', {class: 'controls'}, element('label', {}, 'Filter ', element(
                     'input', {type: 'search', id: 'filter', oninput: filter}))),
                 shown);
}

function provenance_section() {
  const rows = Object.entries(data.provenance).filter(([, value]) => value !== '').map(
      ([name, value]) => [name, value]);
  const hashes = data.cells.filter((cell) => !cell.failed).map(
      (cell) => [cell.name, element('code', {}, `${cell.id} ${cell.hash}`)]);
  return section('provenance', 'Provenance', table('Provenance', ['What', 'Value'], rows),
                 element('details', {}, element('summary', {}, 'Hashes of cells and pictures'),
                         table('Hashes', ['Cell', 'Cell and picture'], hashes)));
}
