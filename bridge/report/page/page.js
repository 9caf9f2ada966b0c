// The report, chapter by chapter, from the data that the program has put into the page.
const report = JSON.parse(document.getElementById('data').textContent);
const chapter = name => document.getElementById(name);

function writeHead() {
  document.title = report.title;
  document.getElementById('title').textContent = report.title;
  document.getElementById('note').textContent = report.note;
}

/// The first answer is the scene as written.
const loadCases = () => report.safety.trouble ? [] : report.safety.slice(1);

const isAsWritten = c => c.set.length === 0;

/// All answers; a load case with `set = []` is the scene as written, which then has no row of its own.
function answeredCases() {
  return loadCases().some(isAsWritten) ? loadCases() : report.safety.trouble ? [] : report.safety;
}

/// Those whose forces differ: of several with `set = []` the first.
const differentCases = () => answeredCases().filter((c, i, all) => !isAsWritten(c) || all.findIndex(isAsWritten) === i);
const fallsShort = c => c.satisfied !== null && !c.satisfied;

/// How many load cases reach their required factor, and which do not; nothing where the scene has none.
function loadCasesInWords() {
  const cases = loadCases();
  const named = list => list.map(c => `"${c.name}"`).join(', ');
  const judged = cases.filter(c => c.required !== null);
  const short = judged.filter(fallsShort);
  const others = cases.filter(c => c.satisfied === null);
  const fallen = others.filter(c => c.outcome === 'fails');
  const unknown = others.filter(c => c.outcome === 'not found');
  const lines = [];
  if (judged.length > 0) {
    lines.push(`Load cases: ${judged.filter(c => c.satisfied).length} of ${judged.length} reach their required factor` + (short.length > 0 ? `; not ${named(short)}.` : '.'));
  }
  if (fallen.length > 0) lines.push(`Load cases without a required factor that fail: ${named(fallen)}.`);
  if (unknown.length > 0) lines.push(`Load cases without an answer: ${named(unknown)}.`);
  return lines;
}

/// Of a load case or the level: what its answer warns of, and what the reading of its scene does.
const warningsOf = answer => [...(answer.scene_warnings || []), ...(answer.warnings || [])];

const placeInText = /\((-?[\d.]+(?:e[-+]?\d+)?), (-?[\d.]+(?:e[-+]?\d+)?)\)/g;

/// A text without its figures, those of names apart: what has the same is one warning.
const withoutFigures = text => text.replace(/"[^"]*"|-?\d[\d.]*(?:e[-+]?\d+)?/g, found => (found[0] === '"' ? found : '#'));

/// Places of texts that are farther apart than a thousandth of the structure.
function placesIn(texts) {
  const places = [];
  for (const text of texts) {
    for (const [, x, y] of text.matchAll(placeInText)) {
      const place = [Number(x), Number(y)];
      if (places.every(p => Math.hypot(p[0] - place[0], p[1] - place[1]) > 1e-3 * report.size_m)) places.push(place);
    }
  }
  return places;
}

/// A figure that texts give differently, from its least to its largest: whichever is worse, it is seen.
function rangeOf(found) {
  const byValue = [...new Set(found)].sort((a, b) => Number(a) - Number(b));
  return byValue.length > 1 ? `${byValue[0]} to ${byValue[byValue.length - 1]}` : byValue[0];
}

/// Texts that differ in figures alone, as one: the first, with the ranges of figures, and at how many more points it holds.
function merged(texts) {
  const parts = /\((?:-?[\d.]+(?:e[-+]?\d+)?), (?:-?[\d.]+(?:e[-+]?\d+)?)\)|"[^"]*"|-?\d+(?:\.\d+)?(?:e[-+]?\d+)?/g;
  const figures = texts.map(text => text.match(parts) || []);
  let i = -1;
  const text = texts[0].replace(parts, part => (++i, '("'.includes(part[0]) ? part : rangeOf(figures.map(of => of[i]))));
  const more = placesIn(texts).length - placesIn(texts.slice(0, 1)).length;
  return text + (more > 0 ? ` (and at ${more} more point${more > 1 ? 's' : ''})` : '');
}

/// Every text once, with those that it holds for: [who, texts] each.
function onceEach(answers) {
  const alike = new Map();
  for (const [who, texts] of answers) {
    for (const text of texts) {
      const key = withoutFigures(text);
      const found = alike.get(key) || {who: new Set(), texts: []};
      found.who.add(who);
      if (!found.texts.includes(text)) found.texts.push(text);
      alike.set(key, found);
    }
  }
  return [...alike.values()].map(({who, texts}) => [[...who], merged(texts)]);
}

/// Of the load cases: each text with the cases that it holds for.
function ofCases(textsOf) {
  const cases = answeredCases();
  return onceEach(cases.map(c => [c.name, textsOf(c)])).map(([names, text]) =>
    [names.length === cases.length && names.length > 1 ? 'all load cases' : `load case${names.length > 1 ? 's' : ''} ${names.map(n => `"${n}"`).join(', ')}`, text]);
}

/// Every warning once, with whom it holds for: the run, load cases, the level.
function allWarnings() {
  const cases = answeredCases();
  const answers = [['run', report.summary.warnings || []], ...cases.map(c => [`load case "${c.name}"`, warningsOf(c)]),
    ['level of failure', report.level.trouble ? [] : warningsOf(report.level)]];
  const named = who => {
    const ofCases = who.filter(w => w.startsWith('load case '));
    const together = ofCases.length === cases.length && cases.length > 1 ? ['all load cases'] : ofCases;
    return [...who.filter(w => !w.startsWith('load case ')), ...together].join(', ');
  };
  return onceEach(answers).map(([who, text]) => (who.length === 1 && who[0] === 'run' ? 'Warning: ' : `Warning, ${named(who)}: `) + text);
}

/// Chapter 1 has the text of each.
const warningsAbove = count => (count > 0 ? [paragraph(`${count} warning${count > 1 ? 's' : ''} of this chapter: see chapter 1.`, 'bad')] : []);

/// What governs comes first: a joint that bends has no sliding factor, and limit analysis finds that it is the weakest.
function marginsInWords({margin, limit_analysis: limit}) {
  const lines = [margin && margin.text ? margin.text + '.' : '', limit ? 'Factor by limit analysis: ' + limit.text + '.' : ''].filter(Boolean);
  const governs = limit && is(limit.factor) && margin && is(margin.sliding_factor) && limit.factor < 0.99 * margin.sliding_factor;
  return governs ? [lines[1], 'Of joints that run straight through the structure: ' + lines[0]] : lines;
}

/// What the page has no answer on.
function missingInWords() {
  const missing = [[report.safety, 'factors of safety'], [report.level, 'the level of failure'], [report.reliability, 'the reliability']]
    .filter(([found]) => found && found.trouble);
  return missing.map(([{trouble}, what]) => `No answer on ${what}: ${trouble}.`);
}

function writeVerdict() {
  const s = report.summary;
  const words = {fails: 'The structure FAILS', stands: 'The structure STANDS', moving: 'UNDECIDED: something still moves at the end', stopped: 'STOPPED'};
  const short = s.outcome === 'stands' ? loadCases().filter(fallsShort).length : 0;
  const fallen = s.outcome === 'stands' ? loadCases().filter(c => c.outcome === 'fails').length : 0;
  chapter('verdict').append(element('p', {class: `outcome ${fallen > 0 ? 'fails' : short > 0 ? 'short' : s.outcome}`}, (words[s.outcome] || s.outcome) +
    (fallen > 0 ? `, but fails in ${fallen} of its load cases` : short > 0 ? `, but ${short} of its load cases ${short > 1 ? 'do' : 'does'} not reach the required factor` : '')));
  const lines = [];
  if (s.outcome === 'fails') {
    const f = s.failure;
    lines.push(f.text + '.');
    if (is(f.level_m)) {
      lines.push(`It begins at a level of ${f.level_is_bound ? (f.level_falls ? 'at least ' : 'at most ') : ''}${number(f.level_m, 6)} m${f.level_falls ? ` of the ${f.pool} pool, which falls` : f.pool === 'downstream' ? ' of the downstream pool' : ''}` + (is(f.head_m) ? (f.head_m < 0 ? `, ${number(-f.head_m, 6)} m below the joint that ${f.turns_on ? 'opens' : 'failed'}` : `, a head of ${number(f.head_m, 6)} m above the joint that ${f.turns_on ? 'opens' : 'failed'}`) : '') +
        `, after ${number(f.time_s)} s` + (is(f.level_uncertainty_m) && !f.level_is_constant ? `. The speed of filling moves this level by some ${number(f.level_uncertainty_m, 2)} m.` : '.'));
    } else lines.push(`It begins after ${number(f.time_s)} s.`);
    lines.push(...[f.doubt, f.end].filter(Boolean));
  }
  if (s.moving) lines.push(s.moving.text);
  lines.push(...lowestFactorsInWords(), ...marginsInWords(s));
  if (s.stopped) lines.push(`After ${number(report.frames[report.frames.length - 1].t)} of ${number(report.duration_s)} s it was stopped: ${s.stopped.replace(/\.$/, '')}.`);
  if (s.loose) lines.push(s.loose.text + '.');
  if (s.breach) lines.push(`After ${number(s.breach.time_s)} s: ${s.breach.text}.`);
  if (s.rest) lines.push(s.rest.text + '.');
  lines.push(...loadCasesInWords(), ...reliabilityInWords(report.reliability));
  for (const line of lines) chapter('verdict').append(paragraph(line.charAt(0).toUpperCase() + line.slice(1)));
  for (const missing of missingInWords()) chapter('verdict').append(paragraph(missing, 'bad'));
  for (const warning of allWarnings()) chapter('verdict').append(paragraph(warning, 'bad'));
}

function writeSection() {
  chapter('section').append(sectionFigure(report),
    ...(report.bolts.length > 0 ? [element('h3', {}, 'Anchors and bolts'), boltTable(report, differentCases())] : []),
    element('h3', {}, 'Materials'),
    table(['material', 'density kg/m3', 'modulus GPa', "Poisson's ratio"], report.materials.map(m => [m.name, number(m.density), number(m.modulus / 1e9), number(m.poisson)])),
    element('h3', {}, 'Joints'),
    table(['joint', 'friction deg', 'residual deg', 'cohesion kPa', 'tension kPa', 'bonded m', 'water in it'], report.laws.map(l => [l.name, number(l.friction), number(l.residual), kilo(l.cohesion, 0), kilo(l.tension, 0), is(l.bonded) ? number(l.bonded) : l.bonded, l.uplift])),
    ...(report.drainage.length > 0 ? [element('h3', {}, 'Drains and grout'), table(['', ''], report.drainage)] : []));
}

/// Water in the joints: what flows, and the uplift beside that of the guideline laws.
function writeFlow() {
  const flow = report.flow;
  if (!flow) return;
  const largest = Math.max(...flow.joints.map(j => Math.abs(j.flow_m2_per_s)));
  const still = j => Math.abs(j.flow_m2_per_s) < 1e-9 * largest;  // round-off
  const perDay = q => number(86400 * q, 4);
  chapter('section').append(element('h3', {}, `Water that flows through the joints ${is(report.failure_s) ? 'before failure' : 'at the end of the run'}, at ${number(flow.time_s)} s`),
    table(['joint', 'length m', 'flow m3/day', 'Reynolds number', 'uplift kN/m', 'triangular', 'drained', 'full'],
      flow.joints.map(j => [j.name, fixed(j.length_m, 3), still(j) ? '0' : perDay(j.flow_m2_per_s), still(j) ? '0' : number(j.reynolds_number, 3), kilo(j.uplift_n_per_m), kilo(j.triangular_n_per_m), kilo(j.drained_n_per_m), kilo(j.full_n_per_m)])),
    paragraph('The joints are as open as they were then; load cases take them as drawn, at their own levels. Flow and forces are per metre of dam. Beside the uplift by flow stands that of the guideline laws under the pools of that time: linear between the ends, with the drain that crosses the joint, and the higher pressure all along. The cubic law ends at a Reynolds number of about 1000.' +
      (flow.left_out > 0 ? ` Left out are ${flow.left_out} joints of less uplift; joint_uplift.csv has all.` : ''), 'quiet'),
    table(['water', 'm3/day'], flow.flows.map(f => [f.name, perDay(f.m2_per_s)])));
}

function differenceOf(difference) {
  const known = is(difference.level_m);
  if (difference.agree) {
    return paragraph('Blocks and limit analysis agree' + (known ? ` to ${number(Math.abs(difference.level_m), 3)} m: the rest is ${difference.reason}.` : '.'));
  }
  return paragraph('Blocks and limit analysis differ' + (known ? ` by ${number(difference.level_m, 3)} m` : '') + `. Reason: ${difference.reason}.`);
}

function writeLevel() {
  const to = chapter('level');
  const found = report.level;
  if (found.trouble) return to.append(paragraph('No level was found: ' + found.trouble));
  const row = (name, f) => {
    const level = f.outcome === 'stands' ? `stands up to ${number(f.highest_level_m, 6)}` : f.outcome === 'does not stand empty' ? 'does not stand empty' : fixed(f.level_m, 4);
    return [name, level, fixed(f.head_m, 4), f.mode || (f.mechanism ? f.mechanism.mode : '-'), f.joint || (f.mechanism ? f.mechanism.joints.join(', ') : '-')];
  };
  const rows = [row('statics of the blocks' + (found.slow_rise ? ', all loads at once' : ''), found)];
  if (found.slow_rise) rows.push(row('the same, under a level that rises slowly', found.slow_rise));
  if (found.rigid_blocks) rows.push(row('the same, blocks that do not strain', found.rigid_blocks));
  rows.push(row('limit analysis', found.limit_analysis));
  if (found.formula) rows.push([`formula ${found.formula.name}`, fixed(found.formula.level_m, 4), fixed(found.formula.head_m, 4), '-', found.formula.joint]);
  to.append(table(['found by', 'level m', 'head m', 'mode', 'joint'], rows),
    differenceOf(found.difference));
  const short = (way, f) => [f.outcome === 'not found' ? `${way}: no answer, ${f.reason}.` : '', f.stopped ? `${way}: known to ${number(f.level_width_m, 2)} m, ${f.stopped}.` : ''].filter(Boolean);
  for (const text of [...short('Statics of the blocks', found), ...(found.rigid_blocks ? short('Blocks that do not strain', found.rigid_blocks) : []), ...short('Limit analysis', found.limit_analysis)]) to.append(paragraph(text, 'bad'));
  if (found.looked_at) to.append(paragraph(`Levels are ${found.looked_at}.`, 'quiet'));
  if (found.assumed) to.append(paragraph(`Water: ${found.assumed}.`, 'quiet'));
  to.append(...warningsAbove(onceEach([['', warningsOf(found)]]).length));
  if (found.limit_analysis.limit_analysis_note) to.append(paragraph(`Limit analysis: ${found.limit_analysis.limit_analysis_note}.`, 'quiet'));
  const mechanism = found.limit_analysis.mechanism;
  if (mechanism) to.append(mechanismFigure(report, mechanism, found.limit_analysis.level_m));
}

function writeHistories() {
  const clock = new Clock(report.frames[0].t, report.frames[report.frames.length - 1].t, report.failure_s);
  const animation = new Animation(report, clock);
  const to = chapter('histories');
  to.append(animation.figure);
  if (report.failure_s !== null) to.append(snapshotFigures(report));  // what stands looks alike at all moments
  to.append(
    paragraph('Drag over a chart to zoom, double click to see all, click to go to a moment. Dashed red: the failure begins.', 'quiet screen'));
  for (const group of report.histories.groups) {
    const chart = new Chart(group, report.histories.time, clock);
    clock.charts.push(chart);
    to.append(chart.figure);
    chart.draw();
  }
  if (report.histories.left_out) to.append(paragraph(report.histories.left_out, 'quiet'));
  clock.go(report.failure_s === null ? clock.begin : report.failure_s);
}

function writeFormulas() {
  const checks = report.summary.checks || [];
  const to = chapter('formulas');
  if (checks.length === 0) return to.append(paragraph('The scene states no figure to compare with ([[expect]]).'));
  const shown = value => (typeof value === 'string' ? value : number(value, 7));
  to.append(table(['figure', 'expected', 'obtained', 'relative error', 'tolerance', 'within', 'formula, source'],
    checks.map(c => [c.name, shown(c.expected), c.why_none || c.trouble || shown(c.got), is(c.relative_error) ? c.relative_error.toExponential(1) : '-', number(c.tolerance), element('span', {class: c.passed ? 'good' : 'bad'}, c.passed ? 'yes' : 'NO'), [c.formula, c.source].filter(Boolean).join('; ')])));
}

function writeAgain() {
  chapter('again').append(
    table(['', ''], [['program', report.program.split('\n')[0]], ...report.program.split('\n').slice(1).map(line => [line.slice(0, 10).trim(), line.slice(10)]), ['digest of the scene', report.digest], ['wall time', number(report.summary.wall_time_s, 3) + ' s']]),
    paragraph('Save the scene below as a file. These commands give the figures of this report again:'),
    ...(report.home ? [paragraph(`Save it in ${report.home}, in which the command of [fluid.external] starts; or run the copy in the run's folder, which knows that.`)] : []),
    element('pre', {}, report.commands.join('\n')), element('h3', {}, 'The scene as it was run'), element('pre', {}, report.scene));
  const skips = (report.summary.skips || []).length;
  if (skips > 0) chapter('again').append(paragraph(`${skips} kinds of work were skipped on which the result does not depend; "blockweir profile" lists them.`, 'quiet'));
}

function writeReliability() {
  if (report.reliability === null) return chapter('reliability').remove();
  showReliability(chapter('reliability'), report.reliability);
}

const numberChapters = () => document.querySelectorAll('section > h2').forEach((h, i) => h.prepend(`${i + 1} `));

for (const write of [writeHead, writeVerdict, writeSection, writeFlow, writeCases, writeLevel, writeReliability, writeHistories, writeFormulas, writeAgain, numberChapters]) write();
