// The moment that animation and charts share, and the animation.

class Clock {
  constructor(begin, end, failure) {
    if (!(end > begin)) end = begin + 1;  // a single moment, as of a static analysis
    [this.begin, this.end, this.failure] = [begin, end, failure];
    [this.from, this.to, this.now] = [begin, end, begin];
    this.charts = [];
    this.movers = [];
  }
  go(time) {
    this.now = Math.min(this.end, Math.max(this.begin, time));
    for (const mover of this.movers) mover(this.now);
    for (const chart of this.charts) chart.move();
  }
  zoom(from, to) {
    [this.from, this.to] = [from, to];
    for (const chart of this.charts) chart.draw();
  }
  showAll() { this.zoom(this.begin, this.end); }
}

class Animation {
  constructor(report, clock) {
    this.report = report;
    this.clock = clock;
    this.scale = new Scale(report.view, 940, 46, 12);
    const {svg, inside} = drawing(this.scale, true);
    this.inside = inside;
    this.shown = -1;
    this.playing = null;
    this.button = element('button', {id: 'play'}, 'Play');
    this.bar = element('input', {type: 'range', id: 'scrub', min: 0, max: report.frames.length - 1, value: 0, 'aria-label': 'moment'});
    this.told = element('output', {id: 'moment'});
    this.pressures = element('input', {type: 'checkbox', id: 'pressures'});
    const back = element('button', {id: 'back', title: 'one picture back'}, '<');
    const on = element('button', {id: 'on', title: 'one picture on'}, '>');
    const speed = element('select', {id: 'speed', title: 'speed'}, ...[['1', '1 x'], ['0.25', '1/4 x'], ['0.1', '1/10 x'], ['4', '4 x']].map(([value, text]) => element('option', {value}, text)));
    this.button.addEventListener('click', () => (this.playing ? this.stop() : this.play()));
    back.addEventListener('click', () => this.step(-1));
    on.addEventListener('click', () => this.step(1));
    this.bar.addEventListener('input', () => { this.stop(); clock.go(report.frames[this.bar.value].t); });
    this.pressures.addEventListener('change', () => { this.shown = -1; this.show(clock.now); });
    this.speed = () => Number(speed.value);
    clock.movers.push(time => this.show(time));
    this.figure = element('figure', {class: 'screen', id: 'animation'}, svg,
      element('div', {class: 'controls'}, this.button, back, on, this.bar, this.told, speed, element('label', {}, this.pressures, ' pressures')),
      element('figcaption', {}, 'Contacts: green sticks, red slips. What has moved far away is outside of the picture. Arrow keys step, the space bar plays.'));
    document.addEventListener('keydown', event => {
      if (['SELECT', 'BUTTON'].includes(event.target.tagName)) return;
      if (event.key === 'ArrowRight') this.step(1);
      else if (event.key === 'ArrowLeft') this.step(-1);
      else if (event.key === ' ') this.button.click();
      else return;
      event.preventDefault();
    });
  }

  /// The last picture at or before the time.
  frameAt(time) {
    const frames = this.report.frames;
    let low = 0, high = frames.length - 1;
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (frames[middle].t <= time + 1e-9) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  show(time) {
    const index = this.frameAt(time);
    if (index === this.shown) return;
    this.shown = index;
    const frame = this.report.frames[index];
    const {scale, report} = this;
    this.inside.replaceChildren(...waterShapes(frame, scale), ...blockShapes(report, frame, scale),
      ...(this.pressures.checked ? pressureShapes(pressureDiagrams(frame, report.size_m).diagrams, scale) : []), ...boltShapes(frame, scale), ...contactShapes(frame, scale), ...levelShapes(report, frame, scale));
    this.bar.value = index;
    this.told.value = momentText(frame);
  }

  step(by) {
    this.stop();
    const frames = this.report.frames;
    this.clock.go(frames[Math.min(frames.length - 1, Math.max(0, this.frameAt(this.clock.now) + by))].t);
  }

  play() {
    if (this.clock.now >= this.clock.end - 1e-9) this.clock.go(this.clock.begin);
    let before = performance.now();
    const on = now => {
      this.clock.go(this.clock.now + this.speed() * (now - before) / 1000);
      before = now;
      if (this.clock.now >= this.clock.end) this.stop();
      else this.playing = requestAnimationFrame(on);
    };
    this.playing = requestAnimationFrame(on);
    this.button.textContent = 'Pause';
  }

  stop() {
    if (this.playing) cancelAnimationFrame(this.playing);
    this.playing = null;
    this.button.textContent = 'Play';
  }
}
