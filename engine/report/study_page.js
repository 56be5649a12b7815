// The page of a study: parallel coordinates and a scatter plot with brushes that both share. Uses
// page_tools.js and run_table.js.

const kFaint = 0.12;
const kMostColors = 400; // colours are looked up once for each of so many runs

/** Colours of all runs, once for a drawing. */
function runColors(table) {
  const cache = new Map();
  return table.runs.map((_, i) => {
    const value = table.color.values[i];
    const key = Number.isFinite(value) ? Math.round(kMostColors * table.color.share(value)) : 'none';
    if (!cache.has(key)) cache.set(key, table.colorAt(i));
    return cache.get(key);
  });
}

/** Calls `draw` at the next picture, however often it is asked for. */
function drawnSoon(draw) {
  let isDue = false;
  return () => {
    if (isDue) return;
    isDue = true;
    requestAnimationFrame(() => {
      isDue = false;
      draw();
    });
  };
}

function place(canvas, event) {
  const box = canvas.getBoundingClientRect();
  return { x: event.clientX - box.left, y: event.clientY - box.top };
}

/** As much of a text as fits into a width. */
function fitted(context, text, width) {
  if (context.measureText(text).width <= width) return text;
  let end = text.length;
  while (end > 1 && context.measureText(`${text.slice(0, end)}\u2026`).width > width) --end;
  return `${text.slice(0, end)}\u2026`;
}

/** One axis for each column, one line for each run. Drag along an axis to brush it. */
class ParallelPlot {
  constructor(canvas, table, say) {
    Object.assign(this, { canvas, table, say, axis: 0, drag: null });
    this.redraw = drawnSoon(() => this.draw());
    table.listen(this.redraw);
    canvas.addEventListener('pointerdown', (event) => this.begin(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.end(event));
    canvas.addEventListener('dblclick', () => table.clear());
    canvas.addEventListener('keydown', (event) => this.key(event));
    canvas.addEventListener('focus', this.redraw);
    canvas.addEventListener('blur', this.redraw);
    new ResizeObserver(this.redraw).observe(canvas);
  }
  layout() {
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    const count = this.table.columns.length;
    this.gap = count > 1 ? (width - 150) / (count - 1) : 0;
    this.left = count > 1 ? 75 : width / 2;
    this.top = 46;
    this.bottom = height - 26;
  }
  x(k) {
    return this.left + k * this.gap;
  }
  y(column, value) {
    return this.bottom - column.share(value) * (this.bottom - this.top);
  }
  axisAt(x) {
    const k = this.gap > 0 ? Math.round((x - this.left) / this.gap) : 0;
    return Math.min(Math.max(k, 0), this.table.columns.length - 1);
  }
  valueAt(column, y) {
    const share = (this.bottom - y) / (this.bottom - this.top);
    return column.valueAt(Math.min(Math.max(share, 0), 1));
  }

  begin(event) {
    const { x, y } = place(this.canvas, event);
    this.axis = this.axisAt(x);
    this.drag = { y, column: this.table.columns[this.axis] };
    this.canvas.setPointerCapture(event.pointerId);
  }
  move(event) {
    if (!this.drag) return;
    const { y } = place(this.canvas, event);
    if (Math.abs(y - this.drag.y) < 4) return;
    const ends = [this.drag.y, y].map((at) => this.valueAt(this.drag.column, at)).sort((a, b) => a - b);
    this.table.brush(this.drag.column, ends);
  }
  end(event) {
    if (this.drag && Math.abs(place(this.canvas, event).y - this.drag.y) < 4) this.table.brush(this.drag.column, null);
    this.drag = null;
  }
  /** Arrows go from axis to axis and move its brush; + and - make it larger and smaller; 0 clears. */
  key(event) {
    const { table } = this;
    const column = table.columns[this.axis];
    const step = 0.05 * (column.high - column.low);
    const [low, high] = table.brushes.get(column) ?? [column.valueAt(0.5), column.high];
    const brush = (from, to) => {
      if (to - from > 1e-9 * step) table.brush(column, [Math.max(from, column.low), Math.min(to, column.high)]);
    };
    const last = table.columns.length - 1;
    const actions = {
      ArrowLeft: () => (this.axis = Math.max(this.axis - 1, 0)),
      ArrowRight: () => (this.axis = Math.min(this.axis + 1, last)),
      ArrowUp: () => brush(low + step, high + step),
      ArrowDown: () => brush(low - step, high - step),
      Enter: () => table.brush(column, table.brushes.has(column) ? null : [low, high]),
      '+': () => brush(low - step, high + step),
      '-': () => brush(low + step, high - step),
      0: () => table.clear(),
    };
    if (!actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
    this.redraw();
    this.tell();
  }
  tell() {
    const column = this.table.columns[this.axis];
    const brush = this.table.brushes.get(column);
    const text = brush ? `${column.text(brush[0])} to ${column.text(brush[1])}` : 'all values';
    this.say(`${column.title}: ${text}, ${this.table.count} of ${this.table.runs.length} runs`);
  }

  draw() {
    this.layout();
    const { context } = prepareCanvas(this.canvas);
    const colors = runColors(this.table);
    for (const isSelected of [false, true])
      this.table.runs.forEach((_, i) => {
        if (this.table.selected[i] === isSelected) this.drawRun(context, i, colors[i], isSelected ? 0.55 : kFaint / 2);
      });
    for (const i of [this.table.hovered, this.table.chosen])
      if (i !== null) this.drawRun(context, i, colorOf('--ink'), 1, 2.5);
    context.globalAlpha = 1;
    this.table.columns.forEach((column, k) => this.drawAxis(context, column, k));
  }
  drawRun(context, i, color, alpha, width = 1) {
    context.globalAlpha = alpha;
    context.strokeStyle = color;
    context.lineWidth = width;
    context.beginPath();
    let isDown = false;
    this.table.columns.forEach((column, k) => {
      const value = column.values[i];
      if (!Number.isFinite(value)) isDown = false;
      else if (isDown) context.lineTo(this.x(k), this.y(column, value));
      else context.moveTo(this.x(k), this.y(column, value));
      isDown ||= Number.isFinite(value);
    });
    context.stroke();
  }
  drawAxis(context, column, k) {
    const x = this.x(k);
    const isFocused = k === this.axis && document.activeElement === this.canvas;
    context.strokeStyle = colorOf(isFocused ? '--s0' : '--soft');
    context.lineWidth = isFocused ? 2.5 : 1;
    context.beginPath();
    context.moveTo(x, this.top);
    context.lineTo(x, this.bottom);
    context.stroke();
    const brush = this.table.brushes.get(column);
    if (brush) {
      const [low, high] = brush.map((value) => this.y(column, value));
      context.fillStyle = colorOf('--s0');
      context.globalAlpha = 0.3;
      context.fillRect(x - 7, high, 14, low - high);
      context.globalAlpha = 1;
      context.strokeRect(x - 7, high, 14, low - high);
    }
    context.textAlign = 'center';
    context.textBaseline = 'alphabetic';
    context.font = '600 12px system-ui, sans-serif';
    context.fillStyle = colorOf('--ink');
    // Neighbours' names stand in two rows.
    const title = fitted(context, column.title, Math.max(2 * this.gap - 16, 120));
    const half = 0.5 * context.measureText(title).width + 1;
    context.fillText(title, Math.min(Math.max(x, half), this.canvas.clientWidth - half), k % 2 === 0 ? 12 : 28);
    context.font = '11px system-ui, sans-serif';
    context.fillStyle = colorOf('--soft');
    context.fillText(column.text(column.high), x, this.top - 5);
    context.fillText(column.text(column.low), x, this.bottom + 14);
  }
}

/** One column over another, one point for each run. Drag a rectangle to brush both columns. */
class ScatterPlot {
  constructor(canvas, table, say) {
    Object.assign(this, { canvas, table, say, drag: null, corner: null });
    [this.across] = table.parameters;
    this.up = table.responses[0] ?? table.columns.at(-1);
    this.redraw = drawnSoon(() => this.draw());
    table.listen(this.redraw);
    canvas.addEventListener('pointerdown', (event) => this.begin(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.end(event));
    canvas.addEventListener('pointerleave', () => table.hover(null));
    canvas.addEventListener('dblclick', () => table.clear());
    canvas.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(this.redraw).observe(canvas);
  }
  layout() {
    this.left = 78;
    this.right = this.canvas.clientWidth - 16;
    this.top = 12;
    this.bottom = this.canvas.clientHeight - 46;
  }
  // A margin within the frame, so that no point lies on it.
  x(value) {
    return this.left + (0.02 + 0.96 * this.across.share(value)) * (this.right - this.left);
  }
  y(value) {
    return this.bottom - (0.03 + 0.94 * this.up.share(value)) * (this.bottom - this.top);
  }
  valueAcross(x) {
    return this.across.valueAt(((x - this.left) / (this.right - this.left) - 0.02) / 0.96);
  }
  valueUp(y) {
    return this.up.valueAt(((this.bottom - y) / (this.bottom - this.top) - 0.03) / 0.94);
  }
  /** The run whose point is nearest, within some pixels. */
  nearest({ x, y }) {
    let best = null;
    let least = 12 ** 2;
    this.table.runs.forEach((_, i) => {
      const distance = (this.x(this.across.values[i]) - x) ** 2 + (this.y(this.up.values[i]) - y) ** 2;
      if (!(distance < least)) return;
      least = distance;
      best = i;
    });
    return best;
  }

  begin(event) {
    this.drag = place(this.canvas, event);
    this.canvas.setPointerCapture(event.pointerId);
  }
  move(event) {
    const at = place(this.canvas, event);
    if (!this.drag) {
      this.table.hover(this.nearest(at));
      return;
    }
    if (Math.hypot(at.x - this.drag.x, at.y - this.drag.y) < 4) return;
    const sorted = (a, b) => (a < b ? [a, b] : [b, a]);
    this.table.brushes.set(this.across, sorted(this.valueAcross(this.drag.x), this.valueAcross(at.x)));
    this.table.brush(this.up, sorted(this.valueUp(this.drag.y), this.valueUp(at.y)));
  }
  end(event) {
    const at = place(this.canvas, event);
    if (this.drag && Math.hypot(at.x - this.drag.x, at.y - this.drag.y) < 4) {
      const found = this.nearest(at);
      if (found !== null) this.table.choose(found);
    }
    this.drag = null;
  }
  /** Arrows go through the selected runs in the order of the column across. */
  key(event) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (event.key === '0') this.table.clear();
    if (!step) return;
    event.preventDefault();
    const { table } = this;
    const order = table.runs.map((_, i) => i).filter((i) => table.selected[i] && Number.isFinite(this.up.values[i]));
    order.sort((a, b) => this.across.values[a] - this.across.values[b]);
    if (order.length === 0) return;
    const at = order.indexOf(table.chosen);
    table.choose(order[at < 0 ? 0 : (at + step + order.length) % order.length]);
    this.say(describeRun(table, table.chosen));
  }

  draw() {
    this.layout();
    const { context } = prepareCanvas(this.canvas);
    this.drawAxes(context);
    const colors = runColors(this.table);
    for (const isSelected of [false, true])
      this.table.runs.forEach((_, i) => {
        if (this.table.selected[i] === isSelected) this.drawPoint(context, i, colors[i], isSelected ? 0.85 : kFaint, 3.2);
      });
    for (const i of [this.table.hovered, this.table.chosen])
      if (i !== null) this.drawPoint(context, i, colorOf('--ink'), 1, 5.5);
    context.globalAlpha = 1;
    this.drawBrush(context);
  }
  drawPoint(context, i, color, alpha, radius) {
    const [across, up] = [this.across.values[i], this.up.values[i]];
    if (!Number.isFinite(across) || !Number.isFinite(up)) return;
    context.globalAlpha = alpha;
    context.fillStyle = color;
    context.beginPath();
    context.arc(this.x(across), this.y(up), radius, 0, 2 * Math.PI);
    context.fill();
  }
  drawBrush(context) {
    const across = this.table.brushes.get(this.across);
    const up = this.table.brushes.get(this.up);
    if (!across && !up) return;
    const [x0, x1] = across ? across.map((value) => this.x(value)) : [this.left, this.right];
    const [y0, y1] = up ? up.map((value) => this.y(value)) : [this.bottom, this.top];
    context.strokeStyle = colorOf('--s0');
    context.lineWidth = 1.5;
    context.strokeRect(x0, y1, x1 - x0, y0 - y1);
  }
  ticks(column, most) {
    if (column.choices) return column.choices.map((text, k) => ({ value: k, text }));
    const { ticks, step } = roundTicks(column.low, column.high, most);
    const text = (value) => numberText(Math.abs(value) < 1e-9 * step ? 0 : value).replace(/\.?0+e/, 'e');
    return ticks.map((value) => ({ value, text: text(value) }));
  }
  drawAxes(context) {
    context.font = '11.5px system-ui, sans-serif';
    context.strokeStyle = colorOf('--rule');
    context.fillStyle = colorOf('--soft');
    context.lineWidth = 1;
    const line = (x0, y0, x1, y1) => {
      context.beginPath();
      context.moveTo(x0, y0);
      context.lineTo(x1, y1);
      context.stroke();
    };
    context.textAlign = 'center';
    context.textBaseline = 'top';
    for (const { value, text } of this.ticks(this.across, (this.right - this.left) / 90)) {
      line(this.x(value), this.top, this.x(value), this.bottom);
      context.fillText(text, this.x(value), this.bottom + 6);
    }
    context.textAlign = 'right';
    context.textBaseline = 'middle';
    for (const { value, text } of this.ticks(this.up, 7)) {
      line(this.left, this.y(value), this.right, this.y(value));
      context.fillText(fitted(context, text, 52), this.left - 7, this.y(value));
    }
    context.strokeStyle = colorOf('--soft');
    context.strokeRect(this.left, this.top, this.right - this.left, this.bottom - this.top);
    context.fillStyle = colorOf('--ink');
    context.font = '600 12px system-ui, sans-serif';
    context.textAlign = 'center';
    context.textBaseline = 'bottom';
    context.fillText(this.across.title, (this.left + this.right) / 2, this.canvas.clientHeight - 4);
    context.save();
    context.translate(14, (this.top + this.bottom) / 2);
    context.rotate(-Math.PI / 2);
    context.textBaseline = 'middle';
    context.fillText(fitted(context, this.up.title, this.bottom - this.top), 0, 0);
    context.restore();
  }
}

function describeRun(table, i) {
  const values = table.columns.map((column) => `${column.name} ${column.text(column.values[i])} ${column.unit ?? ''}`.trim());
  return `Run ${table.runs[i]}: ${values.join(', ')}`;
}

/** Shows the values of the chosen run, else of the one below the pointer, and its command. */
function showRun(table) {
  const i = table.hovered ?? table.chosen;
  document.getElementById('run-values').textContent =
    i === null ? 'Point at a run to read its values, click to keep it.' : describeRun(table, i);
  const replay = document.getElementById('run-replay');
  replay.parentElement.hidden = table.chosen === null;
  if (table.chosen !== null) replay.textContent = table.replay(table.chosen);
}

function offer(id, columns, chosen, choose) {
  const select = document.getElementById(id);
  columns.forEach((column, k) => select.append(make('option', { value: String(k), textContent: column.title })));
  select.value = String(columns.indexOf(chosen));
  select.addEventListener('change', () => choose(columns[Number(select.value)]));
}

function startPage() {
  const table = new RunTable(JSON.parse(document.getElementById('study-data').textContent));
  const region = document.getElementById('spoken');
  const say = (text) => (region.textContent = text);
  const parallel = new ParallelPlot(document.getElementById('parallel'), table, say);
  const scatter = new ScatterPlot(document.getElementById('scatter'), table, say);
  offer('scatter-x', table.columns, scatter.across, (column) => {
    scatter.across = column;
    scatter.redraw();
  });
  offer('scatter-y', table.columns, scatter.up, (column) => {
    scatter.up = column;
    scatter.redraw();
  });
  offer('colors', table.columns, table.color, (column) => {
    table.color = column;
    table.changed();
  });
  const count = document.getElementById('runs-selected');
  const clear = document.getElementById('runs-clear');
  clear.addEventListener('click', () => table.clear());
  document.getElementById('run-copy').addEventListener('click', () =>
    navigator.clipboard?.writeText(document.getElementById('run-replay').textContent));
  table.listen(() => {
    count.textContent = `${table.count} of ${table.runs.length} runs`;
    clear.disabled = table.brushes.size === 0;
    showRun(table);
  });
  table.changed();
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    parallel.redraw();
    scatter.redraw();
  });
}

startPage();
