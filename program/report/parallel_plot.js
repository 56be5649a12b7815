// Parallel coordinates of runs, with brushes, and tools for all plots of runs. Uses page_tools.js
// and run_table.js.

const kFaint = 0.12;
const kMargin = 75; // room left and right of the axes, for their names [px]
const kLeastGap = 64; // least distance between axes [px]
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
    // Many axes, or a narrow window: the plot is scrolled rather than names drawn over one another.
    canvas.style.minWidth = `${2 * kMargin + kLeastGap * (table.columns.length - 1)}px`;
    new ResizeObserver(this.redraw).observe(canvas);
  }
  layout() {
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    const count = this.table.columns.length;
    this.gap = count > 1 ? (width - 2 * kMargin) / (count - 1) : 0;
    this.left = count > 1 ? kMargin : width / 2;
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
    const frame = this.canvas.parentElement;
    frame.scrollLeft = this.x(this.axis) - 0.5 * frame.clientWidth;
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
    const title = fitted(context, column.title, Math.max(2 * this.gap, 2 * kLeastGap) - 16);
    const half = 0.5 * context.measureText(title).width + 1;
    context.fillText(title, Math.min(Math.max(x, half), this.canvas.clientWidth - half), k % 2 === 0 ? 12 : 28);
    context.font = '11px system-ui, sans-serif';
    context.fillStyle = colorOf('--soft');
    context.fillText(column.text(column.high), x, this.top - 5);
    context.fillText(column.text(column.low), x, this.bottom + 14);
  }
}
