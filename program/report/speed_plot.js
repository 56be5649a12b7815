// Values of modes over the speed of rotation, or over what else is varied, a line for each branch: drag a rectangle to zoom,
// hover to read a mode, click to choose it. All of it works from the keyboard as well. Uses
// page_tools.js and mode_choice.js.

const kFrame = { left: 62, right: 16, top: 12, bottom: 44 };
const kReach = 14; // reach from a point to the pointer [pixels]

/** The range of speeds, or of other values, that plots show together. */
class SpeedRange {
  constructor(speeds) {
    const [low, high] = [Math.min(...speeds), Math.max(...speeds)];
    this.full = [low - 0.02 * (high - low), high + 0.02 * (high - low)];
    this.view = [...this.full];
  }
  show(low, high) {
    this.view = within([low, high], this.full);
  }
  get isWhole() {
    return this.view[0] <= this.full[0] && this.view[1] >= this.full[1];
  }
}

/** A range moved, and where it must be shortened, to lie within another, and no shorter than 1e-4 of it. */
function within([low, high], [first, last]) {
  const length = Math.min(Math.max(high - low, 1e-4 * (last - first)), last - first);
  const begin = Math.min(Math.max(low, first), last - length);
  return [begin, begin + length];
}

class SpeedPlot {
  /** what: {valueOf(mode), harmonics, shown: the range of values shown at first, critical: a speed to mark}. */
  constructor(canvas, choice, range, what, say) {
    Object.assign(this, { canvas, choice, range, ...what, say, drag: null });
    this.speeds = choice.states.map(({ value }) => value);
    this.full = this.findRange();
    this.view = what.shown ? within(what.shown, this.full) : [...this.full];
    this.first = [...this.view];
    this.followPointer();
    canvas.addEventListener('keydown', (event) => this.followKey(event));
    canvas.addEventListener('focus', () => this.draw());
    canvas.addEventListener('blur', () => this.draw());
    choice.listen(() => this.draw());
    new ResizeObserver(() => this.draw()).observe(canvas);
  }
  findRange() {
    const followed = this.choice.branches.flatMap((_, b) => this.speeds.map((_, k) => this.choice.modeOf(b, k)));
    const values = followed.filter((mode) => mode).map((mode) => this.valueOf(mode));
    const low = Math.min(0, ...values);
    const high = Math.max(low === 0 ? 1e-12 : low, ...values);
    const margin = 0.04 * (high - low);
    return [low < 0 ? low - margin : 0, high + margin];
  }

  // Geometry

  layout(width, height) {
    this.area = { left: kFrame.left, top: kFrame.top, width: Math.max(1, width - kFrame.left - kFrame.right), height: Math.max(1, height - kFrame.top - kFrame.bottom) };
  }
  x(speed) {
    const [a, b] = this.range.view;
    return this.area.left + ((speed - a) / (b - a)) * this.area.width;
  }
  y(value) {
    const [a, b] = this.view;
    return this.area.top + (1 - (value - a) / (b - a)) * this.area.height;
  }
  speedOf(x) {
    const [a, b] = this.range.view;
    return a + ((x - this.area.left) / this.area.width) * (b - a);
  }
  valueAt(y) {
    const [a, b] = this.view;
    return a + (1 - (y - this.area.top) / this.area.height) * (b - a);
  }
  /** The point of a shown branch that is nearest to a place, if one is near. */
  nearest({ x, y }) {
    let best = null;
    let least = kReach ** 2;
    this.eachPoint((branch, speed, px, py) => {
      const distance = (px - x) ** 2 + (py - y) ** 2;
      if (distance < least) [least, best] = [distance, { branch, speed }];
    });
    return best;
  }
  eachPoint(visit) {
    this.choice.branches.forEach(({ isShown }, b) => {
      if (!isShown) return;
      this.speeds.forEach((speed, k) => {
        const mode = this.choice.modeOf(b, k);
        if (mode) visit(b, k, this.x(speed), this.y(this.valueOf(mode)), mode);
      });
    });
  }

  // Zoom

  show(speeds, values) {
    this.range.show(...speeds);
    this.view = within(values, this.full);
    this.choice.changed();
  }
  reset() {
    this.show(this.range.full, this.first);
  }
  showAll() {
    this.show(this.range.full, this.full);
  }
  zoom(factor, speed, value) {
    const about = (centre, [a, b]) => [centre - (centre - a) * factor, centre + (b - centre) * factor];
    this.show(about(speed, this.range.view), about(value, this.view));
  }
  get isZoomed() {
    return !this.range.isWhole || this.view[0] !== this.first[0] || this.view[1] !== this.first[1];
  }

  // Drawing

  draw() {
    const { context, width, height } = prepareCanvas(this.canvas);
    this.layout(width, height);
    const { left, top, width: w, height: h } = this.area;
    this.drawScales(context);
    context.save();
    context.beginPath();
    context.rect(left, top, w, h);
    context.clip();
    for (let n = 1; n <= (this.harmonics ?? 0); ++n) this.drawHarmonic(context, n);
    this.drawCritical(context);
    this.drawBranches(context);
    this.drawDrag(context);
    context.restore();
    this.drawRing(context, this.choice.branch, this.choice.speed, 7);
    if (this.choice.hovered) this.drawRing(context, this.choice.hovered.branch, this.choice.hovered.speed, 5);
  }
  drawScales(context) {
    const { left, top, width, height } = this.area;
    context.font = '12px system-ui, sans-serif';
    context.lineWidth = 1;
    context.strokeStyle = colorOf('--rule');
    context.fillStyle = colorOf('--soft');
    const labels = ([low, high], most) => {
      const { ticks, step } = roundTicks(low, high, most);
      return ticks.map((tick) => ({ tick, text: numberText(Math.abs(tick) < 1e-9 * step ? 0 : Number(tick.toPrecision(9))) }));
    };
    context.textAlign = 'center';
    context.textBaseline = 'top';
    for (const { tick, text } of labels(this.range.view, width / 80)) {
      strokeLine(context, [[this.x(tick), top], [this.x(tick), top + height]]);
      context.fillText(text, this.x(tick), top + height + 6);
    }
    context.textAlign = 'right';
    context.textBaseline = 'middle';
    for (const { tick, text } of labels(this.view, height / 40)) {
      strokeLine(context, [[left, this.y(tick)], [left + width, this.y(tick)]]);
      context.fillText(text, left - 7, this.y(tick));
    }
    context.strokeStyle = colorOf('--soft');
    context.strokeRect(left, top, width, height);
    context.textAlign = 'center';
    context.textBaseline = 'bottom';
    context.fillStyle = colorOf('--ink');
    context.fillText(this.choice.axis, left + width / 2, top + height + kFrame.bottom - 2);
  }
  /** A line n times per revolution, its number where it leaves the picture. */
  drawHarmonic(context, n) {
    const [a, b] = this.range.view;
    const valueAt = (speed) => (n * Math.abs(speed)) / (2 * Math.PI);
    context.strokeStyle = colorOf('--soft');
    context.lineWidth = 1;
    context.setLineDash([7, 5]);
    context.beginPath();
    for (const speed of [a, Math.min(Math.max(0, a), b), b]) context.lineTo(this.x(speed), this.y(valueAt(speed)));
    context.stroke();
    context.setLineDash([]);
    const end = Math.min(b, (2 * Math.PI * this.view[1]) / n);
    if (end <= a) return;
    context.fillStyle = colorOf('--soft');
    context.textAlign = 'right';
    context.textBaseline = 'bottom';
    context.fillText(`${n}/rev`, this.x(end) - 4, Math.max(this.y(valueAt(end)), this.area.top + 16));
  }
  drawCritical(context) {
    if (this.critical === undefined) return;
    const [x, { top, height }] = [this.x(this.critical), this.area];
    context.strokeStyle = colorOf('--bad');
    context.lineWidth = 1.5;
    strokeLine(context, [[x, top], [x, top + height]]);
  }
  drawBranches(context) {
    this.choice.branches.forEach((branch, b) => {
      if (!branch.isShown) return;
      context.strokeStyle = seriesColor(branch.color);
      context.lineWidth = b === this.choice.branch ? 3 : 1.75;
      context.setLineDash(dashesOf(branch.color));
      context.beginPath();
      this.speeds.forEach((speed, k) => {
        const mode = this.choice.modeOf(b, k);
        if (mode) context.lineTo(this.x(speed), this.y(this.valueOf(mode)));
      });
      context.stroke();
      context.setLineDash([]);
    });
    this.eachPoint((b, k, x, y, mode) => {
      context.beginPath();
      context.arc(x, y, mode.grows ? 4.5 : 2.6, 0, 2 * Math.PI);
      context.fillStyle = mode.grows ? colorOf('--bad') : seriesColor(this.choice.branches[b].color);
      context.fill();
    });
  }
  drawRing(context, branch, k, radius) {
    const mode = this.choice.modeOf(branch, k);
    if (!mode) return;
    const [x, y] = [this.x(this.speeds[k]), this.y(this.valueOf(mode))];
    const { left, top, width, height } = this.area;
    if (x < left - 1 || x > left + width + 1 || y < top - 1 || y > top + height + 1) return;
    context.strokeStyle = colorOf('--ink');
    context.lineWidth = document.activeElement === this.canvas ? 3 : 2;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.stroke();
  }
  drawDrag(context) {
    if (!this.drag?.isZoom) return;
    const { from, to } = this.drag;
    context.fillStyle = colorOf('--s0');
    context.globalAlpha = 0.14;
    context.fillRect(from.x, from.y, to.x - from.x, to.y - from.y);
    context.globalAlpha = 1;
  }

  // Pointer and keyboard

  place(event) {
    const box = this.canvas.getBoundingClientRect();
    const { left, top, width, height } = this.area;
    const clamp = (v, low, length) => Math.min(Math.max(v, low), low + length);
    return { x: clamp(event.clientX - box.left, left, width), y: clamp(event.clientY - box.top, top, height) };
  }
  followPointer() {
    const on = (name, handle, options) => this.canvas.addEventListener(name, handle, options);
    on('pointerdown', (event) => {
      if (event.button !== 0) return;
      const at = this.place(event);
      this.drag = { from: at, to: at, isZoom: false };
      this.canvas.setPointerCapture(event.pointerId);
    });
    on('pointermove', (event) => this.move(event));
    on('pointerup', () => this.endDrag());
    on('pointercancel', () => (this.drag = null));
    on('pointerleave', () => this.drag || this.choice.hover(null));
    on('dblclick', () => this.reset());
    on('wheel', (event) => this.roll(event), { passive: false });
  }
  move(event) {
    const at = this.place(event);
    if (!this.drag) {
      this.choice.hover(this.nearest(at));
      return;
    }
    this.drag.to = at;
    this.drag.isZoom ||= Math.hypot(at.x - this.drag.from.x, at.y - this.drag.from.y) > 6;
    this.draw();
  }
  endDrag() {
    const { drag } = this;
    this.drag = null;
    if (!drag) return;
    if (!drag.isZoom) {
      const found = this.nearest(drag.to);
      if (found) this.choice.choose(found.branch, found.speed);
      return;
    }
    const sorted = (a, b) => (a < b ? [a, b] : [b, a]);
    this.show(sorted(this.speedOf(drag.from.x), this.speedOf(drag.to.x)), sorted(this.valueAt(drag.from.y), this.valueAt(drag.to.y)));
  }
  /** The wheel zooms once the plot has the focus, so that it scrolls the page otherwise. */
  roll(event) {
    if (document.activeElement !== this.canvas && !event.ctrlKey) return;
    event.preventDefault();
    const { x, y } = this.place(event);
    this.zoom(Math.exp(0.0015 * event.deltaY), this.speedOf(x), this.valueAt(y));
  }
  followKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { choice } = this;
    const about = () => {
      const { mode } = choice;
      return mode ? [this.speeds[choice.speed], this.valueOf(mode)] : [0.5 * (this.range.view[0] + this.range.view[1]), 0.5 * (this.view[0] + this.view[1])];
    };
    const actions = {
      ArrowLeft: () => choice.step(-1, 0),
      ArrowRight: () => choice.step(1, 0),
      ArrowUp: () => choice.step(0, 1),
      ArrowDown: () => choice.step(0, -1),
      '+': () => this.zoom(0.7, ...about()),
      '=': () => this.zoom(0.7, ...about()),
      '-': () => this.zoom(1 / 0.7, ...about()),
      0: () => this.reset(),
      Escape: () => this.reset(),
    };
    if (!actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
    this.say(choice.describe(choice.branch, choice.speed));
  }
}
