// Draws a Gantt chart: the slices, and around them axis, brackets, threads with their idle time and the
// track of ready nodes.
import { Bracket, lines } from './brackets';
import { percent } from './format';
import { kAxis, kLine } from './gantt_geometry';
import { GanttScene } from './gantt_scene';
import { drawCritical, drawSlices } from './gantt_slices';
import { fitting } from './layers';
import { tickStep } from './ticks';

export function drawChart(scene: GanttScene): void {
  const { context, geometry, shown, state } = scene;
  drawAxis(scene);
  context.save();
  context.beginPath();
  context.rect(geometry.chartLeft, 0, geometry.chartWidth, geometry.height);
  context.clip();
  drawStepGround(scene);
  for (let thread = 0; thread < shown.recording.trace.threads.length; ++thread) {
    drawIdle(scene, thread);
    drawSlices(scene, thread);
  }
  if (state.showCritical) drawCritical(scene);
  drawWaiting(scene);
  drawBrackets(scene);
  context.restore();
  drawWaitingName(scene);
  drawThreadNames(scene);
}

function drawAxis({ context, geometry, palette }: GanttScene): void {
  const { theme } = palette;
  const step = tickStep(1 / geometry.scale, 74);
  const bottom = geometry.chartBottom + (geometry.trackHeight > 0 ? geometry.trackHeight + 6 : 0);
  context.font = `11px ${theme.font}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.strokeStyle = theme.rule;
  context.lineWidth = 1;
  const largest = Math.max(Math.abs(geometry.from), Math.abs(geometry.to));
  const [unit, name] = largest >= 1e6 ? [1e6, 's'] : largest >= 1e4 ? [1e3, 'ms'] : [1, 'µs'];
  const digits = Math.max(0, -Math.floor(Math.log10(step / unit) + 1e-9));
  for (let k = Math.ceil(geometry.from / step); k * step <= geometry.to; ++k) {
    const x = Math.round(geometry.chartLeft + (k * step - geometry.from) * geometry.scale) + 0.5;
    context.beginPath();
    context.moveTo(x, kAxis - 4);
    context.lineTo(x, bottom);
    context.stroke();
    context.fillStyle = theme.soft;
    const text = ((k * step) / unit).toFixed(digits).replace('-', '−');
    if (x < geometry.width - 18) context.fillText(text, x, kAxis / 2);
  }
  context.textAlign = 'right';
  context.fillStyle = theme.soft;
  context.fillText(name, geometry.chartLeft - 8, kAxis / 2);
}

function drawStepGround({ context, geometry, shown: { analysis }, palette }: GanttScene): void {
  const { theme } = palette;
  const [left, right] = [geometry.x(analysis.begin), geometry.x(analysis.end)];
  const { chartTop, chartBottom } = geometry;
  context.fillStyle = theme.panel;
  context.fillRect(left, chartTop - 3, right - left, chartBottom - chartTop + 3);
  context.strokeStyle = theme.soft;
  context.lineWidth = 1;
  context.setLineDash([3, 3]);
  for (const x of [left, right]) {
    context.beginPath();
    context.moveTo(Math.round(x) + 0.5, chartTop - 3);
    context.lineTo(Math.round(x) + 0.5, chartBottom);
    context.stroke();
  }
  context.setLineDash([]);
}

/** Idle time: a thin line where nothing was ready, a tinted ground where a ready node waited. */
function drawIdle({ context, geometry, shown: { analysis }, palette }: GanttScene, thread: number): void {
  const { theme } = palette;
  const top = geometry.rowTop(thread);
  const height = geometry.barHeight;
  for (const segment of analysis.threads[thread].idle) {
    const [left, right] = [geometry.x(segment.begin), geometry.x(segment.end)];
    if (right < geometry.chartLeft || left > geometry.width || right - left < 0.3) continue;
    context.fillStyle = segment.scheduler ? theme.waiting : theme.rule;
    if (segment.scheduler) context.fillRect(left, top, right - left, height);
    else context.fillRect(left, top + height / 2 - 1, right - left, 2);
  }
}

/** How many ready nodes waited for a thread, as a stepped area. */
function drawWaiting({ context, geometry, shown: { analysis }, palette }: GanttScene): void {
  const height = geometry.trackHeight;
  if (height === 0) return;
  const base = Math.round(geometry.chartBottom + height + 4) + 0.5;
  const most = analysis.waiting.reduce((largest, { count }) => Math.max(largest, count), 1);
  const top = (count: number) => base - ((height - 6) * count) / most;
  context.beginPath();
  context.moveTo(geometry.x(analysis.begin), base);
  let level = 0;
  for (const { time: at, count } of analysis.waiting) {
    const x = geometry.x(at);
    context.lineTo(x, top(level));
    context.lineTo(x, top(count));
    level = count;
  }
  context.lineTo(geometry.x(analysis.end), top(level));
  context.lineTo(geometry.x(analysis.end), base);
  context.closePath();
  const { theme } = palette;
  context.fillStyle = theme.waiting;
  context.fill();
  context.strokeStyle = theme.soft;
  context.lineWidth = 0.75;
  context.stroke();
}

function drawBrackets(scene: GanttScene): void {
  const { shown, state } = scene;
  for (const step of shown.steps) {
    const { number } = shown.recording.trace.steps[step.number];
    drawBracket(scene, step, kAxis + step.line * kLine, step.number === shown.step, [`step ${number}`, String(number)]);
  }
  const top = kAxis + lines(shown.steps) * kLine + 1;
  for (const pass of shown.passes) {
    const bright = state.pass < 0 || state.pass === pass.number;
    drawBracket(scene, pass, top + pass.line * kLine, bright, [`pass ${pass.number + 1}`, String(pass.number + 1)], true);
  }
}

function drawBracket(
  { context, geometry, palette }: GanttScene, bracket: Bracket, top: number, bright: boolean, names: string[], light = false,
): void {
  const left = Math.max(geometry.x(bracket.begin), geometry.chartLeft - 2);
  const right = Math.min(geometry.x(bracket.end), geometry.width + 2);
  if (right - left < 0.5) return;
  const { theme } = palette;
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

function drawThreadNames({ context, geometry, shown, palette }: GanttScene): void {
  if (geometry.barHeight < 9) return;
  const { recording, analysis } = shown;
  const { theme } = palette;
  const high = geometry.barHeight >= 28;
  const size = high ? 12 : 10.5;
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  const x = geometry.chartLeft - 10;
  recording.trace.threads.forEach((name, thread) => {
    const middle = geometry.rowTop(thread) + geometry.barHeight / 2;
    context.fillStyle = theme.ink;
    context.font = `600 ${size}px ${theme.font}`;
    const text = fitting([name, name.replace('worker ', 'w'), String(thread)], x - 4, size);
    context.fillText(text, x, high ? middle - 7 : middle);
    if (!high) return;
    context.fillStyle = theme.soft;
    context.font = `11px ${theme.font}`;
    context.fillText(`${percent(analysis.threads[thread].busy / analysis.makespan)} busy`, x, middle + 8);
  });
}

function drawWaitingName({ context, geometry, shown: { analysis }, palette }: GanttScene): void {
  const height = geometry.trackHeight;
  if (height === 0) return;
  const { theme } = palette;
  const most = analysis.waiting.reduce((largest, { count }) => Math.max(largest, count), 0);
  const middle = geometry.chartBottom + height / 2 + 4;
  const x = geometry.chartLeft - 10;
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
