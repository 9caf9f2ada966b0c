// Chapter 3 of the report: load cases and their factors, loads, and tables of joints.
/// A coordinate to what a drawing shows: a thousandth of the structure, or finer.
function drawn(metres) {
  const step = Math.pow(10, Math.floor(Math.log10(1e-3 * report.size_m)));
  return number(Math.round(metres / step) * step + 0, 6);
}

/// Joints of one name, as those of a set, with their elevations.
function withElevations(joints) {
  const elevations = j => [...new Set([j.upstream_end_m, j.downstream_end_m].filter(Boolean).map(p => p[1]).sort((a, b) => a - b).map(drawn))].join(' to ');
  return joints.map(j => (joints.filter(other => other.name === j.name).length > 1 ? {...j, name: `${j.name}, ${elevations(j)} m`} : j));
}

const atLevel = level => (is(level) ? ` at a level of ${number(level)} m` : '');
const whatOf = c => (c.name === 'scene as written' ? 'the scene as written' : `load case "${c.name}"`) + atLevel(c.level_m);

/// All factors on strength that this report has: [factor, of what, by which way] each.
function strengthFactors() {
  const factors = [];
  for (const c of answeredCases()) {
    const add = (factor, way) => factors.push([factor, whatOf(c), way]);
    add(c.factor, 'the statics of the blocks');
    add(c.limit_analysis_factor, 'limit analysis');
    for (const [key, way] of [['with_crushed_corners', 'limit analysis with corners that are crushed'], ['with_cracked_joint', 'limit analysis with cohesion on what is not in tension alone'],
      ['with_rigid_blocks', 'the statics of the blocks without strain'],
      ['with_straining_blocks', 'the statics of the blocks with strain'],
      ['with_blocks_reordered', 'the statics of the blocks listed in another order']]) if (c[key]) add(c[key].factor, way);
    for (const j of withElevations(c.joints || [])) add(j.sliding_factor, `the forces in joint "${j.name}"`);
  }
  const {margin} = report.summary;
  if (margin) factors.push([margin.sliding_factor, `the run after ${number(margin.time_s)} s${atLevel(margin.level_m)}`, `the forces in joint "${margin.joint}"`]);
  return factors;
}

/// Of what fails no factor above 1 on the water is told: it would read as if it stood.
function waterFactors() {
  return answeredCases().filter(c => c.water_factor && !(c.outcome === 'fails' && c.water_factor.factor >= 1))
    .map(c => [c.water_factor.factor, whatOf(c), 'limit analysis' + ('with_anchors_at_yield' in c.water_factor ? ' with anchors at their prestress' : '')]);
}

/// Of factors that agree the first is named.
function lowestInWords(name, all) {
  const factors = all.filter(([factor]) => is(factor));
  const least = Math.min(...factors.map(([factor]) => factor));
  return factors.filter(([factor]) => factor <= least * (1 + 1e-3)).slice(0, 1).map(([factor, what, way]) => `${name} is ${number(factor, 4)}: of ${what}, by ${way}.`);
}

function lowestFactorsInWords() {
  if (answeredCases().length === 0) return [];
  return [...lowestInWords('The lowest factor of safety of this report, on strength,', strengthFactors()), ...lowestInWords('The lowest factor on the water', waterFactors())];
}

/// What acts on all that stands on a joint, and the sum, which the joint bears.
function sumsTable(joint) {
  const row = (name, s) => [name, kilo(s('x_n_per_m')), kilo(s('y_n_per_m')), kilo(s('moment_n'))];
  const sum = key => joint.sums.reduce((total, s) => total + s[key], 0);
  return [table([`on ${joint.name}`, 'x kN/m', 'y kN/m', 'moment kNm/m'], [...joint.sums.map(s => row(s.name, key => s[key])), row('sum', sum)]),
    paragraph(`Moments about (${drawn(joint.downstream_end_m[0])}, ${drawn(joint.downstream_end_m[1])}) m, counter-clockwise positive.`, 'quiet')];
}

/// What acts on a structure that nothing holds, joint by joint.
function writeLoads(c, to) {
  to.append(element('h3', {}, `Loads on joints: ${c.name}`), paragraph(`No table of joints nor of anchors: ${c.why_no_joints}.`, 'quiet'));
  if (c.mechanism) to.append(mechanismFigure(report, c.mechanism, c.level_m));
  for (const joint of withElevations(c.loads_on_joints)) to.append(...sumsTable(joint));
}

/// Joints of the mechanism that part blocks only with others.
function writeParts(c, to) {
  const parts = c.joint_parts || [];
  if (parts.length === 0) return;
  to.append(paragraph(`Parts of a surface, ${c.name}: joints of the mechanism that part blocks only with others, and so have no factor of their own; strength is c L + N tan φ.`, 'quiet'),
    table(['joint', 'length m', 'N kN/m', 'T kN/m', 'U kN/m', 'strength kN/m'],
      parts.map(j => [j.name, fixed(j.length_m, 3), kilo(j.normal_n_per_m), kilo(j.shear_n_per_m), kilo(j.uplift_n_per_m), kilo(j.strength_n_per_m)])));
}

/// Silt, ice and earthquake of each load case, where any has some: columns that no case has are left out.
function writeOtherLoads(to) {
  const columns = [['silt up to m', 'silt.level_m', 1], ['submerged kg/m3', 'silt.submerged_density_kg_per_m3', 1], ['K', 'silt.pressure_coefficient', 1],
    ['ice thrust kN/m', 'ice.thrust_n_per_m', 1e-3], ['ice m', 'ice.thickness_m', 1], ['k_h', 'earthquake.horizontal_coefficient', 1], ['k_v', 'earthquake.vertical_coefficient', 1]]
    .filter(([, key]) => differentCases().some(c => is(c.silt_ice_and_earthquake[key])));
  if (columns.length === 0) return;
  to.append(element('h3', {}, 'Silt, ice and earthquake'),
    table(['load case', ...columns.map(([name]) => name)], differentCases().map(c => [c.name, ...columns.map(([, key, scale]) => number(c.silt_ice_and_earthquake[key] * scale))])));
}

const isLevel = joint => Math.abs(joint.upstream_end_m[1] - joint.downstream_end_m[1]) < 0.02 * joint.length_m;
const inMiddleThird = joint => is(joint.resultant_from_downstream) && Math.abs(joint.resultant_from_downstream - 0.5) <= 1 / 6;

/// Whether the resultant lies in the middle third of each level joint: then nothing is in tension by the gravity method.
function middleThird(joints) {
  const level = joints.filter(isLevel);
  if (level.length === 0) return [];
  const outside = level.filter(j => !inMiddleThird(j));
  const where = j => `"${j.name}"` + (is(j.resultant_from_downstream) ? ` (${j.resultant_from_downstream > 0.5 ? 'upstream' : 'downstream'} of it)` : ' (not pressed)');
  if (outside.length === 0) return [paragraph(level.length > 1 ? `The resultant lies in the middle third of each of the ${level.length} level joints.` : `The resultant lies in the middle third of the level joint "${level[0].name}".`)];
  return [paragraph(`The resultant lies outside the middle third of ${outside.length} of ${level.length} level joint${level.length > 1 ? 's' : ''}: ${outside.map(where).join(', ')}.`)];
}

/// The factor on the water that decides, and the one of anchors that have stretched.
function onWater({water_factor: found}) {
  if (!found) return '-';
  return number(found.factor) + (is(found.with_anchors_at_yield) ? ` (anchors at yield: ${number(found.with_anchors_at_yield)})` : '');
}

function writeCases() {
  const to = chapter('cases');
  if (report.safety.trouble) return to.append(paragraph('No factor was found: ' + report.safety.trouble));
  // Of a case that is not satisfied, the warning is pointed at only where it is why.
  const cause = c => (c.satisfied === false && c.with_cracked_joint ? c.with_cracked_joint.text : '');
  const doubt = c => (cause(c) ? ', see below' : c.satisfied && warningsOf(c).length > 0 ? ', see chapter 1' : '');
  const answer = c => (c.satisfied === null ? '-' : element('span', {class: c.satisfied && !doubt(c) ? 'good' : 'bad'}, (c.satisfied ? 'yes' : 'NO') + doubt(c)));
  to.append(table(['load case', 'class', 'level m', 'tailwater m', 'outcome', 'factor', 'by limit analysis', 'on the water', 'required', 'satisfied', 'source'],
    answeredCases().map(c => [c.name, c.class || '-', number(c.level_m), number(c.tailwater_m), c.outcome, number(c.factor), number(c.limit_analysis_factor), onWater(c), number(c.required, 4), answer(c), c.source || '-'])),
  paragraph('The factor divides cohesion and tan(phi) of all joints until the structure just stands. It is found by the statics of the blocks and, as an upper bound, by limit analysis. On the water: all that it presses may grow by so much, its uplift included, by limit analysis, with anchors at their prestress where that is less.', 'quiet'));
  const tellEach = (textsOf, words, kind) => ofCases(textsOf).forEach(told => to.append(paragraph(words(...told), kind)));
  const upper = text => text.charAt(0).toUpperCase() + text.slice(1);
  tellEach(c => (cause(c) ? [cause(c)] : []), (who, text) => `Not enough, ${who}: ${text}.`, 'bad');
  to.append(...warningsAbove(ofCases(warningsOf).length));
  tellEach(c => (c.friction_history ? [c.friction_history] : []), (who, text) => `${upper(who)}: ${text}.`, 'quiet');
  tellEach(c => (c.limit_analysis_note ? [c.limit_analysis_note] : []), (who, text) => `${upper(who)}, limit analysis: ${text}.`, 'quiet');
  tellEach(c => (!is(c.factor) && c.why_no_factor ? [c.why_no_factor] : []), (who, text) => `${upper(who)}: no factor, as ${text}.`, 'quiet');
  tellEach(c => (c.why_no_limit_analysis_factor && c.why_no_limit_analysis_factor !== c.why_no_factor ? [c.why_no_limit_analysis_factor] : []), (who, text) => `${upper(who)}: no factor by limit analysis, as ${text}.`, 'quiet');
  // Where no strength suffices, the mechanism is not that with which a factor was found.
  const ofPower = c => (c.why_no_joints ? '. As no strength holds it, this is the mechanism with the largest power for the sum of its velocities; the factor on the water is that of the mechanism that bears least, which may be another' : '');
  tellEach(c => (c.mechanism ? [c.mechanism.text + ofPower(c)] : []), (who, text) => `Mechanism of ${who}, by limit analysis: ${text}.`, 'quiet');
  const listed = names => [names.slice(0, -1).join(', '), ...names.slice(-1)].filter(Boolean).join(' and ');
  const grownLoads = ({factor, loads, constant}) => is(factor) ? `bears ${number(factor)} times ${listed(loads)}, with ${listed(constant)} as stated`
    : `does not stand under ${listed(constant)} alone, even without ${listed(loads)}`;
  tellEach(c => (c.load_factor ? [grownLoads(c.load_factor)] : []), (who, text) => `By limit analysis, in ${who} the structure ${text}.`, 'quiet');
  writeOtherLoads(to);
  to.append(caseFigures(report, differentCases()));
  for (const c of differentCases()) {
    if (c.why_no_joints) writeLoads(c, to);
    if (!c.joints || c.joints.length === 0) {
      writeParts(c, to);
      continue;
    }
    const joints = withElevations(c.joints);
    const scaled = c.joints_with_strength_times;
    const together = element('div', {class: 'together'});
    to.append(together);
    together.append(element('h3', {}, `Joints: ${c.name}` + (is(c.level_m) ? `, level ${number(c.level_m)} m` : '')));
    if (c.set.length > 0) together.append(paragraph('It sets ' + c.set.join(', ') + '.', 'quiet'));
    if (is(scaled)) together.append(paragraph(`It does not stand: forces are those with ${number(scaled, 4)} times the strength; the sliding factors are with the strength as stated.`, 'quiet'));
    together.append(table(['joint', 'length m', 'N kN/m', 'T kN/m', 'U kN/m', 'M kNm/m', 'sliding factor', 'residual', 'resultant', 'crack m', 'bonded m', 'heel kPa', 'toe kPa'],
      joints.map(j => [j.name, fixed(j.length_m, 3), kilo(j.normal_n_per_m), kilo(j.shear_n_per_m), kilo(j.uplift_n_per_m), kilo(j.moment_n), number(j.sliding_factor, 4), number(j.residual_sliding_factor, 4), fixed(j.resultant_from_downstream, 4), fixed(j.cracked_length_m, 3), fixed(j.bonded_length_m, 3), kilo(j.heel_stress_pa), kilo(j.toe_stress_pa)])));
    together.append(...middleThird(joints));
    const bent = c.bent_joints || [];
    if (bent.length > 0) to.append(paragraph(`No row has ${bent.map(name => `"${name}"`).join(', ')}: a joint that bends has no single sliding factor nor resultant. The factor of the load case counts it.`, 'quiet'));
    writeParts(c, to);
    if (joints.length <= 4) joints.forEach(joint => to.append(...sumsTable(joint)));  // of a mesh of joints the file has the rest
  }
}
