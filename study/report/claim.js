'use strict';
// The paper's claim, and the hard cases: what is compared or tested, and what came out.

function ratio_text(part, whole) {
  return part === null || whole === null || whole === 0 || part === undefined ? missing
      : fixed(part / whole, 2);
}

// The cells of the axis `claim`, scene by scene; the first of each scene is the paper's.
function claim_groups(axis) {
  const scenes = [...new Set(axis.points.map((point) => point.scene))];
  return scenes.map((scene) => ({
    scene, points: axis.points.filter((point) => point.scene === scene)}));
}

function claim_rows(cells, group) {
  const of = (point) => cells.get(point.cell);
  const paper = of(group.points[0]);
  return group.points.map((point) => {
    const cell = of(point);
    if (cell.failed) return [group.scene, point.label, cell.failed, '', '', '', '', ''];
    const work = (field) => ratio_text(cell.counts?.[field] ?? null, paper.counts?.[field] ?? null);
    return [group.scene, point.label, fixed(cell.exact?.rms_steps ?? null, 2), seconds(cell.frame),
            ratio_text(cell.frame, paper.frame), work('fragments'), work('texel_fetches'),
            ratio_text(cell.card, paper.card)];
  });
}

function mean(values) {
  return values.length === 0 ? null : values.reduce((a, b) => a + b) / values.length;
}

// By how much of the other technique's frame the paper's is shorter, on average over the scenes.
function saving_sentence(cells, groups, index) {
  const label = groups[0].points[index].label;
  const savings = groups.map(({points}) => [cells.get(points[0].cell), cells.get(points[index].cell)])
      .filter(([paper, other]) => !paper.failed && !other.failed && other.frame > 0)
      .map(([paper, other]) => 100 * (1 - paper.frame / other.frame));
  const saved = mean(savings);
  if (saved === null) return null;
  const share = `${Math.abs(saved) < 10 ? saved.toFixed(1) : Math.round(saved)} %`;
  return element('li', {}, saved >= 0 ? `${share} less time a frame than “${label}”`
                                      : `${share.replace('-', '')} more time a frame than “${label}”`);
}

function claim_section(data, cells) {
  const axis = data.axes.find((one) => one.name === 'claim');
  if (!axis) return null;
  const groups = claim_groups(axis);
  const rows = groups.flatMap((group) => claim_rows(cells, group));
  const sentences = groups[0].points.slice(1).map(
      (point, i) => saving_sentence(cells, groups, i + 1)).filter((item) => item !== null);
  return section(
      'claim', 'The paper’s claim',
      element('div', {class: 'prose'},
              element('p', {}, 'The paper says that its method reduces work and time by about 20 % on average. It names no baseline, no scene size and no way of timing, so the sentence can be bracketed but not verified. Compared here, at equal picture and preset: the product of two factor maps in the paper’s passes, against techniques that need no factoring. Times are processor time of one frame of this renderer on one thread, and light at the vertices is computed anew for every frame. Texture environments that this renderer does not draw on vectors make a technique slower here for that reason alone (twofold explain); the columns of work and of the card’s model are free of that.'),
              element('p', {}, groups.length > 1
                  ? `On average over ${groups.length} scenes the paper’s technique takes:`
                  : 'In this scene the paper’s technique takes:'),
              element('ul', {}, ...sentences),
              element('p', {}, 'What it takes before the first frame is not in these figures; see Error against time.')),
      table('Techniques', ['Scene', 'Technique', 'RMS exact', 'A frame', 'Time over the paper’s',
                           'Fragments over', 'Fetches over', 'Card (model) over'], rows));
}

// A test's name is its title, with the case's id or without; one over several types says which.
function outcome_of(data, title) {
  const names = [title, title.slice(4)];
  const found = Object.entries(data.checks).filter(
      ([name]) => names.some((one) => name === one || name.startsWith(`${one} - `)));
  const outcomes = found.map(([, outcome]) => outcome);
  return ['failed', 'skipped', 'passed'].find((one) => outcomes.includes(one)) ?? 'not run';
}

function hard_case_row(data, title) {
  const known = Object.keys(data.checks).length > 0;
  return [title.slice(0, 3), title.slice(4), known ? outcome_of(data, title) : missing];
}

function hard_cases_section(data) {
  const rows = data.hardCases.map((title) => hard_case_row(data, title));
  const ids = new Set(rows.map(([id]) => id));
  const known = Object.keys(data.checks).length > 0;
  const failed = rows.filter((row) => row[2] === 'failed').length;
  const outcome = known
      ? `Outcomes are those of the result file that was given: ${failed} failed, ` +
        `${rows.filter((row) => row[2] === 'passed').length} passed.`
      : 'This report was made without a result file of the tests (--checks), so it says which tests there are and not how they ended: ./check runs them.';
  return section('hard-cases', 'Hard cases',
                 element('p', {class: 'lead'}, `${ids.size} cases have tests of their own in this version. ${outcome}`),
                 element('details', {}, element('summary', {}, `${rows.length} tests`),
                         table('Hard cases', ['Case', 'Test', 'Outcome'], rows)));
}
