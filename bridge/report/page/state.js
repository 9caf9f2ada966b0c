// The section with all that acts on it at one moment or in one load case: diagrams, resultants, bolts, levels, a legend.

/// Places for labels within the drawing's frame: none over another, and off the lines where there is room nearby.
class Places {
  constructor(scale) {
    const {view} = scale;
    this.frame = {left: scale.x(view.left) + 2, right: scale.x(view.right) - 2, top: scale.y(view.top) + 2, bottom: scale.y(view.bottom) - 2};
    this.labels = [];
    this.lines = [];
  }
  within(x, y, w, h) {
    const f = this.frame;
    return [Math.max(f.left + w / 2, Math.min(f.right - w / 2, x)), Math.max(f.top + h / 2, Math.min(f.bottom - h / 2, y))];
  }
  keepLineFree(x1, y1, x2, y2) {
    const count = Math.max(1, Math.round(Math.hypot(x2 - x1, y2 - y1) / 8));
    for (let i = 0; i <= count; ++i) this.lines.push([x1 + i / count * (x2 - x1), y1 + i / count * (y2 - y1), 5, 5]);
  }
  /// The place nearest to where it is wanted that none of the boxes covers, at most so far away.
  nearest(boxes, x, y, w, h, far) {
    const step = 5;
    for (let ring = 0; ring * step <= far; ++ring) {
      const directions = ring === 0 ? 1 : Math.max(16, 4 * ring);
      for (let d = 0; d < directions; ++d) {
        const angle = 2 * Math.PI * (d + 0.5) / directions;
        const at = this.within(x + ring * step * Math.cos(angle), y + ring * step * Math.sin(angle), w, h);
        if (boxes.every(t => Math.abs(t[0] - at[0]) >= (t[2] + w) / 2 || Math.abs(t[1] - at[1]) >= (t[3] + h) / 2)) return at;
      }
    }
    return null;
  }
  /// Null where all is full.
  place(x, y, w, h) {
    const f = this.frame;
    if (w > f.right - f.left) return null;
    const at = this.nearest([...this.labels, ...this.lines], x, y, w, h, 8 * h) ||
      this.nearest(this.labels, x, y, w, h, f.right - f.left + f.bottom - f.top);
    if (at) this.labels.push([...at, w, h]);
    return at;
  }
}

/// A drawing whose lines are drawn first and whose labels then find their places.
class Sheet {
  constructor(view, width, textSize) {
    this.scale = new Scale(view, width, 50, textSize);
    this.textSize = textSize;
    this.drawn = drawing(this.scale, true);
    this.places = new Places(this.scale);
    this.labels = [];
    this.homeless = [];
  }
  put(...shapes) { this.drawn.inside.append(...shapes); }
  line(points, attributes) {
    const on = points.map(p => [this.scale.x(p[0]), this.scale.y(p[1])]);
    this.put(element('polyline', {points: this.scale.points(points), fill: 'none', ...attributes}));
    for (let i = 0; i + 1 < on.length; ++i) this.places.keepLineFree(...on[i], ...on[i + 1]);
  }
  arrow([from, to], colour) {
    const [x1, y1, x2, y2] = [this.scale.x(from[0]), this.scale.y(from[1]), this.scale.x(to[0]), this.scale.y(to[1])];
    const length = Math.hypot(x2 - x1, y2 - y1) || 1;
    const [ux, uy] = [(x2 - x1) / length, (y2 - y1) / length];
    this.line([from, to], {stroke: colour, 'stroke-width': 2});
    this.put(element('path', {d: `M${x2} ${y2} L${x2 - 10 * ux - 4 * uy} ${y2 - 10 * uy + 4 * ux} L${x2 - 10 * ux + 4 * uy} ${y2 - 10 * uy - 4 * ux} z`, fill: colour}));
  }
  label(at, text, colour) { this.labels.push([at, text, colour]); }
  /// Labels last, over all lines. One that had to move away has a line to what it names. Those without a place: `homeless`.
  svg() {
    const [names, leaders] = [[], []];
    for (const [at, text, colour] of this.labels) {
      const [wantedX, wantedY] = [this.scale.x(at[0]), this.scale.y(at[1])];
      const [w, h] = [textWidth(text, this.textSize) + 6, 1.3 * this.textSize];
      const place = this.places.place(wantedX, wantedY, w, h);
      if (!place) {
        this.homeless.push({label: text, colour});
        continue;
      }
      const [x, y] = place;
      if (Math.abs(x - wantedX) > w / 2 + h || Math.abs(y - wantedY) > 1.5 * h) leaders.push(element('line', {x1: wantedX, y1: wantedY, x2: x, y2: y, stroke: colour, 'stroke-width': 0.7}));
      names.push(label({x, y: y + 0.33 * this.textSize, 'text-anchor': 'middle'}, colour, text));
    }
    this.put(...leaders, ...names);
    return this.drawn.svg;
  }
}

/// Labels all loads where they are few, or only those whose size the legend does not have.
function drawLoads(state, sheet, whole) {
  const {acting} = state;
  const few = acting.filter(load => load.in_view).length <= 4;  // more labels crowd each other and the joints' names
  for (const load of acting) {
    for (const outline of load.diagrams) sheet.put(element('polygon', {points: sheet.scale.points(outline), fill: load.colour, 'fill-opacity': 0.25, stroke: load.colour, 'stroke-width': 0.8}));
    if (!load.in_view) continue;  // the legend has it
    sheet.arrow(load.arrow, load.colour);
    const alike = acting.filter(other => other.kind === load.kind).length;
    const shown = load.labelled && ((whole && few) || state.legend.every(row => row.label !== load.label));
    if (shown && alike <= 12) sheet.label(load.arrow[0], load.label, load.colour);  // of a mesh of joints the legend must do
  }
}

function drawJoints(joints, sheet, named) {
  for (const joint of joints) {
    for (const line of joint.lines) sheet.line(line, {stroke: 'var(--bad)', 'stroke-width': 1.6, 'stroke-dasharray': '6 3'});
    if (!joint.labelled || !named) continue;
    const [first, last] = [joint.lines[0][0], joint.lines[0][joint.lines[0].length - 1]];
    sheet.label([(first[0] + last[0]) / 2, (first[1] + last[1]) / 2], joint.name, 'var(--bad)');
  }
}

/// A line, and a plate across its head, which is the higher end.
function drawBolts(bolts, size, sheet, whole) {
  for (const bolt of bolts) {
    const [head, foot] = bolt.from[1] >= bolt.to[1] ? [bolt.from, bolt.to] : [bolt.to, bolt.from];
    const length = Math.hypot(foot[0] - head[0], foot[1] - head[1]) || 1;
    const across = [0.02 * size * (head[1] - foot[1]) / length, 0.02 * size * (foot[0] - head[0]) / length];
    sheet.line([head, foot], {stroke: BOLT, 'stroke-width': 3});
    sheet.line([[head[0] - across[0], head[1] - across[1]], [head[0] + across[0], head[1] + across[1]]], {stroke: BOLT, 'stroke-width': 5});
    if (whole) sheet.label([(head[0] + foot[0]) / 2, (head[1] + foot[1]) / 2], bolt.label, BOLT);
  }
}

function drawLevels(state, sheet) {
  const {view} = sheet.scale;
  for (const [level, x] of [[state.upstream, view.left], [state.downstream, view.right]]) {
    if (is(level)) sheet.label([x, level + 0.02 * (view.top - view.bottom)], `${fixed(level, 2)} m`, 'var(--line)');
  }
}

/// Height, crest and base of what can move.
function drawDimensions(report, sheet) {
  const d = report.dimensions;
  if (!d) return;
  const {view} = sheet.scale;
  const span = (a, b, text) => {
    sheet.line([a, b], {stroke: '#444'});
    for (const end of [a, b]) {
      const [x, y] = [sheet.scale.x(end[0]), sheet.scale.y(end[1])];
      sheet.put(element('line', {x1: x - 4, y1: y + 4, x2: x + 4, y2: y - 4, stroke: '#444'}));
    }
    const level = a[1] === b[1] ? sheet.textSize / sheet.scale.factor : 0;  // above its line
    sheet.label([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2 + level], text, 'var(--ink)');
  };
  const beside = d.right + 0.03 * (view.right - view.left);
  const below = view.bottom + 0.03 * (view.top - view.bottom);  // under the uplift
  const above = d.top + 0.02 * (view.top - view.bottom);
  span([beside, d.bottom], [beside, d.top], `${number(d.top - d.bottom)} m`);
  for (const [ends, y] of [[d.base, below], [d.crest, above]]) {
    if (ends && ends[1] - ends[0] > 1e-6 * report.size_m) span([ends[0], y], [ends[1], y], `${number(ends[1] - ends[0])} m`);
  }
}

function legendRows(rows) {
  return element('p', {class: 'legend'}, ...rows.map(row => element('span', {}, element('i', {style: `background: ${row.colour}`}), row.label)));
}

/// The section in a state, its texts `textSize` points high on paper; `whole` with dimensions and the names of joints.
function stateFigure(report, state, width, textSize, whole, caption) {
  const sheet = new Sheet(state.view, width, textSize);
  sheet.put(...state.pools.map(pool => element('polygon', {points: sheet.scale.points(pool), fill: 'var(--pool)'})),
    ...blockShapes(report, {outlines: report.blocks.map(b => b.outline)}, sheet.scale));
  drawLoads(state, sheet, whole);
  drawJoints(report.joints, sheet, whole);
  drawBolts(state.bolts, report.size_m, sheet, whole);
  if (whole) drawDimensions(report, sheet);
  drawLevels(state, sheet);
  const svg = sheet.svg();
  const told = new Set(state.legend.map(row => row.label));
  return element('figure', {class: 'state'}, svg, legendRows([...state.legend, ...sheet.homeless.filter(row => !told.has(row.label))]), element('figcaption', {}, caption));
}

function sectionFigure(report) {
  const highest = Math.max(...report.blocks.flatMap(b => b.outline.map(p => p[1])));
  const over = report.state.upstream > highest + 1e-6 * report.size_m ? ' Water above the highest block would flow over it, and is not drawn.' : '';
  const waves = report.state.waves_left_out ? ' The water is still, at the levels of the scene: waves are left out.' : '';
  const later = is(report.state.fails_later_s) ? `, the last frame before the failure at ${number(report.state.fails_later_s)} s` : '';
  return stateFigure(report, report.state, fittingWidth(report.state.view), 14, true,
    `Blocks as the scene draws them, with what acts at ${number(report.state.time_s)} s${later}. Diagrams stand on the outer side of what they press on, each kind to a scale of its own; an arrow is a resultant. Uplift stands below its joint. Dashed red: joints with a name. Rock far from the structure is cut off.${waves}${over}`);
}

/// A small section for each load case.
function caseFigures(report, cases) {
  return element('div', {class: 'cases'}, ...cases.filter(c => c.section).map(c => stateFigure(report, c.section, 460, 17, false,
    `${c.name}${is(c.factor) ? `: factor ${number(c.factor, 4)}` : ''}${is(c.required) ? `, required ${number(c.required, 4)}` : ''}`)));
}

/// Every bolt with its force in each load case.
function boltTable(report, answers) {
  const end = (p, block) => `(${number(p[0], 4)}, ${number(p[1], 4)}) in ${block || 'the ground'}`;
  const cases = answers.filter(c => c.bolts && c.bolts.length > 0);
  return table(['anchor', 'from (x, elevation) m', 'to (x, elevation) m', 'prestress kN/m', 'yields at kN/m', ...cases.map(c => `force kN/m: ${c.name}`)],
    report.bolts.map((b, i) => [b.name, end(b.from, b.from_block), end(b.to, b.to_block), kilo(b.prestress_n_per_m), is(b.yield_n_per_m) ? kilo(b.yield_n_per_m) : 'never', ...cases.map(c => kilo(c.bolts[i].force_n_per_m))]));
}
