// The section at a moment, drawn to scale: x downstream, elevations upwards, water, blocks, pressures, loads.

/// Metres of the section to the picture's points.
class Scale {
  constructor(view, width, margin) {
    this.view = view;
    this.margin = margin;
    this.factor = (width - 2 * margin) / (view.right - view.left);
    this.width = width;
    this.height = this.factor * (view.top - view.bottom) + 2 * margin;
  }
  x(metres) { return this.margin + (metres - this.view.left) * this.factor; }
  y(metres) { return this.margin + (this.view.top - metres) * this.factor; }
  points(outline) { return outline.map(p => this.x(p[0]).toFixed(1) + ',' + this.y(p[1]).toFixed(1)).join(' '); }
}

/// Width of a drawing that is no higher than wide pages bear: its texts are then as large as in others.
function fittingWidth(view) {
  return Math.min(940, Math.max(420, 92 + 500 * (view.right - view.left) / (view.top - view.bottom)));
}

/// A text that can be read on any ground: white behind itself, as paper has no paint-order.
function label(attributes, colour, text) {
  return element('g', {},
    element('text', {...attributes, style: 'stroke: white; stroke-width: 4px; stroke-linejoin: round'}, text),
    element('text', {...attributes, stroke: 'none', style: `fill: ${colour}`}, text));
}

let clips = 0;

/// An empty drawing with axes, and a group that is cut off at the view's edge.
function drawing(scale, axes) {
  const {view} = scale;
  const id = 'clip' + ++clips;
  const frame = {x: scale.x(view.left), y: scale.y(view.top), width: scale.x(view.right) - scale.x(view.left), height: scale.y(view.bottom) - scale.y(view.top)};
  const inside = element('g', {'clip-path': `url(#${id})`});
  const svg = element('svg', {viewBox: `0 0 ${scale.width} ${scale.height}`, style: `max-width: ${1.3 * scale.width}px`},
    element('defs', {}, element('clipPath', {id}, element('rect', frame))), inside);
  if (axes) {
    svg.append(element('rect', {...frame, fill: 'none', stroke: '#9aa3ad'}));
    for (const x of ticks(view.left, view.right, 9)) {
      svg.append(element('line', {x1: scale.x(x), x2: scale.x(x), y1: scale.y(view.bottom), y2: scale.y(view.bottom) + 5, stroke: '#9aa3ad'}),
        element('text', {x: scale.x(x), y: scale.y(view.bottom) + 18, 'text-anchor': 'middle'}, number(x)));
    }
    for (const y of ticks(view.bottom, view.top, 7)) {
      svg.append(element('line', {x1: scale.x(view.left) - 5, x2: scale.x(view.left), y1: scale.y(y), y2: scale.y(y), stroke: '#9aa3ad'}),
        element('text', {x: scale.x(view.left) - 8, y: scale.y(y) + 4, 'text-anchor': 'end'}, number(y)));
    }
    svg.append(element('text', {x: scale.x((view.left + view.right) / 2), y: scale.height - 4, 'text-anchor': 'middle'}, 'x (m), downstream to the right'),
      element('text', {x: 12, y: scale.y((view.top + view.bottom) / 2), transform: `rotate(-90 12 ${scale.y((view.top + view.bottom) / 2)})`, 'text-anchor': 'middle'}, 'elevation (m)'));
  }
  return {svg, inside};
}

function blockShapes(report, frame, scale) {
  return frame.outlines.map((outline, i) => element('polygon', {points: scale.points(outline),
    fill: report.blocks[i].fixed ? 'var(--ground)' : 'var(--block)', stroke: '#30343a', 'stroke-width': 1}));
}

function waterShapes(frame, scale) {
  return frame.pools.map(pool => element('polygon', {points: scale.points(pool), fill: 'var(--water)'}));
}

function levelShapes(report, frame, scale) {
  const shapes = [];
  const mark = (level, side) => {
    if (!is(level)) return;
    const at = scale.x(side < 0 ? scale.view.left : scale.view.right) - side * 8;
    const anchor = side < 0 ? 'start' : 'end';
    shapes.push(element('path', {d: `M${at - side * 9} ${scale.y(level)} l-5 -9 h10 z`, fill: 'var(--line)'}),
      label({x: at, y: scale.y(level) - 14, 'text-anchor': anchor}, 'var(--line)', `${fixed(level, 2)} m`));
  };
  mark(frame.upstream, -1);
  mark(frame.downstream, 1);
  return shapes;
}

/// The pressure on each wet face as a diagram on the face's outer side, in metres: panels run against the outline, the
/// outside on their right.
function pressureDiagrams(frame, size) {
  const largest = Math.max(0, ...frame.panels.map(p => Math.max(p[4], p[5])));
  if (largest === 0) return {diagrams: [], largest};
  const by = 0.22 * size / largest;
  const diagrams = [];
  for (const [x1, y1, x2, y2, p1, p2, crack] of frame.panels) {
    const length = Math.hypot(x2 - x1, y2 - y1);
    if (length === 0) continue;
    const out = [(y2 - y1) / length, (x1 - x2) / length];
    if (crack && out[1] >= 0) continue;  // uplift stands below its joint, once
    const away = (x, y, p) => [x + out[0] * by * p, y + out[1] * by * p];
    diagrams.push({crack, outline: [[x1, y1], [x2, y2], away(x2, y2, p2), away(x1, y1, p1)]});
  }
  return {diagrams, largest};
}

function pressureShapes(diagrams, scale) {
  return diagrams.map(({crack, outline}) => element('polygon', {points: scale.points(outline),
    fill: crack ? '#00838f' : '#1f6fb4', 'fill-opacity': 0.25, stroke: crack ? '#00838f' : 'var(--line)', 'stroke-width': 0.8}));
}

/// The view, wide enough for what is drawn around the blocks.
function viewWith(view, points, edge) {
  return {left: Math.min(view.left, ...points.map(p => p[0] - edge)), right: Math.max(view.right, ...points.map(p => p[0] + edge)),
    bottom: Math.min(view.bottom, ...points.map(p => p[1] - edge)), top: Math.max(view.top, ...points.map(p => p[1] + edge))};
}

function contactShapes(frame, scale) {
  return frame.contacts.map(([x, y, state]) => element('circle', {cx: scale.x(x), cy: scale.y(y), r: 3.5, fill: state === 2 ? '#d00000' : '#1a7f37'}));
}

function boltShapes(frame, scale) {
  return frame.bolts.map(([x1, y1, x2, y2]) => element('line', {x1: scale.x(x1), y1: scale.y(y1), x2: scale.x(x2), y2: scale.y(y2), stroke: '#b03060', 'stroke-width': 3}));
}

/// An arrow of so many points that ends at the point where the load acts.
function arrow(scale, at, direction, text, reach = 42) {
  const length = Math.hypot(...direction) || 1;
  const [ux, uy] = [direction[0] / length, -direction[1] / length];
  const [x, y] = [scale.x(at[0]), scale.y(at[1])];
  const group = element('g', {stroke: '#7a1fa2', fill: '#7a1fa2'},
    element('line', {x1: x - reach * ux, y1: y - reach * uy, x2: x - 8 * ux, y2: y - 8 * uy, 'stroke-width': 2}),
    element('path', {d: `M${x} ${y} L${x - 10 * ux - 4 * uy} ${y - 10 * uy + 4 * ux} L${x - 10 * ux + 4 * uy} ${y - 10 * uy - 4 * ux} z`}));
  if (text) group.append(element('text', {x: x - 46 * ux, y: y - 46 * uy - 3, 'text-anchor': ux > 0 ? 'end' : 'start', stroke: 'none', style: 'fill: #7a1fa2'}, text));
  return group;
}

/// A joint's line and its name, beside the downstream end.
function jointShapes(report, scale) {
  const shapes = [];
  const taken = [];
  for (const joint of report.joints) {
    for (const line of joint.lines) shapes.push(element('polyline', {points: scale.points(line), fill: 'none', stroke: '#b3261e', 'stroke-width': 1.6, 'stroke-dasharray': '6 3'}));
    if (!joint.labelled) continue;
    const line = joint.lines[0];
    const middle = [(line[0][0] + line[line.length - 1][0]) / 2, (line[0][1] + line[line.length - 1][1]) / 2];
    const x = scale.x(middle[0]);
    const half = 4.2 * joint.name.length;  // of the name's width on paper, where texts are largest
    const free = y => taken.every(t => Math.abs(t.x - x) >= t.half + half || Math.abs(t.y - y) >= 18);
    const own = scale.y(middle[1]) - 6;
    let away = 0;
    while (!free(own - away) && !free(own + away)) away += 2;
    const y = free(own - away) ? own - away : own + away;
    taken.push({x, y, half});
    shapes.push(label({x, y, 'text-anchor': 'middle'}, 'var(--bad)', joint.name));
  }
  return shapes;
}

/// Height, crest and base of what can move.
function dimensionShapes(report, scale) {
  const d = report.dimensions;
  if (!d) return [];
  const span = (a, b, text, across) => {
    const [x1, y1, x2, y2] = [scale.x(a[0]), scale.y(a[1]), scale.x(b[0]), scale.y(b[1])];
    const tick = [[x1 - 4, y1 + 4, x1 + 4, y1 - 4], [x2 - 4, y2 + 4, x2 + 4, y2 - 4]];
    return element('g', {stroke: '#444'}, element('line', {x1, y1, x2, y2}),
      ...tick.map(t => element('line', {x1: t[0], y1: t[1], x2: t[2], y2: t[3]})),
      label({x: (x1 + x2) / 2 + (across ? 0 : 6), y: (y1 + y2) / 2 - (across ? 5 : 0), 'text-anchor': across ? 'middle' : 'start'}, 'var(--ink)', text));
  };
  const beside = d.right + 0.03 * (scale.view.right - scale.view.left);
  const below = scale.view.bottom + 0.03 * (scale.view.top - scale.view.bottom);  // under the uplift
  const shapes = [span([beside, d.bottom], [beside, d.top], `${number(d.top - d.bottom)} m`, false),
    span([d.base[0], below], [d.base[1], below], `${number(d.base[1] - d.base[0])} m`, true)];
  if (d.crest[1] - d.crest[0] > 1e-6 * d.top) shapes.push(span([d.crest[0], d.top + 0.02 * (scale.view.top - scale.view.bottom)], [d.crest[1], d.top + 0.02 * (scale.view.top - scale.view.bottom)], `${number(d.crest[1] - d.crest[0])} m`, true));
  return shapes;
}

/// What acts beside weight and water: arrows with their size, kN or kPa.
function loadShapes(report, scale) {
  const shapes = [];
  const lines = report.loads.filter(load => load.kind === 'line');
  const largest = Math.max(0, ...lines.flatMap(load => [Math.hypot(...load.force_from), Math.hypot(...load.force_to)])) || 1;
  for (const load of report.loads) {
    if (load.kind === 'point') {
      const size = Math.hypot(...load.force);
      if (size > 0) shapes.push(arrow(scale, load.at, load.force, `${kilo(size)} kN/m`));
      continue;
    }
    shapes.push(...lineLoadShapes(load, 0.12 * report.size_m / largest, scale));
  }
  return shapes;
}

/// A load along a line as a diagram: `by` metres for each unit of it, against its direction, with arrows to scale and its
/// largest value.
function lineLoadShapes(load, by, scale) {
  const away = (at, force) => [at[0] - by * force[0], at[1] - by * force[1]];
  const shapes = [element('polygon', {points: scale.points([load.from, load.to, away(load.to, load.force_to), away(load.from, load.force_from)]),
    fill: '#7a1fa2', 'fill-opacity': 0.12, stroke: '#7a1fa2', 'stroke-width': 0.8})];
  const count = 4, shortest = 14;  // points that an arrow's head takes
  for (let i = 0; i <= count; ++i) {
    const at = [0, 1].map(k => load.from[k] + i / count * (load.to[k] - load.from[k]));
    const force = [0, 1].map(k => load.force_from[k] + i / count * (load.force_to[k] - load.force_from[k]));
    const reach = by * Math.hypot(...force) * scale.factor;
    if (reach > shortest) shapes.push(arrow(scale, at, force, '', reach));
  }
  const first = Math.hypot(...load.force_from), last = Math.hypot(...load.force_to);
  const [at, force] = last > first ? [load.to, load.force_to] : [load.from, load.force_from];
  const tip = away(at, force);
  if (first + last > 0) {
    shapes.push(label({x: scale.x(tip[0]), y: scale.y(tip[1]) - 4, 'text-anchor': force[0] > 0 ? 'end' : 'start'}, '#7a1fa2',
      (load.name ? load.name + ' ' : '') + `${kilo(Math.max(first, last))} kPa`));
  }
  return shapes;
}

/// The section at rest with all that an engineer asks for.
function sectionFigure(report) {
  const frame = report.frames[report.pictured];
  const size = report.size_m;
  const pressure = pressureDiagrams(frame, size);
  const view = viewWith(report.view, pressure.diagrams.flatMap(d => d.outline), 0.06 * size);
  const scale = new Scale(view, fittingWidth(view), 46);
  const {svg, inside} = drawing(scale, true);
  inside.append(...waterShapes(frame, scale), ...blockShapes(report, {outlines: report.blocks.map(b => b.outline)}, scale),
    ...pressureShapes(pressure.diagrams, scale), ...boltShapes(frame, scale), ...jointShapes(report, scale), ...dimensionShapes(report, scale), ...loadShapes(report, scale), ...levelShapes(report, frame, scale));
  const caption = pressure.largest > 0
    ? `Blocks as the scene draws them; water and its pressures at ${number(frame.t)} s. Pressure diagrams are drawn outwards; the largest is ${kilo(pressure.largest)} kPa. Uplift stands below its joint. Dashed red: joints with a name.`
    : 'Blocks as the scene draws them. Dashed red: joints with a name.';
  return element('figure', {}, svg, element('figcaption', {}, caption));
}

/// The section at each of some moments, for paper.
function snapshotFigures(report) {
  const scale = new Scale(report.view, 460, 8);
  const from = report.failure_s === null ? 0 : report.frames.findIndex(f => f.t >= report.failure_s);
  const first = Math.max(0, from);
  const last = report.frames.length - 1;
  const picks = [...new Set([0, 1, 2, 3, 4, 5].map(k => Math.round(first + (last - first) * k / 5)))];
  return element('div', {class: 'snapshots'}, ...picks.map(i => {
    const frame = report.frames[i];
    const {svg, inside} = drawing(scale, false);
    inside.append(...waterShapes(frame, scale), ...blockShapes(report, frame, scale), ...boltShapes(frame, scale), ...levelShapes(report, frame, scale));
    return element('figure', {}, svg, element('figcaption', {}, momentText(frame)));
  }));
}

function momentText(frame) {
  return `${fixed(frame.t, 2)} s` + (is(frame.upstream) ? `, level ${fixed(frame.upstream, 2)} m` : '') + (frame.breached ? ', breached' : '');
}

/// Blocks displaced by the mechanism, so that the fastest vertex moves by 6 % of the structure.
function mechanismFigure(report, mechanism, level) {
  const scale = new Scale(report.view, fittingWidth(report.view), 46);
  const {svg, inside} = drawing(scale, true);
  const motions = new Map(mechanism.blocks.map(b => [b.name, b]));
  const by = 0.06 * report.size_m;
  const shapes = [];
  for (const block of report.blocks) {
    const motion = motions.get(block.name);
    const points = scale.points(block.outline);
    if (!motion) {
      shapes.push(element('polygon', {points, fill: block.fixed ? 'var(--ground)' : 'var(--block)', stroke: '#30343a'}));
      continue;
    }
    const centre = block.centroid;
    const angle = by * motion.spin_per_m;
    const moved = block.outline.map(([x, y]) => {
      const [dx, dy] = [x - centre[0], y - centre[1]];
      return [centre[0] + by * motion.velocity_x + Math.cos(angle) * dx - Math.sin(angle) * dy,
        centre[1] + by * motion.velocity_y + Math.sin(angle) * dx + Math.cos(angle) * dy];
    });
    shapes.push(element('polygon', {points: scale.points(moved), fill: '#d98c5f', 'fill-opacity': 0.85, stroke: '#30343a'}),
      element('polygon', {points, fill: 'none', stroke: '#30343a', 'stroke-dasharray': '4 3'}));
  }
  inside.append(...shapes, ...levelShapes(report, {upstream: level}, scale));
  return element('figure', {class: 'mechanism'}, svg, element('figcaption', {}, `Mechanism: ${mechanism.text}. Displacements are drawn large.`));
}
