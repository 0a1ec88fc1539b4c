'use strict';
// Builds the page from top to bottom out of the data, and says when everything is shown.

function facts(data) {
  const averaging = data.averagingCost === null ? null : `${number(100 * data.averagingCost)} %`;
  return fact_list([
    ['Scene', data.scene], ['Environment', data.environment],
    ['White', data.white === null ? null : `radiance ${number(data.white)}`],
    ['Error of averaging the environment', averaging],
    ['Command', data.command === '' ? null : element('code', {}, data.command)]]);
}

function warnings(data) {
  if (data.warnings.length === 0) return [];
  const title = data.warnings.length === 1 ? 'Warning' : 'Warnings';
  return [element('div', {class: 'warning', role: 'note'}, element('strong', {}, title),
                  element('ul', {}, ...data.warnings.map((text) => element('li', {}, text))))];
}

function pictures_section(data, viewer) {
  return viewer && section('pictures', 'Pictures', viewer.node);
}

function comparison_table(data) {
  const head = ['Picture', 'Reference', 'Compared', 'Differing', 'Coverage differs',
                'First at x, y', 'Most', 'RMS', 'PSNR'];
  const differing = (c) => [whole(c.differing),
                            element('small', {}, ` ${percent(c.differing, c.compared)}`)];
  const rows = data.comparisons.map((c) => [
    c.picture, c.reference, whole(c.compared), element('span', {}, ...differing(c)),
    whole(c.coverage), c.first ? c.first.join(', ') : missing,
    ...(c.compared > 0 ? [whole(c.max), fixed(c.rms, 3), decibel(c.psnr, c.differing)]
                       : [missing, missing, missing])]);
  return table('Comparisons', head, rows);
}

function difference_in_words(c) {
  if (c.compared === 0) return ['no pixel in common'];
  return [element('strong', {}, fixed(c.rms, 2)), ' steps RMS, at most ',
          element('strong', {}, whole(c.max))];
}

// Choosing a card shows its pair in the large picture.
function comparison_card(data, viewer, c) {
  const alt = `Heat map of ${c.picture} against ${c.reference}, full scale ${c.fullScale} steps`;
  const heat = c.heat && element('img', {src: c.heat, alt});
  const show = () => viewer.choose(c.reference, c.picture);
  const shown = viewer && [c.picture, c.reference].every((name) => viewer.names.includes(name));
  return element(
      'article', {class: 'card'},
      element('h3', {}, c.picture, element('span', {class: 'against'}, ' against '), c.reference),
      element('p', {class: 'figures'}, ...difference_in_words(c)),
      heat && element('div', {class: 'heat-map'}, heat),
      histogram(c),
      element('p', {class: 'caption'}, 'Pixels by difference in steps'),
      shown ? element('button', {type: 'button', onclick: show}, 'Show this pair') : null);
}

function differences_section(data, viewer) {
  if (data.comparisons.length === 0) return null;
  return section(
      'differences', 'Differences',
      element('p', {class: 'lead'},
              'One step is 1/255, the distance of neighbouring 8-bit values. Compared are the pixels that the scene covers in both pictures.'),
      comparison_table(data),
      data.comparisons.some((c) => c.heat) ? heat_legend(data) : null,
      element('div', {class: 'cards'},
              ...data.comparisons.map((c) => comparison_card(data, viewer, c))));
}

function map_figure(map, size) {
  if (!map.src) return null;
  return element('figure', {}, element('img', {src: map.src, alt: `Factor map ${map.name}`}),
                 element('figcaption', {}, map.name, element('small', {}, ` ${size} × ${size}`)));
}

function scale_text([r, g, b]) {
  const percentages = [r, g, b].map((value) => `${100 * (value ?? 0)}%`).join(' ');
  return element('span', {}, swatch(`rgb(${percentages})`), [r, g, b].map(number).join(', '));
}

function treated_text(channel) {
  if (channel.treated.length === 0) return 'none';
  return channel.treated.map(([name, count]) => `${name} ${whole(count)}`).join(', ');
}

function fit_table(material) {
  const head = ['Channel', 'Solver', 'Iterations', 'Residual', 'Relative RMS', 'Log RMS', 'Median',
                '95 %', 'PSNR, dB', 'Scale c', 'Treated samples'];
  const rows = material.channels.map((fit, c) => [
    channel_names[c], fit.status, whole(fit.iterations), number(fit.residual),
    number(fit.relativeRms), number(fit.logRms), number(fit.median), number(fit.p95),
    number(fit.psnr), number(fit.scale), treated_text(fit)]);
  return table(`Fit of ${material.name}`, head, rows);
}

function material_article(material) {
  return element(
      'article', {class: 'material'}, element('h3', {}, material.name),
      element('p', {class: 'lead'}, material.brdf),
      element('dl', {class: 'facts'}, ...fact_list([
                ['Model', material.model],
                ['Passes', whole(material.passes)],
                ['Combiner scale', `×${material.combinerScale}`],
                ['Doubling passes', whole(material.doublingPasses)],
                ['Scale colour', scale_text(material.scaleColor)]])),
      element('div', {class: 'maps'},
              ...material.maps.map((map) => map_figure(map, material.mapSize))),
      fit_table(material), convergence(material));
}

function materials_section(data) {
  if (data.materials.length === 0) return null;
  return section('materials', 'Factors', ...data.materials.map(material_article));
}

function time_section(data) {
  return data.steps.length === 0 ? null : section('time', 'Time', time_bars(data.steps));
}

function notes_section(data) {
  if (data.notes.length === 0 && data.presets.length === 0) return null;
  return section('presets', 'Presets and notes',
                 element('dl', {class: 'sentences'}, ...fact_list(data.presets)),
                 element('ul', {class: 'notes'},
                         ...data.notes.map((note) => element('li', {}, note))));
}

function provenance_section(data) {
  const maps = data.materials.flatMap(
      (material) => material.maps.map((map) => [`${material.name}, ${map.name}`, map.hash]));
  const pictures = data.pictures.map((picture) => [`picture ${picture.name}`, picture.hash]);
  const rows = [...data.provenance, ...pictures, ...maps].filter(([, value]) => value !== '');
  if (rows.length === 0) return null;
  const cells = rows.map(([name, value]) => [name, element('code', {}, value)]);
  return section('provenance', 'Provenance', table('Provenance', ['What', 'Hash or source'], cells));
}

function navigation(sections) {
  return element('nav', {'aria-label': 'Parts of this page'}, ...sections.map(
      (part) => element('a', {href: `#${part.id}`}, part.querySelector('h2').textContent)));
}

async function decoded(image) {
  try {
    await image.decode();
    return true;
  } catch {
    count_error();
    return false;
  }
}

function build(data) {
  document.getElementById('version').textContent = data.version;
  document.getElementById('warnings').append(...warnings(data));
  document.getElementById('facts').append(...facts(data));
  const viewer = data.pictures.some((picture) => picture.src) ? new Viewer(data) : null;
  const sections = [pictures_section(data, viewer), differences_section(data, viewer),
                    materials_section(data), time_section(data), notes_section(data),
                    provenance_section(data)].filter((part) => part !== null);
  document.getElementById('page').replaceChildren(navigation(sections), ...sections);
}

// The outcome is left on the root element, where a test without a screen can read it.
async function main() {
  build(JSON.parse(document.getElementById('data').textContent));
  const results = await Promise.all([...document.images].map(decoded));
  page.dataset.images = String(results.filter((ok) => ok).length);
  page.dataset.ready = '1';
}

main();
