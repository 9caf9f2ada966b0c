// Time histories that share one time axis and one moment: a drag zooms, a double click shows all, a click goes there.

const curveColours = ['#1f6fb4', '#b3261e', '#1a7f37', '#7a1fa2', '#c77700', '#00838f', '#5d4037', '#455a64'];
/// Every other curve is dashed: not by colour alone are eight told apart.
const dashOf = k => (k % 2 === 1 ? {'stroke-dasharray': '9 3'} : {});

class Chart {
  constructor(group, time, clock) {
    this.group = group;
    this.time = time;
    this.clock = clock;
    this.width = 940;
    this.entries = this.placeLegend();
    const rows = Math.max(0, ...this.entries.map(entry => entry.row + 1));
    this.box = {left: 70, right: 925, top: 24 + 18 * rows, bottom: 160 + 18 * rows};
    this.height = 198 + 18 * rows;
    this.svg = element('svg', {viewBox: `0 0 ${this.width} ${this.height}`, style: 'cursor: crosshair; touch-action: none'});
    this.figure = element('figure', {class: 'chart'}, this.svg);
    this.listen();
  }

  /// Where the names of the curves stand: in rows between the title and the chart, none over another on paper either.
  placeLegend() {
    const [paper, left, right] = [13, 70, 925];
    let [x, row] = [left, 0];
    return this.group.curves.map((curve, k) => ({name: curve.name, k})).filter(entry => entry.name).map(entry => {
      const width = textWidth(entry.name, paper) + 38;
      if (x > left && x + width > right) [x, row] = [left, row + 1];
      const placed = {...entry, x, row};
      x += width;
      return placed;
    });
  }

  x(t) { return this.box.left + (t - this.clock.from) / (this.clock.to - this.clock.from) * (this.box.right - this.box.left); }
  timeAt(event) {
    const shown = this.svg.getBoundingClientRect();
    const x = (event.clientX - shown.left) * this.width / shown.width;
    const share = (x - this.box.left) / (this.box.right - this.box.left);
    return this.clock.from + Math.min(1, Math.max(0, share)) * (this.clock.to - this.clock.from);
  }

  listen() {
    let pressed = null;
    this.svg.addEventListener('pointerdown', event => { pressed = this.timeAt(event); this.svg.setPointerCapture(event.pointerId); });
    this.svg.addEventListener('pointermove', event => { if (pressed !== null) this.band(pressed, this.timeAt(event)); });
    this.svg.addEventListener('pointerup', event => {
      if (pressed === null) return;
      const released = this.timeAt(event);
      const [from, to] = [Math.min(pressed, released), Math.max(pressed, released)];
      pressed = null;
      this.band(0, 0);
      if (to - from > 0.02 * (this.clock.to - this.clock.from)) this.clock.zoom(from, to);
      else this.clock.go(released);
    });
    this.svg.addEventListener('dblclick', () => this.clock.showAll());
  }

  band(from, to) {
    const [a, b] = [this.x(Math.min(from, to)), this.x(Math.max(from, to))];
    this.zoomed.setAttribute('x', a);
    this.zoomed.setAttribute('width', Math.max(0, b - a));
  }

  /// From the first row at or after the left end to the last at or before the right end, and one beyond each.
  rows() {
    let first = this.time.findIndex(t => t >= this.clock.from);
    let last = this.time.length - 1;
    while (last > 0 && this.time[last] > this.clock.to) --last;
    return [Math.max(0, first - 1), Math.min(this.time.length - 1, last + 1)];
  }

  draw() {
    const {left, right, top, bottom} = this.box;
    const [first, last] = this.rows();
    let low = Infinity, high = -Infinity;
    for (const curve of this.group.curves) {
      for (let i = first; i <= last; ++i) {
        if (!is(curve.values[i])) continue;
        low = Math.min(low, curve.values[i]);
        high = Math.max(high, curve.values[i]);
      }
    }
    if (low > high) [low, high] = [0, 1];
    const only = high - low <= 1e-9 * Math.max(Math.abs(low), Math.abs(high)) ? [low] : null;
    const least = Math.max(this.group.rest, 1e-9 * Math.max(Math.abs(low), Math.abs(high)));
    const edge = Math.max(0.05 * (high - low), least - (high - low) / 2);
    [low, high] = [low - edge, high + edge];
    const y = value => bottom - (value - low) / (high - low) * (bottom - top);
    const parts = [element('rect', {x: left, y: top, width: right - left, height: bottom - top, fill: 'white', stroke: '#9aa3ad'})];
    const levels = only || ticks(low, high, 4);
    for (const value of levels) {
      parts.push(element('line', {x1: left, x2: right, y1: y(value), y2: y(value), stroke: '#e3e7ec'}),
        element('text', {x: left - 6, y: y(value) + 4, 'text-anchor': 'end'}, tickText(value, levels)));
    }
    for (const t of ticks(this.clock.from, this.clock.to, 10)) {
      parts.push(element('line', {x1: this.x(t), x2: this.x(t), y1: top, y2: bottom, stroke: '#e3e7ec'}),
        element('text', {x: this.x(t), y: bottom + 16, 'text-anchor': 'middle'}, number(t)));
    }
    parts.push(element('text', {x: right, y: this.height - 2, 'text-anchor': 'end'}, 'time (s)'), element('text', {x: left, y: 14, style: 'font-weight: 600'}, this.group.title));
    for (const {name, k, x, row} of this.entries) {
      parts.push(element('line', {x1: x, x2: x + 18, y1: 28 + 18 * row, y2: 28 + 18 * row, stroke: curveColours[k % curveColours.length], 'stroke-width': 3, ...dashOf(k)}),
        element('text', {x: x + 22, y: 32 + 18 * row}, name));
    }
    this.group.curves.forEach((curve, k) => {
      const points = [];
      for (let i = first; i <= last; ++i) {
        if (!is(curve.values[i])) continue;
        const x = Math.min(right, Math.max(left, this.x(this.time[i])));
        points.push(`${x.toFixed(1)},${Math.min(bottom, Math.max(top, y(curve.values[i]))).toFixed(1)}`);
      }
      parts.push(element('polyline', {points: points.join(' '), fill: 'none', stroke: curveColours[k % curveColours.length], 'stroke-width': 1.6, ...dashOf(k)}));
    });
    if (this.clock.failure !== null && this.clock.failure >= this.clock.from && this.clock.failure <= this.clock.to) {
      parts.push(element('line', {x1: this.x(this.clock.failure), x2: this.x(this.clock.failure), y1: top, y2: bottom, stroke: 'var(--bad)', 'stroke-dasharray': '5 4'}));
    }
    this.zoomed = element('rect', {x: 0, y: top, width: 0, height: bottom - top, fill: '#1f6fb4', 'fill-opacity': 0.2});
    this.cursor = element('line', {y1: top, y2: bottom, stroke: '#1c2430', 'stroke-width': 1.5, class: 'screen'});
    this.svg.replaceChildren(...parts, this.zoomed, this.cursor);
    this.move();
  }

  move() {
    const at = Math.min(this.box.right, Math.max(this.box.left, this.x(this.clock.now)));
    this.cursor.setAttribute('x1', at);
    this.cursor.setAttribute('x2', at);
  }
}
