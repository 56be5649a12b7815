// The places of times and threads on a Gantt chart, and the items at a place: from the top the
// axis, the brackets of steps and passes, a row for each thread and the track of ready nodes.
// Lengths are in CSS pixels.
import { firstEndingAfter } from './analysis';
import { lines } from './brackets';
import { ShownStep } from './shown_step';
import { TimeWindow } from './time_window';

export const kAxis = 22;
/** Height of a line of brackets. */
export const kLine = 15;
export const kRightMargin = 10;
const kGap = 6;
const kMostRow = 110;
const kMostTrack = 130;

/** Holds for one size of the canvas and one part of time; made anew when either may have changed. */
export class GanttGeometry {
  /** Shown time, us from the begin of the step. */
  readonly from: number;
  readonly to: number;
  readonly chartLeft: number;
  readonly chartWidth: number;
  readonly chartTop: number;
  /** Below the rows of the threads. */
  readonly chartBottom: number;
  /** Pixels per us. */
  readonly scale: number;
  readonly barHeight: number;
  /** Of the track of ready nodes; 0 = no room. */
  readonly trackHeight: number;
  private readonly rowHeight: number;

  constructor(readonly width: number, readonly height: number, { from, to }: TimeWindow, private readonly shown: ShownStep) {
    const threads = shown.recording.trace.threads.length;
    this.from = from;
    this.to = to;
    this.chartLeft = width > 420 ? 92 : 76;
    this.chartWidth = Math.max(1, width - this.chartLeft - kRightMargin);
    this.scale = this.chartWidth / (to - from);
    this.chartTop = kAxis + (lines(shown.steps) + lines(shown.passes)) * kLine + 6;
    this.rowHeight = Math.max(3, Math.min(kMostRow + kGap, (height - this.chartTop - 6) / (threads + 0.9)));
    this.barHeight = this.rowHeight > 14 ? this.rowHeight - kGap : this.rowHeight - 1;
    this.chartBottom = this.rowTop(threads);
    const room = height - this.chartBottom - 12;
    this.trackHeight = room < 22 ? 0 : Math.min(kMostTrack, room);
  }

  x(us: number): number {
    return this.chartLeft + (us - this.shown.analysis.begin - this.from) * this.scale;
  }
  timeAt(x: number): number {
    return (x - this.chartLeft) / this.scale + this.from + this.shown.analysis.begin;
  }
  rowTop(thread: number): number {
    return this.chartTop + thread * this.rowHeight;
  }

  /** The middle of a slice. */
  pointOf(slice: number): { x: number; y: number } {
    const { slices } = this.shown.recording.trace;
    const x = this.x(slices.begin[slice] + slices.duration[slice] / 2);
    return { x, y: this.rowTop(slices.thread[slice]) + this.barHeight / 2 };
  }

  /** The slice at a place or close beside it; -1 = none. */
  sliceAt(x: number, y: number): number {
    const { recording } = this.shown;
    if (x < this.chartLeft || y < this.chartTop) return -1;
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

  /** The step whose bracket is at a place; -1 = none. */
  stepAt(x: number, y: number): number {
    const line = Math.floor((y - kAxis) / kLine);
    const at = this.timeAt(x);
    if (x < this.chartLeft) return -1;
    return this.shown.steps.find((step) => step.line === line && at >= step.begin && at <= step.end)?.number ?? -1;
  }
}
