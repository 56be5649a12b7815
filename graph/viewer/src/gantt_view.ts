// The Gantt chart of one recording's threads around the chosen step.
import { firstEndingAfter, StepAnalysis } from './analysis';
import { Bracket, lines, passBrackets, stepBrackets } from './brackets';
import { percent, time } from './format';
import { arrowHead, fitting, Layers, onDrag } from './layers';
import { Palette, Paint } from './palette';
import { Recording } from './recording';
import { Picked, State } from './state';
import { tickStep } from './ticks';
import { TimeWindow } from './time_window';

const kAxis = 22;
const kLine = 15;
const kGap = 6;
const kMostRow = 110;
const kMostTrack = 130;
const kRightMargin = 10;
const kKeys = 'Left and right walk along a thread, up and down change it, plus and minus zoom, 0 fits, shift and arrows pan, escape clears.';

export class GanttView extends Layers {
  private step = 0;
  private analysis: StepAnalysis | null = null;
  private steps: Bracket[] = [];
  private passes: Bracket[] = [];
  private labels: string[][] = [];
  private labelled: Recording | null = null;

  constructor(
    host: HTMLElement, private readonly which: number, private readonly state: State,
    private readonly window: TimeWindow, private palette: Palette,
  ) {
    super(host, 'Gantt chart of the threads', kKeys);
    onDrag(this.canvas, (dx) => window.pan(-dx / this.chartWidth), (x, y) => this.click(x, y));
    window.onChange(() => this.redraw());
    this.canvas.addEventListener('pointermove', (event) => this.point(event));
    this.canvas.addEventListener('pointerleave', () => state.hover(null));
    this.canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    this.canvas.addEventListener('dblclick', () => window.fit());
    this.canvas.addEventListener('keydown', (event) => this.key(event));
  }

  private get recording(): Recording | undefined {
    return this.state.recordings[this.which];
  }
  private get chartLeft(): number {
    return this.width > 420 ? 92 : 58;
  }
  private get chartWidth(): number {
    return Math.max(1, this.width - this.chartLeft - kRightMargin);
  }
  private get scale(): number {
    return this.chartWidth / (this.window.to - this.window.from);
  }
  private get chartTop(): number {
    return kAxis + (lines(this.steps) + lines(this.passes)) * kLine + 6;
  }
  private get rowHeight(): number {
    const threads = this.recording?.trace.threads.length ?? 1;
    return Math.max(3, Math.min(kMostRow + kGap, (this.height - this.chartTop - 6) / (threads + 0.9)));
  }
  /** Height of the track of ready nodes below the threads; 0 = no room. */
  private get trackHeight(): number {
    const room = this.height - this.rowTop(this.recording?.trace.threads.length ?? 0) - 12;
    return room < 22 ? 0 : Math.min(kMostTrack, room);
  }
  private get barHeight(): number {
    return this.rowHeight > 14 ? this.rowHeight - kGap : this.rowHeight - 1;
  }

  usePalette(palette: Palette): void {
    this.palette = palette;
    this.redraw();
  }

  /** A new recording, step or pass. */
  refresh(): void {
    const { recording } = this;
    if (!recording) return;
    if (this.labelled !== recording) {
      this.labelled = recording;
      this.labels = [];
    }
    this.step = this.state.stepOf(this.which);
    this.steps = stepBrackets(recording, this.step);
    this.analysis = recording.analysis(this.step);
    this.passes = passBrackets(recording, this.step);
    this.redraw();
  }

  private x(us: number): number {
    return this.chartLeft + (us - (this.analysis?.begin ?? 0) - this.window.from) * this.scale;
  }
  private timeAt(x: number): number {
    return (x - this.chartLeft) / this.scale + this.window.from + (this.analysis?.begin ?? 0);
  }
  private rowTop(thread: number): number {
    return this.chartTop + thread * this.rowHeight;
  }

  /** The middle of a slice on the canvas, in CSS pixels. */
  pointOf(slice: number): { x: number; y: number } {
    const { slices } = (this.recording as Recording).trace;
    const x = this.x(slices.begin[slice] + slices.duration[slice] / 2);
    return { x, y: this.rowTop(slices.thread[slice]) + this.barHeight / 2 };
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const sideways = event.shiftKey ? event.deltaY + event.deltaX : event.deltaX;
    if (Math.abs(sideways) > Math.abs(event.deltaY) || event.shiftKey) this.window.pan(sideways / this.chartWidth);
    else this.window.zoom(Math.exp(-event.deltaY * 0.0016), (event.offsetX - this.chartLeft) / this.chartWidth);
  }

  private sliceAt(x: number, y: number): number {
    const { recording } = this;
    if (!recording || x < this.chartLeft || y < this.chartTop) return -1;
    const thread = Math.floor((y - this.chartTop) / this.rowHeight);
    if (thread >= recording.trace.threads.length) return -1;
    const own = recording.ofThread(thread);
    const slack = 2 / this.scale;
    const at = this.timeAt(x);
    let best = -1;
    let distance = slack;
    for (let k = firstEndingAfter(recording, own, at - slack); k < own.length; ++k) {
      const begin = recording.trace.slices.begin[own[k]];
      if (begin > at + slack) break;
      const off = Math.max(begin - at, at - recording.end(own[k]), 0);
      if (off < distance) [best, distance] = [own[k], off];
    }
    return best;
  }

  private point(event: PointerEvent): void {
    if (event.buttons !== 0) return;
    const slice = this.sliceAt(event.offsetX, event.offsetY);
    this.canvas.classList.toggle('over', slice >= 0 || this.stepAt(event.offsetX, event.offsetY) >= 0);
    this.canvas.dataset.hint = slice >= 0 ? this.hint(slice) : '';
    const picked = this.pickedOf(slice);
    this.state.hover(picked);
  }

  /** What a pointer on a slice is told. */
  private hint(slice: number): string {
    const { trace } = this.recording as Recording;
    const { slices, graph } = trace;
    const step = slices.step[slice];
    const where = step < 0 ? 'surplus pass' : `step ${trace.steps[step].number}, pass ${slices.pass[slice] + 1}`;
    return `${graph.name[slices.node[slice]]}\n${time(slices.duration[slice])} on ${trace.threads[slices.thread[slice]]}, ${where}`;
  }

  /** The node of a slice of the chosen step, in the active recording. */
  private pickedOf(slice: number): Picked | null {
    const { recording } = this;
    if (slice < 0 || !recording || recording.trace.slices.step[slice] !== this.step) return null;
    const pass = recording.trace.slices.pass[slice];
    const node = recording.trace.slices.node[slice];
    if (this.which === this.state.active) return { node, pass };
    const same = this.state.recording.byName.get(recording.trace.graph.name[node]);
    return same === undefined ? null : { node: same, pass };
  }

  private stepAt(x: number, y: number): number {
    const line = Math.floor((y - kAxis) / kLine);
    const at = this.timeAt(x);
    if (x < this.chartLeft) return -1;
    return this.steps.find((step) => step.line === line && at >= step.begin && at <= step.end)?.number ?? -1;
  }

  private click(x: number, y: number): void {
    const step = this.stepAt(x, y);
    const slice = this.sliceAt(x, y);
    const { recording } = this;
    if (!recording) return;
    this.state.setActive(this.which);
    if (slice < 0 && step < 0) this.state.select(null);
    const owner = slice >= 0 ? recording.trace.slices.step[slice] : step;
    if (owner >= 0 && owner !== this.step) this.goTo(owner, slice);
    else if (slice >= 0 && owner >= 0) this.state.select(this.pickedOf(slice));
  }

  /** Chooses the step of another slice, without moving what is on the screen if it was zoomed. */
  private goTo(step: number, slice: number): void {
    const recording = this.recording as Recording;
    const first = this.state.recordings[0].trace.steps;
    const { number } = recording.trace.steps[step];
    const same = first.findIndex((other) => other.number === number);
    const by = recording.stepBegin[this.step] - recording.stepBegin[step];
    const { fitted, from, to } = this.window;
    this.state.setStep(same >= 0 ? same : step);
    if (!fitted) this.window.show(from + by, to + by, false);
    if (slice >= 0) this.state.select(this.pickedOf(slice));
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const pans: Record<string, number> = { ArrowLeft: -0.12, ArrowRight: 0.12 };
    if (event.shiftKey && event.key in pans) this.window.pan(pans[event.key]);
    else if (event.key.startsWith('Arrow')) this.walk(event.key);
    else if (event.key === '+' || event.key === '=') this.window.zoom(1.4, this.keyCentre());
    else if (event.key === '-') this.window.zoom(1 / 1.4, this.keyCentre());
    else if (event.key === '0') this.window.fit();
    else return;
    event.preventDefault();
  }

  /** Where keys zoom: at the selected slice, if it is seen. */
  private keyCentre(): number {
    const slice = this.selectedSlice();
    const at = slice < 0 ? 0.5 : (this.pointOf(slice).x - this.chartLeft) / this.chartWidth;
    return at >= 0 && at <= 1 ? at : 0.5;
  }

  private selectedSlice(): number {
    const { recording } = this;
    if (!recording || this.which !== this.state.active || !this.state.selected) return -1;
    const { node, pass } = this.state.selected;
    return recording.slicesOfNode(node, this.step, pass)[0] ?? -1;
  }

  private walk(key: string): void {
    const recording = this.recording as Recording;
    const { slices, threads } = recording.trace;
    this.state.setActive(this.which);
    const at = this.selectedSlice();
    let next = -1;
    if (at < 0) next = recording.ofStep(this.step)[0] ?? -1;
    else if (key === 'ArrowLeft' || key === 'ArrowRight') {
      const direction = key === 'ArrowRight' ? 1 : -1;
      const own = recording.ofThread(slices.thread[at]);
      for (let k = own.indexOf(at) + direction; k >= 0 && k < own.length && next < 0; k += direction) {
        if (slices.step[own[k]] === this.step) next = own[k];
      }
    } else {
      const thread = slices.thread[at] + (key === 'ArrowDown' ? 1 : -1);
      if (thread >= 0 && thread < threads.length) next = this.nearestOn(thread, slices.begin[at]);
    }
    if (next < 0) return;
    this.state.select(this.pickedOf(next));
  }

  private nearestOn(thread: number, begin: number): number {
    const { trace } = this.recording as Recording;
    let best = -1;
    for (const slice of (this.recording as Recording).ofThread(thread)) {
      if (trace.slices.step[slice] !== this.step) continue;
      const distance = Math.abs(trace.slices.begin[slice] - begin);
      if (best < 0 || distance < Math.abs(trace.slices.begin[best] - begin)) best = slice;
    }
    return best;
  }

  /** Moves the shown time if all slices of a node are outside of it. */
  reveal({ node, pass }: Picked): void {
    const { recording } = this;
    const origin = this.analysis?.begin ?? 0;
    const found = recording?.slicesOfNode(node, this.step, pass) ?? [];
    if (!recording || found.length === 0) return;
    const places = found.map((slice) => [recording.trace.slices.begin[slice] - origin, recording.end(slice) - origin]);
    const isShown = ([begin, end]: number[]) => end > this.window.from && begin < this.window.to;
    if (!places.some(isShown)) this.window.reveal(places[0][0], places[0][1]);
  }

  protected drawBase(context: CanvasRenderingContext2D): void {
    const { recording, analysis } = this;
    if (!recording || !analysis) return;
    this.drawAxis(context);
    context.save();
    context.beginPath();
    context.rect(this.chartLeft, 0, this.chartWidth, this.height);
    context.clip();
    this.drawStepGround(context, analysis);
    for (let thread = 0; thread < recording.trace.threads.length; ++thread) {
      this.drawIdle(context, analysis, thread);
      this.drawSlices(context, recording, analysis, thread);
    }
    if (this.state.showCritical) this.drawCritical(context, recording, analysis);
    this.drawWaiting(context, analysis);
    this.drawBrackets(context, recording);
    context.restore();
    this.drawThreadNames(context, recording, analysis);
  }

  private drawAxis(context: CanvasRenderingContext2D): void {
    const { theme } = this.palette;
    const step = tickStep(1 / this.scale, 74);
    const bottom = this.rowTop(this.recording?.trace.threads.length ?? 0) + (this.trackHeight > 0 ? this.trackHeight + 6 : 0);
    context.font = `11px ${theme.font}`;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.strokeStyle = theme.rule;
    context.lineWidth = 1;
    const largest = Math.max(Math.abs(this.window.from), Math.abs(this.window.to));
    const [unit, name] = largest >= 1e6 ? [1e6, 's'] : largest >= 1e4 ? [1e3, 'ms'] : [1, 'µs'];
    const digits = Math.max(0, -Math.floor(Math.log10(step / unit) + 1e-9));
    for (let k = Math.ceil(this.window.from / step); k * step <= this.window.to; ++k) {
      const x = Math.round(this.chartLeft + (k * step - this.window.from) * this.scale) + 0.5;
      context.beginPath();
      context.moveTo(x, kAxis - 4);
      context.lineTo(x, bottom);
      context.stroke();
      context.fillStyle = theme.soft;
      const text = ((k * step) / unit).toFixed(digits).replace('-', '−');
      if (x < this.width - 18) context.fillText(text, x, kAxis / 2);
    }
    context.textAlign = 'right';
    context.fillStyle = theme.soft;
    context.fillText(name, this.chartLeft - 8, kAxis / 2);
  }

  private drawStepGround(context: CanvasRenderingContext2D, analysis: StepAnalysis): void {
    const { theme } = this.palette;
    const [left, right] = [this.x(analysis.begin), this.x(analysis.end)];
    const bottom = this.rowTop(analysis.threads.length);
    context.fillStyle = theme.panel;
    context.fillRect(left, this.chartTop - 3, right - left, bottom - this.chartTop + 3);
    context.strokeStyle = theme.soft;
    context.lineWidth = 1;
    context.setLineDash([3, 3]);
    for (const x of [left, right]) {
      context.beginPath();
      context.moveTo(Math.round(x) + 0.5, this.chartTop - 3);
      context.lineTo(Math.round(x) + 0.5, bottom);
      context.stroke();
    }
    context.setLineDash([]);
  }

  /** Idle time: a thin line where nothing was ready, a tinted ground where a ready node waited. */
  private drawIdle(context: CanvasRenderingContext2D, analysis: StepAnalysis, thread: number): void {
    const { theme } = this.palette;
    const top = this.rowTop(thread);
    const height = this.barHeight;
    for (const segment of analysis.threads[thread].idle) {
      const [left, right] = [this.x(segment.begin), this.x(segment.end)];
      if (right < this.chartLeft || left > this.width || right - left < 0.3) continue;
      context.fillStyle = segment.scheduler ? theme.waiting : theme.rule;
      if (segment.scheduler) context.fillRect(left, top, right - left, height);
      else context.fillRect(left, top + height / 2 - 1, right - left, 2);
    }
  }

  /** How many ready nodes waited for a thread, as a stepped area. */
  private drawWaiting(context: CanvasRenderingContext2D, analysis: StepAnalysis): void {
    const height = this.trackHeight;
    if (height === 0) return;
    const base = Math.round(this.rowTop(analysis.threads.length) + height + 4) + 0.5;
    const most = analysis.waiting.reduce((largest, { count }) => Math.max(largest, count), 1);
    const top = (count: number) => base - ((height - 6) * count) / most;
    context.beginPath();
    context.moveTo(this.x(analysis.begin), base);
    let level = 0;
    for (const { time: at, count } of analysis.waiting) {
      const x = this.x(at);
      context.lineTo(x, top(level));
      context.lineTo(x, top(count));
      level = count;
    }
    context.lineTo(this.x(analysis.end), top(level));
    context.lineTo(this.x(analysis.end), base);
    context.closePath();
    const { theme } = this.palette;
    context.fillStyle = theme.waiting;
    context.fill();
    context.strokeStyle = theme.soft;
    context.lineWidth = 0.75;
    context.stroke();
  }

  private drawWaitingName(context: CanvasRenderingContext2D, analysis: StepAnalysis): void {
    const height = this.trackHeight;
    if (height === 0) return;
    const { theme } = this.palette;
    const most = analysis.waiting.reduce((largest, { count }) => Math.max(largest, count), 0);
    const middle = this.rowTop(analysis.threads.length) + height / 2 + 4;
    const x = this.chartLeft - 10;
    context.textAlign = 'right';
    context.textBaseline = 'middle';
    context.fillStyle = theme.ink;
    context.font = `600 11px ${theme.font}`;
    context.fillText(fitting(['ready nodes', 'ready'], x, 11), x, height > 34 ? middle - 7 : middle);
    if (height <= 34) return;
    context.fillStyle = theme.soft;
    context.font = `11px ${theme.font}`;
    context.fillText(`up to ${most}`, x, middle + 8);
  }

  private isBright(recording: Recording, slice: number): boolean {
    const { slices } = recording.trace;
    if (slices.step[slice] !== this.step) return false;
    if (this.state.pass >= 0 && slices.pass[slice] !== this.state.pass) return false;
    return this.state.shows(recording, slices.node[slice]);
  }

  private drawSlices(context: CanvasRenderingContext2D, recording: Recording, analysis: StepAnalysis, thread: number): void {
    const { slices } = recording.trace;
    const own = recording.ofThread(thread);
    const until = this.timeAt(this.width - kRightMargin);
    const { scale } = this;
    const origin = analysis.begin;
    let k = firstEndingAfter(recording, own, this.timeAt(this.chartLeft));
    while (k < own.length && slices.begin[own[k]] < until) {
      if (slices.duration[own[k]] * scale >= 1.2) {
        this.drawSlice(context, recording, own[k]);
        ++k;
        continue;
      }
      // Slices too small to see share a column of the screen: the longest, of those that are not dimmed.
      const column = Math.floor((slices.begin[own[k]] - origin) * scale);
      let shown = own[k];
      let bright = this.isBright(recording, shown);
      for (++k; k < own.length; ++k) {
        const slice = own[k];
        if (slices.duration[slice] * scale >= 1.2 || Math.floor((slices.begin[slice] - origin) * scale) !== column) break;
        const isBright = this.isBright(recording, slice);
        if ((isBright && !bright) || (isBright === bright && slices.duration[slice] > slices.duration[shown])) {
          [shown, bright] = [slice, isBright];
        }
      }
      this.drawColumn(context, recording, shown, bright, thread);
    }
  }

  private drawColumn(context: CanvasRenderingContext2D, recording: Recording, slice: number, bright: boolean, thread: number): void {
    const { graph, slices, stages } = recording.trace;
    const stage = stages[graph.stage[slices.node[slice]]];
    context.fillStyle = bright ? this.palette.stage(stage).plain : this.palette.faint(stage);
    context.fillRect(this.x(slices.begin[slice]), this.rowTop(thread), 1.1, this.barHeight);
  }

  private drawSlice(context: CanvasRenderingContext2D, recording: Recording, slice: number): void {
    const { slices, graph, stages } = recording.trace;
    const left = this.x(slices.begin[slice]);
    const width = slices.duration[slice] * this.scale;
    const top = this.rowTop(slices.thread[slice]);
    const gap = width > 5 ? 0.7 : 0;
    const stage = stages[graph.stage[slices.node[slice]]];
    if (!this.isBright(recording, slice)) {
      context.fillStyle = this.palette.faint(stage, slices.step[slice] === this.step ? 0.86 : 0.78);
      context.fillRect(left, top, width - gap, this.barHeight);
      return;
    }
    const paint = this.palette.stage(stage);
    context.fillStyle = width > 4 ? paint.fill : paint.plain;
    context.fillRect(left, top, Math.max(1, width - gap), this.barHeight);
    if (width > 13 && this.barHeight >= 12) this.drawLabel(context, recording, slice, left, width, top, paint);
  }

  private labelsOf(recording: Recording, node: number): string[] {
    let labels = this.labels[node];
    if (!labels) {
      const { graph, stages } = recording.trace;
      const [blade, body] = [graph.subsystem[node], graph.body[node]];
      const stage = stages[graph.stage[node]];
      const place = blade < 0 ? '' : body < 0 ? `${blade + 1}` : `${blade + 1}.${body + 1}`;
      labels = [graph.name[node], place === '' ? stage : `${stage} ${place}`, place];
      this.labels[node] = labels;
    }
    return labels;
  }

  private drawLabel(
    context: CanvasRenderingContext2D, recording: Recording, slice: number, left: number, width: number, top: number, paint: Paint,
  ): void {
    const seenLeft = Math.max(left, this.chartLeft);
    const seenWidth = Math.min(left + width, this.width) - seenLeft;
    const text = fitting(this.labelsOf(recording, recording.trace.slices.node[slice]), seenWidth - 4, 11);
    if (text === '') return;
    context.font = `${paint.hatched ? 600 : 500} 11px ${this.palette.theme.font}`;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    const [x, y] = [seenLeft + seenWidth / 2, top + this.barHeight / 2];
    if (paint.hatched) {
      context.fillStyle = paint.plain;
      const room = context.measureText(text).width + 6;
      context.fillRect(x - room / 2, y - 7, room, 14);
    }
    context.fillStyle = paint.ink;
    context.fillText(text, x, y + 0.5);
  }

  private drawCritical(context: CanvasRenderingContext2D, recording: Recording, analysis: StepAnalysis): void {
    const { slices } = recording.trace;
    context.strokeStyle = context.fillStyle = this.palette.theme.ink;
    context.lineWidth = 1.2;
    let before = -1;
    for (const slice of analysis.critical) {
      const left = this.x(slices.begin[slice]);
      const top = this.rowTop(slices.thread[slice]);
      const bar = this.barHeight >= 12 ? 3.5 : 2;
      context.fillRect(left, top + this.barHeight - bar, Math.max(1.2, slices.duration[slice] * this.scale - 0.7), bar);
      if (before >= 0) {
        const from = { x: this.x(recording.end(before)), y: this.rowTop(slices.thread[before]) + this.barHeight - 1.5 };
        const to = { x: left, y: top + this.barHeight - 1.5 };
        if (to.x - from.x > 1 || Math.abs(to.y - from.y) > 1) {
          context.globalAlpha = 0.7;
          context.beginPath();
          context.moveTo(from.x, from.y);
          context.lineTo(to.x, to.y);
          context.stroke();
          context.globalAlpha = 1;
        }
      }
      before = slice;
    }
  }

  private drawBrackets(context: CanvasRenderingContext2D, recording: Recording): void {
    const { steps } = recording.trace;
    for (const step of this.steps) {
      const name = `step ${steps[step.number].number}`;
      this.drawBracket(context, step, kAxis + step.line * kLine, step.number === this.step, [name, String(steps[step.number].number)]);
    }
    const top = kAxis + lines(this.steps) * kLine + 1;
    for (const pass of this.passes) {
      const bright = this.state.pass < 0 || this.state.pass === pass.number;
      this.drawBracket(context, pass, top + pass.line * kLine, bright, [`pass ${pass.number + 1}`, String(pass.number + 1)], true);
    }
  }

  private drawBracket(
    context: CanvasRenderingContext2D, bracket: Bracket, top: number, bright: boolean, names: string[], light = false,
  ): void {
    const left = Math.max(this.x(bracket.begin), this.chartLeft - 2);
    const right = Math.min(this.x(bracket.end), this.width + 2);
    if (right - left < 0.5) return;
    const { theme } = this.palette;
    const width = Math.max(1, right - left - 1);
    context.globalAlpha = bright ? 1 : 0.45;
    context.beginPath();
    context.roundRect(left, top, width, kLine - 3, Math.min(3, width / 2));
    context.fillStyle = bright && !light ? theme.soft : theme.rule;
    context.fill();
    const text = fitting(names, width - 6, 11);
    if (text !== '') {
      context.font = `${bright ? 600 : 500} 10.5px ${theme.font}`;
      context.textAlign = 'center';
      context.textBaseline = 'middle';
      context.globalAlpha = bright ? 1 : 0.8;
      context.fillStyle = bright && !light ? theme.paper : theme.ink;
      context.fillText(text, left + width / 2, top + (kLine - 3) / 2 + 0.5);
    }
    context.globalAlpha = 1;
  }

  private drawThreadNames(context: CanvasRenderingContext2D, recording: Recording, analysis: StepAnalysis): void {
    const { theme } = this.palette;
    const high = this.barHeight >= 28;
    this.drawWaitingName(context, analysis);
    if (this.barHeight < 9) return;
    context.textAlign = 'right';
    context.textBaseline = 'middle';
    recording.trace.threads.forEach((name, thread) => {
      const middle = this.rowTop(thread) + this.barHeight / 2;
      context.fillStyle = theme.ink;
      context.font = `600 ${high ? 12 : 10.5}px ${theme.font}`;
      context.fillText(fitting([name, name.replace('worker ', 'w'), String(thread)], this.chartLeft - 14, high ? 12 : 10.5), this.chartLeft - 10, high ? middle - 7 : middle);
      if (!high) return;
      context.fillStyle = theme.soft;
      context.font = `11px ${theme.font}`;
      context.fillText(`${percent(analysis.threads[thread].busy / analysis.makespan)} busy`, this.chartLeft - 10, middle + 8);
    });
  }

  protected drawOverlay(context: CanvasRenderingContext2D): void {
    const { recording } = this;
    const focus = this.state.focusIn(this.which);
    if (!recording || !this.analysis || !focus) return;
    context.beginPath();
    context.rect(this.chartLeft, kAxis, this.chartWidth + kRightMargin, this.height);
    context.clip();
    for (const slice of recording.slicesOfNode(focus.node, this.step, focus.pass)) this.drawFocus(context, recording, slice);
  }

  /** A slice with those it waits for (first colour) and those that wait for it (second colour). */
  private drawFocus(context: CanvasRenderingContext2D, recording: Recording, slice: number): void {
    const { series } = this.palette.theme;
    const before = recording.predecessors(slice);
    const after = recording.successors(slice);
    for (const other of before) {
      this.ring(context, recording, other, series[0], 2);
      this.arrow(context, recording, other, slice, series[0], before.length > 12);
    }
    for (const other of after) {
      this.ring(context, recording, other, series[1], 2);
      this.arrow(context, recording, slice, other, series[1], after.length > 12);
    }
    this.ring(context, recording, slice, this.palette.theme.paper, 5);
    this.drawSlice(context, recording, slice);
    this.ring(context, recording, slice, this.palette.theme.ink, 2.5);
  }

  private ring(context: CanvasRenderingContext2D, recording: Recording, slice: number, colour: string, width: number): void {
    const { slices } = recording.trace;
    const length = Math.max(2, slices.duration[slice] * this.scale);
    if (length < 4 && width <= 2) {  // a ring would cover the neighbours
      context.fillStyle = colour;
      context.fillRect(this.x(slices.begin[slice]), this.rowTop(slices.thread[slice]) - 1, length, this.barHeight + 2);
      return;
    }
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.strokeRect(this.x(slices.begin[slice]) - 0.5, this.rowTop(slices.thread[slice]) - 0.5, length, this.barHeight + 1);
  }

  private arrow(context: CanvasRenderingContext2D, recording: Recording, from: number, to: number, colour: string, many: boolean): void {
    const { slices } = recording.trace;
    const a = { x: this.x(recording.end(from)), y: this.rowTop(slices.thread[from]) + this.barHeight / 2 };
    const b = { x: this.x(slices.begin[to]), y: this.rowTop(slices.thread[to]) + this.barHeight / 2 };
    if (Math.hypot(a.x - b.x, a.y - b.y) < 5) return;
    const bend = Math.max(14, Math.abs(b.x - a.x) * 0.35);
    const sag = slices.thread[from] === slices.thread[to] ? this.barHeight / 2 + 4 : 0;
    context.strokeStyle = context.fillStyle = colour;
    context.lineWidth = many ? 0.9 : 1.8;
    context.beginPath();
    context.moveTo(a.x, a.y);
    context.bezierCurveTo(a.x + bend, a.y + sag, b.x - bend, b.y + sag, b.x, b.y);
    context.stroke();
    if (!many) arrowHead(context, b.x, b.y, Math.atan2(-sag, bend), 7);
  }
}
