// Tools for the scripts of all pages: colours of the style, numbers for people, canvases, data.

const kColors = 8;
const kDashes = [[], [8, 4], [2, 3], [10, 3, 2, 3]];
const kSuperscripts = '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079';

/** The value of a colour of the page's style, by the name of its variable. */
function colorOf(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

function seriesColor(index) {
  return colorOf(`--s${index % kColors}`);
}

/** Colours that come again are dashed, each time differently. */
function dashesOf(index) {
  return kDashes[Math.floor(index / kColors) % kDashes.length];
}

/** A piece of a line, for legends; the canvas is 44 by 12. */
function drawSwatch(canvas, index) {
  const context = canvas.getContext('2d');
  context.clearRect(0, 0, 44, 12);
  context.strokeStyle = seriesColor(index);
  context.lineWidth = 5;
  context.setLineDash(dashesOf(index).map((d) => 2 * d));
  context.beginPath();
  context.moveTo(0, 6);
  context.lineTo(44, 6);
  context.stroke();
}

/** Round values, at most `most` of them, that lie in [low, high]. */
function roundTicks(low, high, most) {
  const rough = (high - low) / Math.max(1, most);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((factor) => factor * power >= rough * (1 - 1e-9));
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
    ticks.push(k * step);
  return { ticks, step };
}

/** A number for people: five significant digits, a true minus sign. */
function numberText(value) {
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  const text =
    size >= 1e5 || size < 1e-3 ? value.toExponential(4) : String(Number(value.toPrecision(5)));
  return text.replace('-', '\u2212').replace('e-', 'e\u2212').replace('e+', 'e');
}

function superscript(number) {
  return String(number).replace(/[-0-9]/g, (c) => (c === '-' ? '\u207b' : kSuperscripts[Number(c)]));
}

/** Makes a canvas as sharp as the screen; returns its context, in CSS pixels. */
function prepareCanvas(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth;
  const height = canvas.clientHeight;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext('2d');
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return { context, width, height };
}

function strokeLine(context, points) {
  context.beginPath();
  for (const [x, y] of points) context.lineTo(x, y);
  context.stroke();
}

function make(name, properties = {}, children = []) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(properties))
    if (key.includes('-') || key === 'role') element.setAttribute(key, value);
    else element[key] = value;
  element.append(...children);
  return element;
}

/** Index of the first sample at or after a time. */
function lowerBound(times, time) {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] < time) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Numbers that the page carries as base64: of little-endian Float32 or Int16. */
function decode(text, Type) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Type(bytes.buffer);
}
