// The page of a study: parallel coordinates and a scatter plot with brushes that both share. Uses
// page_tools.js, run_table.js and parallel_plot.js.

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
  // A margin within the frame keeps points off it.
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
    context.textAlign = 'center';
    context.textBaseline = 'top';
    for (const { value, text } of this.ticks(this.across, (this.right - this.left) / 90)) {
      strokeLine(context, [[this.x(value), this.top], [this.x(value), this.bottom]]);
      context.fillText(text, this.x(value), this.bottom + 6);
    }
    context.textAlign = 'right';
    context.textBaseline = 'middle';
    for (const { value, text } of this.ticks(this.up, 7)) {
      strokeLine(context, [[this.left, this.y(value)], [this.right, this.y(value)]]);
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
