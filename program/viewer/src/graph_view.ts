// The step graph on a canvas: one pass, its nodes in lanes by blade and rows by level.
import { Glide } from './glide';
import { arrowHead, fitting, Layers, onDrag, widthOf } from './layers';
import { GraphLayout } from './layout';
import { Palette, Paint } from './palette';
import { Recording } from './recording';
import { Picked, State } from './state';
import { significant } from './format';
import { subsystemName } from './trace';

const kHeader = 24;
const kMargin = 14;
const kRowNameSize = 11;
const kKeys = 'Arrow keys follow edges and walk along a row, plus and minus zoom, 0 fits, shift and arrows pan, escape clears.';

export class GraphView extends Layers {
  private scale = 1;
  private left = 0;
  private top = 0;
  private fitted = true;
  private costs = new Float64Array(0);
  private largestCost = 0;
  private readonly glide = new Glide();

  constructor(host: HTMLElement, private readonly state: State, private palette: Palette) {
    super(host, 'Step graph', kKeys);
    onDrag(this.canvas, (dx, dy) => this.pan(dx, dy), (x, y) => this.click(x, y));
    this.canvas.addEventListener('pointermove', (event) => this.point(event));
    this.canvas.addEventListener('pointerleave', () => state.hover(null));
    this.canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    this.canvas.addEventListener('dblclick', () => this.fit());
    this.canvas.addEventListener('keydown', (event) => this.key(event));
  }

  private get recording(): Recording {
    return this.state.recording;
  }
  private get layout(): GraphLayout {
    return this.recording.layout;
  }

  usePalette(palette: Palette): void {
    this.palette = palette;
    this.redraw();
  }

  /** A new graph, step or pass: the nodes' times. */
  refresh(): void {
    const { trace } = this.recording;
    const step = this.state.stepOf(this.state.active);
    this.costs = new Float64Array(trace.graph.count);
    for (const slice of this.recording.ofStep(step)) {
      if (this.state.pass >= 0 && trace.slices.pass[slice] !== this.state.pass) continue;
      this.costs[trace.slices.node[slice]] += trace.slices.duration[slice];
    }
    this.largestCost = this.costs.reduce((most, cost) => Math.max(most, cost), 0);
    if (this.fitted) this.fit(false);
    this.redraw();
  }

  fit(smoothly = true): void {
    this.fitted = true;
    const gutter = this.gutter();
    const width = Math.max(50, this.width - gutter - 2 * kMargin);
    const height = Math.max(50, this.height - kHeader - 2 * kMargin);
    const { totalWidth, totalHeight } = this.layout;
    const scale = Math.min(1.6, width / totalWidth, height / totalHeight);
    const left = gutter + kMargin + (width - totalWidth * scale) / 2;
    const top = kHeader + kMargin + Math.max(0, (height - totalHeight * scale) / 2);
    const set = ([s, l, t]: number[]) => {
      [this.scale, this.left, this.top] = [s, l, t];
      this.redraw();
    };
    if (smoothly) this.glide.start([this.scale, this.left, this.top], [scale, left, top], set);
    else set([scale, left, top]);
  }

  protected override resized(): void {
    if (this.fitted && this.state?.recordings.length > 0) this.fit(false);
  }

  /** The place of a node on the canvas, in CSS pixels. */
  pointOf(node: number): { x: number; y: number } {
    return { x: this.left + this.layout.x[node] * this.scale, y: this.top + this.layout.y[node] * this.scale };
  }

  /** The room for the names of rows at the left: as wide as the widest, none where the graph needs it all. */
  private gutter(): number {
    if (this.width <= 330) return 0;
    const widest = Math.max(...this.recording.trace.stages.map((stage) => widthOf(stage) * kRowNameSize));
    return Math.min(Math.max(78, widest + 12), this.width / 3);
  }

  private pan(dx: number, dy: number): void {
    this.glide.stop();
    this.fitted = false;
    this.left += dx;
    this.top += dy;
    this.redraw();
  }

  private zoom(factor: number, x: number, y: number): void {
    this.glide.stop();
    this.fitted = false;
    const scale = Math.min(4, Math.max(0.02, this.scale * factor));
    this.left = x - ((x - this.left) * scale) / this.scale;
    this.top = y - ((y - this.top) * scale) / this.scale;
    this.scale = scale;
    this.redraw();
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    if (event.shiftKey) this.pan(-event.deltaY - event.deltaX, 0);
    else this.zoom(Math.exp(-event.deltaY * 0.0016), event.offsetX, event.offsetY);
  }

  private nodeAt(x: number, y: number): number {
    const { graph } = this.recording.trace;
    const [gx, gy] = [(x - this.left) / this.scale, (y - this.top) / this.scale];
    const slack = Math.max(2, 3 / this.scale);
    const half = this.layout.nodeHeight / 2;
    for (let node = 0; node < graph.count; ++node) {
      if (Math.abs(gy - this.layout.y[node]) > half + slack) continue;
      if (Math.abs(gx - this.layout.x[node]) <= this.layout.width[node] / 2 + slack) return node;
    }
    return -1;
  }

  private point(event: PointerEvent): void {
    if (event.buttons !== 0) return;
    const node = this.nodeAt(event.offsetX, event.offsetY);
    this.canvas.classList.toggle('over', node >= 0);
    this.state.hover(node < 0 ? null : { node, pass: this.state.pass });
  }

  private click(x: number, y: number): void {
    const node = this.nodeAt(x, y);
    this.state.select(node < 0 ? null : { node, pass: this.state.pass });
  }

  private key(event: KeyboardEvent): void {
    const step = 60;
    const pans: Record<string, [number, number]> = {
      ArrowLeft: [step, 0], ArrowRight: [-step, 0], ArrowUp: [0, step], ArrowDown: [0, -step],
    };
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key in pans) {
      if (event.shiftKey) this.pan(...pans[event.key]);
      else this.walk(event.key);
    } else if (event.key === '+' || event.key === '=') this.zoom(1.25, this.width / 2, this.height / 2);
    else if (event.key === '-') this.zoom(0.8, this.width / 2, this.height / 2);
    else if (event.key === '0') this.fit();
    else return;
    event.preventDefault();
  }

  /** Selects the next node in a direction: along an edge, or beside. */
  private walk(key: string): void {
    const { adjacency } = this.recording;
    const at = this.state.selected?.node;
    let next: number | undefined = adjacency.order[0];
    if (at !== undefined) {
      if (key === 'ArrowUp') next = this.nearest(adjacency.predecessors.of(at), at);
      else if (key === 'ArrowDown') next = this.nearest(adjacency.successors.of(at), at);
      else next = this.beside(at, key === 'ArrowRight' ? 1 : -1);
    }
    if (next === undefined) return;
    this.state.select({ node: next, pass: this.state.pass });
  }

  private nearest(nodes: Int32Array, at: number): number | undefined {
    const distance = (node: number) => Math.abs(this.layout.x[node] - this.layout.x[at]);
    return [...nodes].sort((a, b) => distance(a) - distance(b))[0];
  }

  private beside(at: number, direction: number): number | undefined {
    const { x, y } = this.layout;
    let best: number | undefined;
    for (let node = 0; node < x.length; ++node) {
      const distance = (x[node] - x[at]) * direction;
      if (y[node] !== y[at] || distance <= 0) continue;
      if (best === undefined || distance < (x[best] - x[at]) * direction) best = node;
    }
    return best;
  }

  /** Pans if a node is outside of the view. */
  reveal(node: number): void {
    const { x, y } = this.pointOf(node);
    const margin = 12;
    const dx = x < this.gutter() + margin ? this.gutter() + margin - x : x > this.width - margin ? this.width - margin - x : 0;
    const dy = y < kHeader + margin ? kHeader + margin - y : y > this.height - margin ? this.height - margin - y : 0;
    if (dx !== 0 || dy !== 0) this.pan(dx, dy);
  }

  private paintOf(node: number): Paint {
    if (this.state.colourBy === 'share') {
      return this.palette.share(this.largestCost > 0 ? this.costs[node] / this.largestCost : 0);
    }
    const { graph, stages } = this.recording.trace;
    return this.palette.stage(stages[graph.stage[node]]);
  }

  private criticalNodes(): Set<number> {
    if (!this.state.showCritical) return new Set();
    const { slices } = this.recording.trace;
    const { critical } = this.recording.analysis(this.state.stepOf(this.state.active));
    const here = critical.filter((k) => this.state.pass < 0 || slices.pass[k] === this.state.pass);
    return new Set(here.map((k) => slices.node[k]));
  }

  private criticalEdges(): [number, number][] {
    if (!this.state.showCritical) return [];
    const { slices } = this.recording.trace;
    const { critical } = this.recording.analysis(this.state.stepOf(this.state.active));
    const edges: [number, number][] = [];
    for (let k = 1; k < critical.length; ++k) {
      const [a, b] = [critical[k - 1], critical[k]];
      if (slices.pass[a] !== slices.pass[b]) continue;
      if (this.state.pass < 0 || slices.pass[a] === this.state.pass) edges.push([slices.node[a], slices.node[b]]);
    }
    return edges;
  }

  protected drawBase(context: CanvasRenderingContext2D): void {
    if (this.state.recordings.length === 0) return;
    this.drawLanes(context);
    this.drawEdges(context);
    const critical = this.criticalNodes();
    const { graph } = this.recording.trace;
    for (let node = 0; node < graph.count; ++node) this.drawNode(context, node, critical.has(node));
    this.drawFrame(context);
  }

  private drawLanes(context: CanvasRenderingContext2D): void {
    const { lanes, totalHeight } = this.layout;
    context.fillStyle = this.palette.theme.panel;
    for (const lane of lanes) {
      const pad = Math.min(8, 8 * this.scale);
      context.beginPath();
      context.roundRect(
        this.left + lane.left * this.scale - pad, this.top - pad,
        lane.width * this.scale + 2 * pad, totalHeight * this.scale + 2 * pad, Math.min(8, 10 * this.scale));
      context.fill();
    }
  }

  private trace(context: CanvasRenderingContext2D, from: number, to: number): void {
    const half = (this.layout.nodeHeight / 2) * this.scale;
    const [a, b] = [this.pointOf(from), this.pointOf(to)];
    const [y0, y1] = [a.y + half, b.y - half];
    context.moveTo(a.x, y0);
    if (this.scale < 0.4) {
      context.lineTo(b.x, y1);
      return;
    }
    const bend = Math.max(6 * this.scale, Math.min(24 * this.scale, (y1 - y0) * 0.5));
    context.bezierCurveTo(a.x, y0 + bend, b.x, y1 - bend, b.x, y1);
  }

  private drawEdges(context: CanvasRenderingContext2D): void {
    const { edges } = this.recording.trace.graph;
    const dense = edges.from.length > 600 ? Math.min(1, Math.max(0.12, this.scale)) : 1;
    context.beginPath();
    for (let k = 0; k < edges.from.length; ++k) this.trace(context, edges.from[k], edges.to[k]);
    context.strokeStyle = this.palette.theme.soft;
    context.globalAlpha = 0.5 * dense;
    context.lineWidth = Math.max(0.5, Math.min(1.2, this.scale));
    context.stroke();
    context.beginPath();
    for (const [from, to] of this.criticalEdges()) this.trace(context, from, to);
    context.strokeStyle = this.palette.theme.ink;
    context.globalAlpha = 1;
    context.lineWidth = Math.max(1.5, Math.min(3, 2.6 * this.scale));
    context.stroke();
  }

  private outline(context: CanvasRenderingContext2D, node: number, grow: number): void {
    const { x, y } = this.pointOf(node);
    const width = this.layout.width[node] * this.scale + 2 * grow;
    const height = this.layout.nodeHeight * this.scale + 2 * grow;
    context.beginPath();
    context.roundRect(x - width / 2, y - height / 2, width, height, Math.max(1, Math.min(5 + grow, (5 + grow) * this.scale)));
  }

  private isVisible(node: number): boolean {
    const { x, y } = this.pointOf(node);
    const [w, h] = [this.layout.width[node] * this.scale, this.layout.nodeHeight * this.scale];
    return x > -w && x < this.width + w && y > -h && y < this.height + h;
  }

  private drawNode(context: CanvasRenderingContext2D, node: number, critical: boolean): void {
    if (!this.isVisible(node)) return;
    const paint = this.paintOf(node);
    const shown = this.state.shows(this.recording, node);
    this.outline(context, node, 0);
    context.fillStyle = this.palette.theme.paper;
    context.fill();
    context.globalAlpha = shown ? 1 : 0.16;
    context.fillStyle = paint.fill;
    context.fill();
    if (critical) {
      context.strokeStyle = this.palette.theme.ink;
      context.lineWidth = Math.max(1, Math.min(2.6, 2.4 * this.scale));
      context.stroke();
    }
    if (shown) this.drawLabel(context, node, paint);
    context.globalAlpha = 1;
  }

  private labels(node: number): string[] {
    const { graph, stages } = this.recording.trace;
    const stage = stages[graph.stage[node]];
    const body = graph.body[node];
    return body < 0 ? [stage] : [`${stage} ${body + 1}`, `${body + 1}`];
  }

  private drawLabel(context: CanvasRenderingContext2D, node: number, paint: Paint): void {
    const size = Math.min(13, 10.6 * this.scale);
    if (size < 6) return;
    const text = fitting(this.labels(node), this.layout.width[node] * this.scale - 2, size);
    if (text === '') return;
    const { x, y } = this.pointOf(node);
    const withTime = this.scale >= 1.9;
    context.font = `${paint.hatched ? 600 : 500} ${size}px ${this.palette.theme.font}`;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    if (paint.hatched) {  // stripes behind letters are hard to read
      const width = context.measureText(text).width + 6;
      context.fillStyle = paint.plain;
      context.fillRect(x - width / 2, y - size * 0.62 - (withTime ? 7 : 0), width, size * 1.24);
    }
    context.fillStyle = paint.ink;
    context.fillText(text, x, withTime ? y - 7 : y + 0.5);
    if (!withTime) return;
    context.font = `500 11px ${this.palette.theme.font}`;
    context.fillText(significant(this.costs[node]) + (this.layout.width[node] * this.scale > 66 ? ' µs' : ''), x, y + 8);
  }

  /** Names of lanes above and of rows at the left, which stay when the graph is moved. */
  private drawFrame(context: CanvasRenderingContext2D): void {
    const { theme } = this.palette;
    context.fillStyle = theme.paper;
    context.fillRect(0, 0, this.width, kHeader);
    context.fillRect(0, 0, this.gutter(), this.height);
    context.fillStyle = theme.soft;
    context.textBaseline = 'middle';
    this.drawLaneNames(context);
    this.drawRowNames(context);
  }

  private drawLaneNames(context: CanvasRenderingContext2D): void {
    const { trace } = this.recording;
    context.font = `600 11.5px ${this.palette.theme.font}`;
    context.textAlign = 'center';
    const { lanes } = this.layout;
    const pitch = lanes.length > 1 ? (lanes[1].left - lanes[0].left) * this.scale : this.width;
    const every = Math.ceil((String(lanes.length).length * 7 + 5) / pitch);  // where not all numbers fit
    for (const [k, lane] of lanes.entries()) {
      const x = this.left + (lane.left + lane.width / 2) * this.scale;
      if (k % every !== 0) continue;
      if (lane.subsystem < 0 || x < this.gutter() + 8 || x > this.width - 8) continue;
      const number = String(lane.subsystem + 1);
      const room = Math.max(pitch * every - 4, 8);
      context.fillText(fitting([subsystemName(trace, lane.subsystem), number], room, 11.5), x, kHeader / 2 + 2);
    }
  }

  private drawRowNames(context: CanvasRenderingContext2D): void {
    if (this.gutter() === 0) return;
    const { stages } = this.recording.trace;
    context.font = `500 ${kRowNameSize}px ${this.palette.theme.font}`;
    context.textAlign = 'right';
    let lowest = kHeader + 4;
    for (const row of this.layout.rows) {
      const middle = this.top + (row.top + row.height / 2) * this.scale;
      const names = row.stages.map((stage) => stages[stage]);
      const lines = Math.min(names.length, 3);
      const start = middle - ((lines - 1) * 12) / 2;
      if (start - 6 < lowest || middle > this.height - 6) continue;
      for (let k = 0; k < lines; ++k) context.fillText(names[k], this.gutter() - 6, start + k * 12);
      lowest = start + lines * 12 - 6;
    }
  }

  protected drawOverlay(context: CanvasRenderingContext2D): void {
    if (this.state.recordings.length === 0) return;
    const focus = this.state.focus;
    if (focus) this.drawFocus(context, focus);
    const { selected } = this.state;
    if (selected && selected !== focus) this.drawRing(context, selected.node, 2);
  }

  private drawRing(context: CanvasRenderingContext2D, node: number, width: number): void {
    this.outline(context, node, 2.5);
    context.strokeStyle = this.palette.theme.paper;
    context.lineWidth = width + 2.5;
    context.stroke();
    context.strokeStyle = this.palette.theme.ink;
    context.lineWidth = width;
    context.stroke();
  }

  private drawFocus(context: CanvasRenderingContext2D, focus: Picked): void {
    const { adjacency } = this.recording;
    const { theme } = this.palette;
    const before = adjacency.predecessors.of(focus.node);
    const after = adjacency.successors.of(focus.node);
    context.beginPath();
    context.rect(this.gutter(), kHeader, this.width, this.height);
    context.clip();
    this.drawFocusEdges(context, [...before].map((node) => [node, focus.node]), theme.series[0]);
    this.drawFocusEdges(context, [...after].map((node) => [focus.node, node]), theme.series[1]);
    this.drawNextPass(context, focus.node);
    const critical = this.criticalNodes();
    for (const node of [...before, ...after]) {
      this.drawNode(context, node, critical.has(node));
      this.outline(context, node, 1.5);
      context.strokeStyle = before.includes(node) ? theme.series[0] : theme.series[1];
      context.lineWidth = 2;
      context.stroke();
    }
    this.drawNode(context, focus.node, critical.has(focus.node));
    this.drawRing(context, focus.node, 2.5);
  }

  private drawFocusEdges(context: CanvasRenderingContext2D, edges: [number, number][], colour: string): void {
    context.lineWidth = 2.4;
    context.strokeStyle = context.fillStyle = colour;
    context.beginPath();
    for (const [from, to] of edges) this.trace(context, from, to);
    context.stroke();
    for (const [, to] of edges) {
      const { x, y } = this.pointOf(to);
      arrowHead(context, x, y - (this.layout.nodeHeight / 2) * this.scale, Math.PI / 2, 7);
    }
  }

  /** Edges into the next pass, drawn back to the top as dashed curves. */
  private drawNextPass(context: CanvasRenderingContext2D, node: number): void {
    const { adjacency } = this.recording;
    const pairs = [...adjacency.nextPass.of(node)].map((to) => [node, to, 1])
      .concat([...adjacency.previousPass.of(node)].map((from) => [from, node, 0]));
    context.setLineDash([5, 4]);
    context.lineWidth = 1.8;
    for (const [from, to, forward] of pairs) {
      const [a, b] = [this.pointOf(from), this.pointOf(to)];
      const side = Math.max(a.x, b.x) + 60 * this.scale;
      context.strokeStyle = this.palette.theme.series[forward];
      context.beginPath();
      context.moveTo(a.x + (this.layout.width[from] / 2) * this.scale, a.y);
      context.bezierCurveTo(side, a.y, side, b.y, b.x + (this.layout.width[to] / 2) * this.scale, b.y);
      context.stroke();
    }
    context.setLineDash([]);
  }
}
