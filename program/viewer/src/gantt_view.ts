// The Gantt chart of one recording's threads around the chosen step: the actions of pointer and
// keys in it.
import { time } from './format';
import { drawChart } from './gantt_drawing';
import { GanttGeometry } from './gantt_geometry';
import { GanttScene } from './gantt_scene';
import { drawFocus } from './gantt_slices';
import { Layers, onDrag } from './layers';
import { Palette } from './palette';
import { ShownStep } from './shown_step';
import { Picked, State } from './state';
import { TimeWindow } from './time_window';

const kKeys = 'Left and right walk along a thread, up and down change it, plus and minus zoom, 0 fits, shift and arrows pan, escape clears.';

export class GanttView extends Layers {
  /** None while the page has no such recording; the chart is then hidden. */
  private shown: ShownStep | null = null;

  constructor(
    host: HTMLElement, private readonly which: number, private readonly state: State,
    private readonly window: TimeWindow, private palette: Palette,
  ) {
    super(host, 'Gantt chart of the threads', kKeys);
    onDrag(this.canvas, (dx) => window.pan(-dx / this.geometry.chartWidth), (x, y) => this.click(x, y));
    window.onChange(() => this.redraw());
    this.canvas.addEventListener('pointermove', (event) => this.point(event));
    this.canvas.addEventListener('pointerleave', () => state.hover(null));
    this.canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    this.canvas.addEventListener('dblclick', () => window.fit());
    this.canvas.addEventListener('keydown', (event) => this.key(event));
  }

  /** Asked for by pointer, keys and drawing, which all need a step shown. */
  private get geometry(): GanttGeometry {
    return new GanttGeometry(this.width, this.height, this.window, this.shown as ShownStep);
  }

  usePalette(palette: Palette): void {
    this.palette = palette;
    this.redraw();
  }

  /** A new recording, step or pass. */
  refresh(): void {
    const recording = this.state.recordings[this.which];
    this.shown = recording ? new ShownStep(recording, this.state.stepOf(this.which)) : null;
    this.redraw();
  }

  /** The middle of a slice on the canvas, in CSS pixels. */
  pointOf(slice: number): { x: number; y: number } {
    return this.geometry.pointOf(slice);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const { chartLeft, chartWidth } = this.geometry;
    const sideways = event.shiftKey ? event.deltaY + event.deltaX : event.deltaX;
    if (Math.abs(sideways) > Math.abs(event.deltaY) || event.shiftKey) this.window.pan(sideways / chartWidth);
    else this.window.zoom(Math.exp(-event.deltaY * 0.0016), (event.offsetX - chartLeft) / chartWidth);
  }

  private point(event: PointerEvent): void {
    if (event.buttons !== 0) return;
    const { geometry } = this;
    const slice = geometry.sliceAt(event.offsetX, event.offsetY);
    this.canvas.classList.toggle('over', slice >= 0 || geometry.stepAt(event.offsetX, event.offsetY) >= 0);
    this.canvas.dataset.hint = slice >= 0 ? this.hint(slice) : '';
    this.state.hover(this.pickedOf(slice));
  }

  /** What a pointer on a slice is told. */
  private hint(slice: number): string {
    const { trace } = (this.shown as ShownStep).recording;
    const { slices, graph } = trace;
    const step = slices.step[slice];
    const where = step < 0 ? 'surplus pass' : `step ${trace.steps[step].number}, pass ${slices.pass[slice] + 1}`;
    return `${graph.name[slices.node[slice]]}\n${time(slices.duration[slice])} on ${trace.threads[slices.thread[slice]]}, ${where}`;
  }

  /** The node of a slice of the chosen step, in the active recording. */
  private pickedOf(slice: number): Picked | null {
    const { recording, step } = this.shown as ShownStep;
    const { slices, graph } = recording.trace;
    if (slice < 0 || slices.step[slice] !== step) return null;
    const pass = slices.pass[slice];
    const node = slices.node[slice];
    if (this.which === this.state.active) return { node, pass };
    const same = this.state.recording.byName.get(graph.name[node]);
    return same === undefined ? null : { node: same, pass };
  }

  private click(x: number, y: number): void {
    const { geometry } = this;
    const step = geometry.stepAt(x, y);
    const slice = geometry.sliceAt(x, y);
    const shown = this.shown as ShownStep;
    this.state.setActive(this.which);
    if (slice < 0 && step < 0) this.state.select(null);
    const owner = slice >= 0 ? shown.recording.trace.slices.step[slice] : step;
    if (owner >= 0 && owner !== shown.step) this.goTo(owner, slice);
    else if (slice >= 0 && owner >= 0) this.state.select(this.pickedOf(slice));
  }

  /** Chooses the step of another slice, without moving what is on the screen if it was zoomed. */
  private goTo(step: number, slice: number): void {
    const shown = this.shown as ShownStep;
    const { stepBegin, trace } = shown.recording;
    const first = this.state.recordings[0].trace.steps;
    const { number } = trace.steps[step];
    const same = first.findIndex((other) => other.number === number);
    const by = stepBegin[shown.step] - stepBegin[step];
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
    if (slice < 0) return 0.5;
    const { geometry } = this;
    const at = (geometry.pointOf(slice).x - geometry.chartLeft) / geometry.chartWidth;
    return at >= 0 && at <= 1 ? at : 0.5;
  }

  private selectedSlice(): number {
    const { shown } = this;
    if (!shown || this.which !== this.state.active || !this.state.selected) return -1;
    const { node, pass } = this.state.selected;
    return shown.recording.slicesOfNode(node, shown.step, pass)[0] ?? -1;
  }

  private walk(key: string): void {
    const { recording, step } = this.shown as ShownStep;
    const { slices, threads } = recording.trace;
    this.state.setActive(this.which);
    const at = this.selectedSlice();
    let next = -1;
    if (at < 0) next = recording.ofStep(step)[0] ?? -1;
    else if (key === 'ArrowLeft' || key === 'ArrowRight') {
      const direction = key === 'ArrowRight' ? 1 : -1;
      const own = recording.ofThread(slices.thread[at]);
      for (let k = own.indexOf(at) + direction; k >= 0 && k < own.length && next < 0; k += direction) {
        if (slices.step[own[k]] === step) next = own[k];
      }
    } else {
      const thread = slices.thread[at] + (key === 'ArrowDown' ? 1 : -1);
      if (thread >= 0 && thread < threads.length) next = this.nearestOn(thread, slices.begin[at]);
    }
    if (next < 0) return;
    this.state.select(this.pickedOf(next));
  }

  private nearestOn(thread: number, begin: number): number {
    const { recording, step } = this.shown as ShownStep;
    const { slices } = recording.trace;
    let best = -1;
    for (const slice of recording.ofThread(thread)) {
      if (slices.step[slice] !== step) continue;
      const distance = Math.abs(slices.begin[slice] - begin);
      if (best < 0 || distance < Math.abs(slices.begin[best] - begin)) best = slice;
    }
    return best;
  }

  /** Moves the shown time if all slices of a node are outside of it. */
  reveal({ node, pass }: Picked): void {
    if (!this.shown) return;
    const { recording, step, analysis } = this.shown;
    const found = recording.slicesOfNode(node, step, pass);
    if (found.length === 0) return;
    const { slices } = recording.trace;
    const places = found.map((slice) => [slices.begin[slice] - analysis.begin, recording.end(slice) - analysis.begin]);
    const isShown = ([begin, end]: number[]) => end > this.window.from && begin < this.window.to;
    if (!places.some(isShown)) this.window.reveal(places[0][0], places[0][1]);
  }

  private sceneOn(context: CanvasRenderingContext2D, shown: ShownStep): GanttScene {
    return { context, geometry: this.geometry, shown, state: this.state, palette: this.palette };
  }

  protected drawBase(context: CanvasRenderingContext2D): void {
    if (this.shown) drawChart(this.sceneOn(context, this.shown));
  }

  protected drawOverlay(context: CanvasRenderingContext2D): void {
    if (!this.shown) return;
    const focus = this.state.focusIn(this.which);
    if (focus) drawFocus(this.sceneOn(context, this.shown), focus);
  }
}
