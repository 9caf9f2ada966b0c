// Uses the report as a reader does, and leaves what it saw in place of the page. The test puts it at the page's end.
// Without a screen, on virtual time, a browser may draw no frame: they come by the clock.
window.requestAnimationFrame = draw => setTimeout(() => draw(performance.now()), 16);
window.cancelAnimationFrame = clearTimeout;
addEventListener('load', () => {
  const seen = {};
  const control = name => document.getElementById(name);
  const moment = () => control('moment').value;
  const drawn = () => [...document.querySelectorAll('#animation polygon')].map(p => p.getAttribute('points')).join(' ');
  const charts = () => [...document.querySelectorAll('.chart')];
  const chart = charts()[0].querySelector('svg');
  const box = chart.getBoundingClientRect();
  chart.setPointerCapture = () => {};
  const pointer = (kind, share) => chart.dispatchEvent(new PointerEvent(kind,
    {pointerId: 1, clientX: box.left + share * box.width, clientY: box.top + box.height / 2}));

  seen.chapters = [...document.querySelectorAll('h2')].map(h => h.textContent);
  seen.verdict = control('verdict').textContent;
  seen.outcome_class = document.querySelector('.outcome').className;
  seen.joints = control('cases').textContent;
  seen.level = control('level').textContent;
  seen.reliability = control('reliability') ? control('reliability').textContent : '';
  seen.fragility = document.querySelectorAll('.fragility polygon').length;
  seen.asked_lines = document.querySelectorAll('.fragility line[stroke-dasharray]').length;
  seen.scene = control('again').textContent;
  seen.section = control('section').textContent;
  seen.states = document.querySelectorAll('.state').length;
  const boxes = [...document.querySelectorAll('#section svg g > text:first-child')].map(t => t.getBoundingClientRect());
  seen.labels_apart = boxes.every((a, i) => boxes.every((b, j) => i === j || a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top));
  seen.mechanism = document.querySelectorAll('.mechanism polygon').length;

  control('scrub').value = 0;
  control('scrub').dispatchEvent(new Event('input'));
  const first = drawn();
  const begun = moment();
  control('on').click();
  seen.steps_on = moment() !== begun;
  control('back').click();
  seen.steps_back = moment() === begun && drawn() === first;
  control('scrub').value = control('scrub').max;
  control('scrub').dispatchEvent(new Event('input'));
  seen.scrubs = drawn() !== first;
  control('speed').value = '4';
  control('play').click();  // from the end it begins anew
  const after_it_moves = (looks, then) => (looks === 0 || (moment() !== begun && drawn() !== first) ? then()
    : setTimeout(after_it_moves, 100, looks - 1, then));
  after_it_moves(200, () => {
    if (control('play').textContent === 'Pause') control('play').click();  // it may have come to its end
    seen.plays = moment() !== begun && drawn() !== first && control('play').textContent === 'Play';
    const whole = charts().map(c => c.textContent);
    pointer('pointerdown', 0.3);
    pointer('pointermove', 0.5);
    pointer('pointerup', 0.5);
    seen.zooms_all = charts().every((c, i) => c.textContent !== whole[i]);
    chart.dispatchEvent(new MouseEvent('dblclick'));
    seen.shows_all = charts().every((c, i) => c.textContent === whole[i]);
    const played = moment();
    pointer('pointerdown', 0.9);
    pointer('pointerup', 0.9);
    seen.linked = moment() !== played;
    seen.faults = faults;
    const answer = document.createElement('pre');
    answer.textContent = JSON.stringify(seen);
    document.documentElement.replaceChildren(answer);
  });
});
