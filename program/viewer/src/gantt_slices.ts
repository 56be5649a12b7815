// The slices of a Gantt chart: bars with their names, the critical path, and the predecessors and
// successors of a slice in focus.
import { firstEndingAfter } from './analysis';
import { kAxis, kRightMargin } from './gantt_geometry';
import { GanttScene } from './gantt_scene';
import { arrowHead, fitting } from './layers';
import { Paint } from './palette';
import { Recording } from './recording';
import { Picked } from './state';

function isBright({ shown, state }: GanttScene, slice: number): boolean {
  const { recording, step } = shown;
  const { slices } = recording.trace;
  if (slices.step[slice] !== step) return false;
  if (state.pass >= 0 && slices.pass[slice] !== state.pass) return false;
  return state.shows(recording, slices.node[slice]);
}

export function drawSlices(scene: GanttScene, thread: number): void {
  const { geometry, shown: { recording, analysis } } = scene;
  const { slices } = recording.trace;
  const own = recording.ofThread(thread);
  const until = geometry.timeAt(geometry.width - kRightMargin);
  const { scale } = geometry;
  const origin = analysis.begin;
  let k = firstEndingAfter(recording, own, geometry.timeAt(geometry.chartLeft));
  while (k < own.length && slices.begin[own[k]] < until) {
    if (slices.duration[own[k]] * scale >= 1.2) {
      drawSlice(scene, own[k]);
      ++k;
      continue;
    }
    // Slices too small to see share a column of the screen: the longest, of those that are not dimmed.
    const column = Math.floor((slices.begin[own[k]] - origin) * scale);
    let longest = own[k];
    let bright = isBright(scene, longest);
    for (++k; k < own.length; ++k) {
      const slice = own[k];
      if (slices.duration[slice] * scale >= 1.2 || Math.floor((slices.begin[slice] - origin) * scale) !== column) break;
      const alsoBright = isBright(scene, slice);
      if ((alsoBright && !bright) || (alsoBright === bright && slices.duration[slice] > slices.duration[longest])) {
        [longest, bright] = [slice, alsoBright];
      }
    }
    drawColumn(scene, longest, bright);
  }
}

function drawColumn({ context, geometry, shown, palette }: GanttScene, slice: number, bright: boolean): void {
  const { graph, slices, stages } = shown.recording.trace;
  const stage = stages[graph.stage[slices.node[slice]]];
  context.fillStyle = bright ? palette.stage(stage).plain : palette.faint(stage);
  context.fillRect(geometry.x(slices.begin[slice]), geometry.rowTop(slices.thread[slice]), 1.1, geometry.barHeight);
}

function drawSlice(scene: GanttScene, slice: number): void {
  const { context, geometry, shown, palette } = scene;
  const { slices, graph, stages } = shown.recording.trace;
  const left = geometry.x(slices.begin[slice]);
  const width = slices.duration[slice] * geometry.scale;
  const top = geometry.rowTop(slices.thread[slice]);
  const gap = width > 5 ? 0.7 : 0;
  const stage = stages[graph.stage[slices.node[slice]]];
  if (!isBright(scene, slice)) {
    context.fillStyle = palette.faint(stage, slices.step[slice] === shown.step ? 0.86 : 0.78);
    context.fillRect(left, top, width - gap, geometry.barHeight);
    return;
  }
  const paint = palette.stage(stage);
  context.fillStyle = width > 4 ? paint.fill : paint.plain;
  context.fillRect(left, top, Math.max(1, width - gap), geometry.barHeight);
  if (width > 13 && geometry.barHeight >= 12) drawLabel(scene, slice, left, width, paint);
}

// Names are kept by node, since every frame needs them.
const labels = new WeakMap<Recording, string[][]>();

/** What a node's slices may be called, the longest text first. */
function labelsOf(recording: Recording, node: number): string[] {
  const { graph, stages } = recording.trace;
  let known = labels.get(recording);
  if (!known) labels.set(recording, (known = []));
  if (!known[node]) {
    const [blade, body] = [graph.subsystem[node], graph.body[node]];
    const stage = stages[graph.stage[node]];
    const place = blade < 0 ? '' : body < 0 ? `${blade + 1}` : `${blade + 1}.${body + 1}`;
    known[node] = [graph.name[node], place === '' ? stage : `${stage} ${place}`, place];
  }
  return known[node];
}

function drawLabel(
  { context, geometry, shown, palette }: GanttScene, slice: number, left: number, width: number, paint: Paint,
): void {
  const { recording } = shown;
  const { slices } = recording.trace;
  const seenLeft = Math.max(left, geometry.chartLeft);
  const seenWidth = Math.min(left + width, geometry.width) - seenLeft;
  const text = fitting(labelsOf(recording, slices.node[slice]), seenWidth - 4, 11);
  if (text === '') return;
  context.font = `${paint.hatched ? 600 : 500} 11px ${palette.theme.font}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const [x, y] = [seenLeft + seenWidth / 2, geometry.rowTop(slices.thread[slice]) + geometry.barHeight / 2];
  if (paint.hatched) {
    context.fillStyle = paint.plain;
    const room = context.measureText(text).width + 6;
    context.fillRect(x - room / 2, y - 7, room, 14);
  }
  context.fillStyle = paint.ink;
  context.fillText(text, x, y + 0.5);
}

export function drawCritical({ context, geometry, shown, palette }: GanttScene): void {
  const { recording, analysis } = shown;
  const { slices } = recording.trace;
  context.strokeStyle = context.fillStyle = palette.theme.ink;
  context.lineWidth = 1.2;
  let before = -1;
  for (const slice of analysis.critical) {
    const left = geometry.x(slices.begin[slice]);
    const top = geometry.rowTop(slices.thread[slice]);
    const bar = geometry.barHeight >= 12 ? 3.5 : 2;
    context.fillRect(left, top + geometry.barHeight - bar, Math.max(1.2, slices.duration[slice] * geometry.scale - 0.7), bar);
    if (before >= 0) {
      const from = { x: geometry.x(recording.end(before)), y: geometry.rowTop(slices.thread[before]) + geometry.barHeight - 1.5 };
      const to = { x: left, y: top + geometry.barHeight - 1.5 };
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

/** The slices of the node looked at, on the upper canvas. */
export function drawFocus(scene: GanttScene, focus: Picked): void {
  const { context, geometry, shown } = scene;
  context.beginPath();
  context.rect(geometry.chartLeft, kAxis, geometry.chartWidth + kRightMargin, geometry.height);
  context.clip();
  for (const slice of shown.recording.slicesOfNode(focus.node, shown.step, focus.pass)) drawLinks(scene, slice);
}

/** A slice with those it waits for (first colour) and those that wait for it (second colour). */
function drawLinks(scene: GanttScene, slice: number): void {
  const { shown: { recording }, palette } = scene;
  const { series } = palette.theme;
  const before = recording.predecessors(slice);
  const after = recording.successors(slice);
  for (const other of before) {
    ring(scene, other, series[0], 2);
    arrow(scene, other, slice, series[0], before.length > 12);
  }
  for (const other of after) {
    ring(scene, other, series[1], 2);
    arrow(scene, slice, other, series[1], after.length > 12);
  }
  ring(scene, slice, palette.theme.paper, 5);
  drawSlice(scene, slice);
  ring(scene, slice, palette.theme.ink, 2.5);
}

function ring({ context, geometry, shown }: GanttScene, slice: number, colour: string, width: number): void {
  const { slices } = shown.recording.trace;
  const length = Math.max(2, slices.duration[slice] * geometry.scale);
  if (length < 4 && width <= 2) {  // a ring would cover the neighbours
    context.fillStyle = colour;
    context.fillRect(geometry.x(slices.begin[slice]), geometry.rowTop(slices.thread[slice]) - 1, length, geometry.barHeight + 2);
    return;
  }
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.strokeRect(geometry.x(slices.begin[slice]) - 0.5, geometry.rowTop(slices.thread[slice]) - 0.5, length, geometry.barHeight + 1);
}

function arrow(
  { context, geometry, shown: { recording } }: GanttScene, from: number, to: number, colour: string, many: boolean,
): void {
  const { slices } = recording.trace;
  const a = { x: geometry.x(recording.end(from)), y: geometry.rowTop(slices.thread[from]) + geometry.barHeight / 2 };
  const b = { x: geometry.x(slices.begin[to]), y: geometry.rowTop(slices.thread[to]) + geometry.barHeight / 2 };
  if (Math.hypot(a.x - b.x, a.y - b.y) < 5) return;
  const bend = Math.max(14, Math.abs(b.x - a.x) * 0.35);
  const sag = slices.thread[from] === slices.thread[to] ? geometry.barHeight / 2 + 4 : 0;
  context.strokeStyle = context.fillStyle = colour;
  context.lineWidth = many ? 0.9 : 1.8;
  context.beginPath();
  context.moveTo(a.x, a.y);
  context.bezierCurveTo(a.x + bend, a.y + sag, b.x - bend, b.y + sag, b.x, b.y);
  context.stroke();
  if (!many) arrowHead(context, b.x, b.y, Math.atan2(-sag, bend), 7);
}
