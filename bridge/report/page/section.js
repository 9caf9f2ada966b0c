// The section at a moment, drawn to scale: x downstream, elevations upwards, water, blocks, pressures, loads.

/// Metres of the section to the picture's points. `textSize`, on paper, of the texts at its axes, if it has any.
class Scale {
  constructor(view, width, margin, textSize) {
    this.view = view;
    this.margin = margin;
    this.left = margin;
    this.textSize = textSize;
    this.width = width;
    if (textSize) {
      const widest = all => Math.max(...all.map(value => textWidth(number(value), textSize)));
      this.left = Math.max(margin, 26 + widest(ticks(view.bottom, view.top, 7)));
      this.ticksAlong = Math.max(1, Math.min(9, (width - this.left - margin) / (widest(ticks(view.left, view.right, 9)) + 14)));
    }
    this.factor = (width - this.left - margin) / (view.right - view.left);
    this.height = this.factor * (view.top - view.bottom) + 2 * margin;
    if (textSize) this.ticksUp = Math.max(1, Math.min(7, (this.height - 2 * margin) / (1.5 * textSize)));
  }
  x(metres) { return this.left + (metres - this.view.left) * this.factor; }
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

const BOLT = '#b03060';
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
    for (const x of ticks(view.left, view.right, scale.ticksAlong)) {
      svg.append(element('line', {x1: scale.x(x), x2: scale.x(x), y1: scale.y(view.bottom), y2: scale.y(view.bottom) + 5, stroke: '#9aa3ad'}),
        element('text', {x: scale.x(x), y: scale.y(view.bottom) + 5.5 + scale.textSize, 'text-anchor': 'middle'}, number(x)));
    }
    for (const y of ticks(view.bottom, view.top, scale.ticksUp)) {
      svg.append(element('line', {x1: scale.x(view.left) - 5, x2: scale.x(view.left), y1: scale.y(y), y2: scale.y(y), stroke: '#9aa3ad'}),
        element('text', {x: scale.x(view.left) - 8, y: scale.y(y) + 3, 'text-anchor': 'end'}, number(y)));
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

function contactShapes(frame, scale) {
  return frame.contacts.map(([x, y, state]) => element('circle', {cx: scale.x(x), cy: scale.y(y), r: 3.5, fill: state === 2 ? '#d00000' : '#1a7f37'}));
}

function boltShapes(frame, scale) {
  return frame.bolts.map(([x1, y1, x2, y2]) => element('line', {x1: scale.x(x1), y1: scale.y(y1), x2: scale.x(x2), y2: scale.y(y2), stroke: BOLT, 'stroke-width': 3}));
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
  const scale = new Scale(report.view, fittingWidth(report.view), 50, 17);
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
  return element('figure', {class: 'mechanism'}, svg, element('figcaption', {}, `Mechanism: ${mechanism.text}.${mechanism.caption ? ` By limit analysis ${mechanism.caption}.` : ''} Displacements are drawn large.`));
}
