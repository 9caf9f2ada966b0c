// How likely the structure fails where numbers are uncertain: what blockweir reliability has found.

const wayOf = by => ({limit: 'limit analysis', statics: 'statics of the blocks', run: 'whole runs'}[by]);
const asProbability = value => (!is(value) ? '-' : value === 0 ? '0' : value < 1e-3 ? value.toExponential(2) : number(value, 4));
const between = (from, to) => `${asProbability(from)} to ${asProbability(to)}`;

/// For the verdict: one line, or none.
function reliabilityInWords(found) {
  if (found === null || found.trouble) return [];
  const samples = found.samples;
  return [`Probability of failure at a level of ${number(found.level_m, 6)} m: ${asProbability(samples.probability)}, with 95 % confidence ${between(...samples.interval)}, by ${samples.count} samples.`];
}

/// Rows: method, P, its interval, index, how many levels of failure it took.
function methodRows(found) {
  const samples = found.samples;
  const rows = [[`samples, ${found.sampling}`, asProbability(samples.probability), between(...samples.interval), number(samples.index, 4), samples.count]];
  const point = (name, answer) => rows.push([name, asProbability(answer.probability), '-', number(answer.index, 4), '-']);
  if (found.form && !found.form.trouble) point('FORM', found.form);
  if (found.sorm && !found.sorm.trouble) point('SORM (Breitung)', found.sorm.breitung);
  for (const [key, name] of [['importance', 'importance sampling'], ['subset', 'subset sampling']]) {
    const answer = found[key];
    if (answer && !answer.trouble) rows.push([name, asProbability(answer.probability), between(...answer.interval), '-', answer.evaluations]);
  }
  return rows;
}

/// Rows: variable, its distribution, its value at the design point, importance there, Sobol's indices.
function variableRows(found) {
  const form = [found.form, found.sorm].find(f => f && !f.trouble) || {};
  const sobol = found.sobol && !found.sobol.trouble ? found.sobol : {};
  const share = (list, i) => (list ? fixed(list[i], 3) : '-');
  return found.variables.map((name, i) => [name, found.distributions[i], number(found.means[i], 6),
    form.design_point ? number(form.design_point[i], 6) : '-', share(form.importance, i), share(sobol.first, i), share(sobol.total, i)]);
}

/// The fragility curve with its interval; dashed: the level that is asked for.
function fragilityFigure(found) {
  const curve = found.curve;
  const [left, right, top, bottom] = [70, 925, 14, 270];
  let [low, high] = [curve[0].level_m, curve[curve.length - 1].level_m];
  const reach = 10 * (high - low);
  if (found.level_m > low - reach && found.level_m < high + reach) [low, high] = [Math.min(low, found.level_m), Math.max(high, found.level_m)];
  const edge = 0.03 * (high - low) || 0.5;
  [low, high] = [low - edge, high + edge];
  const x = level => left + (level - low) / (high - low) * (right - left);
  const y = p => bottom - p * (bottom - top);
  const at = (point, p) => `${x(point.level_m).toFixed(1)},${y(p).toFixed(1)}`;
  const parts = [element('rect', {x: left, y: top, width: right - left, height: bottom - top, fill: 'white', stroke: '#9aa3ad'})];
  for (const p of [0, 0.2, 0.4, 0.6, 0.8, 1]) {
    parts.push(element('line', {x1: left, x2: right, y1: y(p), y2: y(p), stroke: '#e3e7ec'}), element('text', {x: left - 6, y: y(p) + 4, 'text-anchor': 'end'}, p.toFixed(1)));
  }
  for (const level of ticks(low, high, 10)) {
    parts.push(element('line', {x1: x(level), x2: x(level), y1: top, y2: bottom, stroke: '#e3e7ec'}), element('text', {x: x(level), y: bottom + 16, 'text-anchor': 'middle'}, number(level)));
  }
  parts.push(element('polygon', {points: [...curve.map(c => at(c, c.from)), ...[...curve].reverse().map(c => at(c, c.to))].join(' '), fill: '#b8cce4'}),
    element('polyline', {points: curve.map(c => at(c, c.probability)).join(' '), fill: 'none', stroke: '#204a87', 'stroke-width': 2}),
    element('text', {x: right, y: bottom + 32, 'text-anchor': 'end'}, 'level of the reservoir (m)'), element('text', {x: left + 6, y: top + 14}, 'probability of failure'));
  const shown = found.level_m >= low && found.level_m <= high;
  if (shown) {
    parts.push(element('line', {x1: x(found.level_m), x2: x(found.level_m), y1: top, y2: bottom, stroke: 'var(--bad)', 'stroke-dasharray': '5 4'}));
  }
  return element('figure', {class: 'fragility'}, element('svg', {viewBox: '0 0 940 306'}, ...parts),
    element('figcaption', {}, 'Fragility curve, with the interval that holds it in 95 of 100 ensembles.' + (shown ? ' Dashed red: the level that is asked for.' : '')));
}

function comparisonTable(found) {
  const ways = Object.keys(found.comparison[0]).filter(key => key !== 'where');
  const shown = f => (is(f.level_m) ? fixed(f.level_m, 4) : f.trouble || f.outcome);
  return table(['level of failure m', ...ways.map(wayOf)], found.comparison.map(row => [row.where, ...ways.map(way => shown(row[way]))]));
}

/// Where some samples have no level, or one above all that are looked at, it is said of which the mean is.
function showLevels(to, found) {
  const [fit, samples] = [found.fit, found.samples];
  const whose = is(fit.samples) && fit.samples < samples.count ? ` of the ${fit.samples} of ${samples.count} samples that ${"cut_off_m" in fit ? "fail below the highest level" : "have one"}` : '';
  const shape = fit.commonest ? `${fit.commonest.samples} of them are ${number(fit.commonest.level_m, 6)} m, so that no common distribution fits them` :
    `of common distributions the ${fit.distribution.toLowerCase()} one fits them best`;
  to.append(paragraph(`Levels of failure${whose}: mean ${number(fit.mean)} m, deviation ${number(fit.deviation, 3)} m; ${shape}.`));
  if (!('cut_off_m' in fit)) return;
  const where = is(fit.cut_off_m) ? ` at ${number(fit.cut_off_m, 6)} m, the highest level that is looked at` : ' at the end of the filling';
  to.append(paragraph(`They are cut off${where}: ${samples.that_stand} samples stand there. With them the mean is higher, and the deviation another.`, 'bad'));
}

function showReliability(to, found) {
  if (found.trouble) return to.append(paragraph('It was not found: ' + found.trouble + '.'));
  const samples = found.samples;
  to.append(paragraph(`Probability of failure at a level of ${number(found.level_m, 6)} m or below. The level at which each sample fails is found by ${wayOf(found.by)}.`),
    table(['method', 'probability', '95 % interval', 'reliability index', 'levels computed'], methodRows(found)));
  if (found.contradiction) to.append(paragraph(`The methods contradict each other: ${found.contradiction}.`, 'bad'));
  if (samples.without_answer > 0) to.append(paragraph(`${samples.without_answer} samples have no answer, which widens the interval: as if all of them failed, or none.`, 'bad'));
  if (found.upper_bound) to.append(paragraph('Limit analysis is an upper bound here: the true level is this or lower, and the true probability this or higher.', 'bad'));
  if (found.limit_analysis_note) to.append(paragraph(found.limit_analysis_note + '.', 'bad'));
  for (const method of ['form', 'sorm', 'importance', 'subset', 'sobol']) {
    if (found[method] && found[method].trouble) to.append(paragraph(`None by ${method}: ${found[method].trouble}.`, 'bad'));
  }
  to.append(element('h3', {}, 'What is uncertain'),
    table(['variable', 'distribution', 'mean', 'at the design point', 'importance there', 'Sobol alone', 'Sobol in all'], variableRows(found)));
  if (found.correlated && found.form && !found.form.trouble) to.append(paragraph("The variables are correlated. Importance is each one's share of the squared distance of the design point, in standard normal variables that are correlated as well. It is not FORM's alpha²."));
  if (found.curve && found.curve.length > 1) to.append(fragilityFigure(found));
  if (found.fit) showLevels(to, found);
  if (found.comparison) to.append(comparisonTable(found));
}
