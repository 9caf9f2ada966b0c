// Small helpers: elements, numbers in the engineer's units, tables.
const SVG = 'http://www.w3.org/2000/svg';

function element(name, attributes, ...children) {
  const drawn = ['svg', 'g', 'line', 'path', 'polygon', 'polyline', 'circle', 'rect', 'text', 'title', 'clipPath', 'defs'].includes(name);
  const made = drawn ? document.createElementNS(SVG, name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes || {})) made.setAttribute(key, value);
  for (const child of children) made.append(child);
  return made;
}

const is = Number.isFinite;
const number = (value, digits) => (is(value) ? Number(value.toPrecision(digits || 5)).toString() : '-');
const fixed = (value, decimals) => (is(value) ? value.toFixed(decimals).replace(/^-(?=[0.]*$)/, '') : '-');  // no sign of a zero
const kilo = (value, decimals) => fixed(is(value) ? value / 1000 : NaN, decimals === undefined ? 1 : decimals);

const measure = document.createElement('canvas').getContext('2d');

/// Of a text on paper, where letters are largest; `size` in the drawing's points.
function textWidth(text, size) {
  measure.font = `${size}px "Liberation Sans", Arial, sans-serif`;
  return measure.measureText(text).width;
}

/// Rows of cells: a text, or an element; numbers stand to the right.
function table(headings, rows) {
  const cell = (kind, content, right) => element(kind, right ? {class: 'number'} : {}, content);
  const right = headings.map((_, i) => rows.some(row => /^-?[\d.]/.test(row[i])));
  const head = headings.some(h => h !== '') ? [element('thead', {}, element('tr', {}, ...headings.map((h, i) => cell('th', h, right[i]))))] : [];
  return element('table', rows.length > 12 ? {} : {class: 'short'}, ...head,
    element('tbody', {}, ...rows.map(row => element('tr', {}, ...row.map((c, i) => cell('td', c, right[i]))))));
}

function paragraph(text, kind) {
  return element('p', kind ? {class: kind} : {}, text);
}

/// A step of 1, 2 or 5 times a power of ten, about `count` of which lie in the span.
function roundStep(span, count) {
  const raw = span / count;
  const power = Math.pow(10, Math.floor(Math.log10(raw)));
  return power * [1, 2, 5, 10].find(m => m * power >= raw * 0.999);
}

/// A tick's value with as many decimals as its step has.
function tickText(value, all) {
  if (all.length < 2) return number(value);
  return value.toFixed(Math.min(12, Math.max(0, -Math.floor(Math.log10(all[1] - all[0]) + 1e-9))));
}

function ticks(from, to, count) {
  if (!(to > from)) return [from];
  const step = roundStep(to - from, count);
  const all = [];
  for (let i = Math.ceil(from / step - 1e-9); i * step <= to + 1e-9 * step; ++i) all.push(Number((i * step).toPrecision(12)));
  return all;
}
