// Plots of curves over time that share one time axis: drag to zoom, double-click to reset, hover to
// read values, click to put the shared marker there. All of it works from the keyboard as well. Uses
// page_tools.js.

const kMargin = { left: 62, right: 14, top: 12, bottom: 26 };
// The least range of values that a plot shows, relative to the largest of them: values that vary
// less are shown as flat.
const kLeastSpread = 1e-4;

/** The time that all plots show, and the two times that they mark. */
class TimeAxis {
  constructor(begin, end) {
    this.full = [begin, end];
    this.view = [begin, end];
    this.cursor = null; // place of the pointer or the keyboard
    this.marker = null; // time of the animation
    this.events = []; // {name, t}: times with names, in order
    this.listeners = [];
  }
  listen(callback) {
    this.listeners.push(callback);
  }
  changed() {
    for (const callback of this.listeners) callback(this);
  }
  get isZoomed() {
    return this.view[0] > this.full[0] || this.view[1] < this.full[1];
  }
  /** Shows [begin, end], kept within the whole and no shorter than 1e-5 of it. */
  show(begin, end) {
    const [low, high] = this.full;
    const length = Math.min(Math.max(end - begin, 1e-5 * (high - low)), high - low);
    const first = Math.min(Math.max(begin, low), high - length);
    this.view = [first, first + length];
    this.changed();
  }
  reset() {
    this.view = [...this.full];
    this.changed();
  }
  zoom(factor, about) {
    const [begin, end] = this.view;
    const centre = about ?? 0.5 * (begin + end);
    this.show(centre - (centre - begin) * factor, centre + (end - centre) * factor);
  }
  point(time) {
    this.cursor = time === null ? null : Math.min(Math.max(time, this.view[0]), this.view[1]);
    this.changed();
  }
}

/** A curve's value at a time, between samples on the straight line; NaN outside of them. */
function valueAt(curve, time) {
  const k = lowerBound(curve.times, time);
  if (k === curve.times.length || (k === 0 && curve.times[0] > time)) return NaN;
  if (k === 0 || curve.times[k] === time) return curve.values[k];
  const share = (time - curve.times[k - 1]) / (curve.times[k] - curve.times[k - 1]);
  return curve.values[k - 1] + share * (curve.values[k] - curve.values[k - 1]);
}

class TimePlot {
  /** plot: {title, unit, curves: [{name, color, times, values}]}; `say` speaks to screen readers;
   *  `choose` is told of a time that was clicked. */
  constructor(host, plot, axis, say, choose) {
    this.plot = plot;
    this.axis = axis;
    this.say = say;
    this.choose = choose;
    this.drag = null;
    plot.curves.forEach((curve) => Object.assign(curve, { isShown: true }));
    this.canvas = make('canvas', { tabIndex: 0, role: 'img', 'aria-describedby': 'plot-keys' });
    this.canvas.setAttribute('aria-label', this.describe());
    this.legend = make('div', { className: 'legend', role: 'group', 'aria-label': 'Curves' });
    this.readouts = plot.curves.map((curve) => this.addKey(curve));
    const caption = make('figcaption', {}, [make('strong', { textContent: plot.title })]);
    this.unit = make('span', { textContent: plot.unit });
    caption.append(this.unit);
    host.append(make('figure', { className: 'plot' }, [caption, this.canvas, this.legend]));
    this.followPointer();
    this.canvas.addEventListener('keydown', (event) => this.followKey(event));
    axis.listen(() => this.draw());
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  describe() {
    let low = Infinity;
    let high = -Infinity;
    for (const { values } of this.plot.curves)
      for (const value of values) {
        low = Math.min(low, value);
        high = Math.max(high, value);
      }
    const count = this.plot.curves.length;
    const events = this.axis.events.map(({ name, t }) => `, ${name} at ${numberText(t)} s`).join('');
    return `${this.plot.title} over time, ${count} ${count === 1 ? 'curve' : 'curves'}, between ${numberText(low)} and ${numberText(high)} ${this.plot.unit}${events}`;
  }

  addKey(curve) {
    const readout = make('output', { textContent: '' });
    const line = make('canvas', { className: 'swatch', width: 44, height: 12 });
    const key = make('button', { type: 'button', 'aria-pressed': 'true' }, [
      line,
      make('span', { textContent: curve.name }),
      readout,
    ]);
    key.addEventListener('click', () => {
      curve.isShown = !curve.isShown;
      key.setAttribute('aria-pressed', String(curve.isShown));
      this.draw();
    });
    curve.swatch = line;
    this.legend.append(key);
    return readout;
  }

  // Geometry

  timeOf(x) {
    const [begin, end] = this.axis.view;
    return begin + ((x - this.area.left) / this.area.width) * (end - begin);
  }
  xOf(time) {
    const [begin, end] = this.axis.view;
    return this.area.left + ((time - begin) / (end - begin)) * this.area.width;
  }
  yOf(value) {
    const { low, high } = this.range;
    return kMargin.top + (1 - (value - low) / (high - low)) * this.area.height;
  }

  /** The samples of a curve that are in view, with a neighbour on either side. */
  visible(curve) {
    const [begin, end] = this.axis.view;
    const first = Math.max(0, lowerBound(curve.times, begin) - 1);
    const last = Math.min(curve.times.length, lowerBound(curve.times, end) + 1);
    return [first, last];
  }

  findRange() {
    let low = Infinity;
    let high = -Infinity;
    for (const curve of this.plot.curves) {
      if (!curve.isShown) continue;
      const [first, last] = this.visible(curve);
      for (let k = first; k < last; ++k) {
        low = Math.min(low, curve.values[k]);
        high = Math.max(high, curve.values[k]);
      }
    }
    if (!(low <= high)) return { low: 0, high: 1 };
    const size = Math.max(Math.abs(low), Math.abs(high));
    const spread = Math.max(high - low, kLeastSpread * size) || 1;
    const middle = 0.5 * (low + high);
    return { low: middle - 0.57 * spread, high: middle + 0.57 * spread };
  }

  // Drawing

  draw() {
    const { context, width, height } = prepareCanvas(this.canvas);
    this.range = this.findRange();
    context.font = '12px system-ui, sans-serif';
    const plotHeight = Math.max(1, height - kMargin.top - kMargin.bottom);
    const labels = this.findLabels(plotHeight / 28);
    const widest = Math.max(...labels.map(({ text }) => context.measureText(text).width));
    const left = Math.max(kMargin.left, Math.ceil(widest) + 12);
    this.area = { left, width: Math.max(1, width - left - kMargin.right), height: plotHeight };
    this.drawGrid(context, labels);
    this.drawEvents(context);
    context.save();
    context.beginPath();
    context.rect(this.area.left, kMargin.top, this.area.width, this.area.height);
    context.clip();
    for (const curve of this.plot.curves) if (curve.isShown) this.drawCurve(context, curve);
    this.drawMarks(context);
    context.restore();
    this.drawTimeTag(context);
    this.showReadouts();
  }

  /** The values at which there are grid lines, at most so many, and their labels; names the unit. */
  findLabels(most) {
    const { low, high } = this.range;
    const { ticks, step } = roundTicks(low, high, most);
    const largest = Math.max(Math.abs(low), Math.abs(high));
    let exponent = 0;
    if (largest >= 1e4 || largest < 1e-2) exponent = 3 * Math.floor(Math.log10(largest) / 3);
    this.unit.textContent = exponent ? `10${superscript(exponent)} ${this.plot.unit}` : this.plot.unit;
    const decimals = Math.max(0, -Math.floor(Math.log10(step) - exponent + 1e-9));
    return ticks.map((value) => {
      const text = (value / 10 ** exponent + 0).toFixed(decimals).replace(/^-(?=0\.?0*$)/, '');
      return { value, text: text.replace('-', '\u2212'), isZero: Math.abs(value) < 1e-9 * largest };
    });
  }

  drawGrid(context, labels) {
    context.lineWidth = 1;
    context.textBaseline = 'middle';
    context.textAlign = 'right';
    for (const { value, text, isZero } of labels) {
      const y = Math.round(this.yOf(value)) + 0.5;
      context.strokeStyle = colorOf(isZero ? '--soft' : '--rule');
      context.beginPath();
      context.moveTo(this.area.left, y);
      context.lineTo(this.area.left + this.area.width, y);
      context.stroke();
      context.fillStyle = colorOf('--soft');
      context.fillText(text, this.area.left - 8, y);
    }
    this.drawTimeScale(context);
  }

  drawTimeScale(context) {
    const [begin, end] = this.axis.view;
    const { ticks, step } = roundTicks(begin, end, this.area.width / 90);
    const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    const bottom = kMargin.top + this.area.height;
    context.textBaseline = 'top';
    for (const tick of ticks) {
      const x = Math.round(this.xOf(tick)) + 0.5;
      context.strokeStyle = colorOf('--rule');
      context.beginPath();
      context.moveTo(x, kMargin.top);
      context.lineTo(x, bottom + 4);
      context.stroke();
      context.textAlign = x > this.area.left + this.area.width - 16 ? 'right' : 'center';
      context.fillStyle = colorOf('--soft');
      const isLast = tick === ticks[ticks.length - 1];
      context.fillText(tick.toFixed(decimals) + (isLast ? ' s' : ''), x, bottom + 8);
    }
  }

  /** Lines at the events in view, each with its name as far as it is clear of the one before. */
  drawEvents(context) {
    const right = this.area.left + this.area.width;
    let clear = this.area.left;
    context.textBaseline = 'top';
    for (const { name, t } of this.axis.events) {
      const x = Math.round(this.xOf(t)) + 0.5;
      if (x < this.area.left || x > right) continue;
      context.strokeStyle = colorOf('--ink');
      context.lineWidth = 1;
      context.setLineDash([2, 3]);
      context.beginPath();
      context.moveTo(x, kMargin.top);
      context.lineTo(x, kMargin.top + this.area.height);
      context.stroke();
      context.setLineDash([]);
      const size = context.measureText(name).width;
      const begin = x + 4 + size <= right ? x + 4 : x - 4 - size;
      if (begin < clear) continue;
      context.fillStyle = colorOf('--ink');
      context.textAlign = 'left';
      context.fillText(name, begin, kMargin.top + 2);
      clear = begin + size + 6;
    }
  }

  drawCurve(context, curve) {
    const [first, last] = this.visible(curve);
    context.strokeStyle = seriesColor(curve.color);
    context.lineWidth = 1.75;
    context.lineJoin = 'round';
    context.setLineDash(dashesOf(curve.color));
    context.beginPath();
    for (let k = first; k < last; ++k)
      context.lineTo(this.xOf(curve.times[k]), this.yOf(curve.values[k]));
    context.stroke();
    context.setLineDash([]);
    drawSwatch(curve.swatch, curve.color);
  }

  drawMarks(context) {
    const bottom = kMargin.top + this.area.height;
    const line = (time, color, width) => {
      const x = this.xOf(time);
      context.strokeStyle = color;
      context.lineWidth = width;
      context.beginPath();
      context.moveTo(x, kMargin.top);
      context.lineTo(x, bottom);
      context.stroke();
    };
    if (this.axis.marker !== null) {
      context.globalAlpha = 0.55;
      line(this.axis.marker, colorOf('--ink'), 1.5);
      context.globalAlpha = 1;
    }
    if (this.drag?.isZoom) {
      const [a, b] = [this.drag.from, this.drag.to].sort((p, q) => p - q);
      context.fillStyle = colorOf('--s0');
      context.globalAlpha = 0.14;
      context.fillRect(a, kMargin.top, b - a, this.area.height);
      context.globalAlpha = 1;
    }
    if (this.axis.cursor === null) return;
    line(this.axis.cursor, colorOf('--soft'), 1);
    for (const curve of this.plot.curves) {
      const value = curve.isShown ? valueAt(curve, this.axis.cursor) : NaN;
      if (!Number.isFinite(value)) continue;
      context.beginPath();
      context.arc(this.xOf(this.axis.cursor), this.yOf(value), 3.5, 0, 2 * Math.PI);
      context.fillStyle = seriesColor(curve.color);
      context.strokeStyle = colorOf('--paper');
      context.lineWidth = 1.5;
      context.fill();
      context.stroke();
    }
  }

  drawTimeTag(context) {
    if (this.axis.cursor === null) return;
    const text = `${numberText(this.axis.cursor)} s`;
    const half = context.measureText(text).width / 2 + 6;
    const right = this.area.left + this.area.width;
    const x = Math.min(Math.max(this.xOf(this.axis.cursor), this.area.left + half), right - half);
    const y = kMargin.top + this.area.height + 4;
    context.fillStyle = colorOf('--ink');
    context.beginPath();
    context.roundRect(x - half, y, 2 * half, 20, 4);
    context.fill();
    context.fillStyle = colorOf('--paper');
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.fillText(text, x, y + 10.5);
  }

  showReadouts() {
    const time = this.axis.cursor ?? this.axis.marker;
    this.plot.curves.forEach((curve, k) => {
      const value = time === null || !curve.isShown ? NaN : valueAt(curve, time);
      this.readouts[k].textContent = Number.isFinite(value) ? `${numberText(value)} ${this.plot.unit}` : '';
    });
  }

  // Pointer and keyboard

  followPointer() {
    const xIn = (event) => {
      const x = event.clientX - this.canvas.getBoundingClientRect().left;
      return Math.min(Math.max(x, this.area.left), this.area.left + this.area.width);
    };
    this.canvas.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      this.drag = { from: xIn(event), to: xIn(event), isZoom: false };
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener('pointermove', (event) => {
      if (this.drag) {
        this.drag.to = xIn(event);
        this.drag.isZoom ||= Math.abs(this.drag.to - this.drag.from) > 5;
      }
      this.axis.point(this.timeOf(xIn(event)));
    });
    this.canvas.addEventListener('pointerup', () => this.endDrag());
    this.canvas.addEventListener('pointercancel', () => (this.drag = null));
    this.canvas.addEventListener('pointerleave', () => this.drag || this.axis.point(null));
    this.canvas.addEventListener('dblclick', () => this.axis.reset());
  }

  endDrag() {
    const drag = this.drag;
    this.drag = null;
    if (!drag) return;
    const [begin, end] = [this.timeOf(drag.from), this.timeOf(drag.to)].sort((a, b) => a - b);
    if (drag.isZoom) this.axis.show(begin, end);
    else this.choose(end);
  }

  followKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { axis } = this;
    const [begin, end] = axis.view;
    const length = end - begin;
    const cursor = axis.cursor ?? axis.marker ?? begin;
    const step = (event.shiftKey ? 0.1 : 0.01) * length;
    const actions = {
      ArrowLeft: () => axis.point(cursor - step),
      ArrowRight: () => axis.point(cursor + step),
      Home: () => axis.point(begin),
      End: () => axis.point(end),
      PageUp: () => axis.show(begin - 0.5 * length, end - 0.5 * length),
      PageDown: () => axis.show(begin + 0.5 * length, end + 0.5 * length),
      '+': () => axis.zoom(0.5, cursor),
      '=': () => axis.zoom(0.5, cursor),
      '-': () => axis.zoom(2, cursor),
      0: () => axis.reset(),
      Escape: () => axis.reset(),
      Enter: () => this.choose(cursor),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
    this.speak();
  }

  speak() {
    const { cursor, view } = this.axis;
    const values = this.plot.curves
      .filter((curve) => curve.isShown && cursor !== null)
      .slice(0, 8)
      .map((curve) => `${curve.name} ${numberText(valueAt(curve, cursor))} ${this.plot.unit}`);
    const where = cursor === null ? '' : `At ${numberText(cursor)} s: ${values.join(', ')}. `;
    this.say(`${where}Shown: ${numberText(view[0])} to ${numberText(view[1])} s.`);
  }
}
