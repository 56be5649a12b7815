// The schedule of a step from its slices: work, span, bound, and where threads stood idle.
import type { Recording } from './recording';

export interface IdleSegment {
  begin: number;
  end: number;
  /** A node was ready while the thread was idle; otherwise there was nothing to do. */
  scheduler: boolean;
}

/** One thread within [first begin, last end] of a step, us. */
export interface ThreadShare {
  busy: number;
  nothingReady: number;
  scheduler: number;
  idle: IdleSegment[];
}

/** All times in microseconds. */
export interface StepAnalysis {
  begin: number;
  end: number;
  makespan: number;
  /** T1, the sum of the slices. */
  work: number;
  /** Tinf, the longest path through all passes, weighted by the measured durations. */
  span: number;
  /** max(T1 / P, Tinf): no schedule on P threads is shorter. */
  bound: number;
  nothingReady: number;
  scheduler: number;
  /** The slices of the longest path, in order. */
  critical: number[];
  onCritical: Set<number>;
  /** When each slice's predecessors had all ended. */
  ready: Map<number, number>;
  threads: ThreadShare[];
  /** How many nodes were ready and had not begun, from each time on until the next. */
  waiting: { time: number; count: number }[];
}

interface Interval {
  begin: number;
  end: number;
}

/** The union of intervals as disjoint ones in order. */
export function merged(intervals: Interval[]): Interval[] {
  const sorted = intervals.filter((i) => i.end > i.begin).sort((a, b) => a.begin - b.begin);
  const union: Interval[] = [];
  for (const { begin, end } of sorted) {
    const last = union[union.length - 1];
    if (last && begin <= last.end) last.end = Math.max(last.end, end);
    else union.push({ begin, end });
  }
  return union;
}

/** How many intervals are open, from each time on at which that changes. */
export function openCounts(intervals: Interval[]): { time: number; count: number }[] {
  const ends = intervals.filter((i) => i.end > i.begin)
    .flatMap((i) => [{ time: i.begin, by: 1 }, { time: i.end, by: -1 }]).sort((a, b) => a.time - b.time);
  const counts: { time: number; count: number }[] = [];
  let count = 0;
  for (const { time, by } of ends) {
    count += by;
    const last = counts[counts.length - 1];
    if (last?.time === time) last.count = count;
    else counts.push({ time, count });
  }
  return counts;
}

/** Cuts a gap of a thread at the times where a node becomes ready or the last ready one begins. */
function splitGap(gap: Interval, waiting: Interval[], first: number): IdleSegment[] {
  const segments: IdleSegment[] = [];
  let from = gap.begin;
  for (let k = first; k < waiting.length && waiting[k].begin < gap.end; ++k) {
    const begin = Math.max(waiting[k].begin, gap.begin);
    const end = Math.min(waiting[k].end, gap.end);
    if (end <= begin) continue;
    if (begin > from) segments.push({ begin: from, end: begin, scheduler: false });
    segments.push({ begin, end, scheduler: true });
    from = end;
  }
  if (gap.end > from) segments.push({ begin: from, end: gap.end, scheduler: false });
  return segments;
}

/** The times within [begin, end] at which a thread runs no slice of any step. */
function gapsOf(recording: Recording, thread: number, begin: number, end: number): Interval[] {
  const { slices } = recording.trace;
  const own = recording.ofThread(thread);
  const gaps: Interval[] = [];
  let from = begin;
  for (let k = firstEndingAfter(recording, own, begin); k < own.length; ++k) {
    const next = slices.begin[own[k]];
    if (next >= end) break;
    if (next > from) gaps.push({ begin: from, end: next });
    from = Math.max(from, recording.end(own[k]));
  }
  if (end > from) gaps.push({ begin: from, end });
  return gaps;
}

/** Position of the first of a thread's slices that ends after a time (they do not overlap). */
export function firstEndingAfter(recording: Recording, own: Int32Array, time: number): number {
  let low = 0;
  let high = own.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (recording.end(own[middle]) > time) high = middle;
    else low = middle + 1;
  }
  return low;
}

function shareOf(recording: Recording, thread: number, step: Interval, waiting: Interval[]): ThreadShare {
  const idle: IdleSegment[] = [];
  let first = 0;
  for (const gap of gapsOf(recording, thread, step.begin, step.end)) {
    while (first < waiting.length && waiting[first].end <= gap.begin) ++first;
    idle.push(...splitGap(gap, waiting, first));
  }
  const total = (scheduler: boolean) =>
    idle.reduce((sum, i) => (i.scheduler === scheduler ? sum + i.end - i.begin : sum), 0);
  const nothingReady = total(false);
  const scheduler = total(true);
  return { busy: step.end - step.begin - nothingReady - scheduler, nothingReady, scheduler, idle };
}

/** The longest path through the passes of a step, as slices in order. */
function longestPath(recording: Recording, step: number): { span: number; path: number[] } {
  const { graph, slices } = recording.trace;
  const { order, predecessors, previousPass } = recording.adjacency;
  const length = new Float64Array(recording.passes * graph.count);
  const before = new Int32Array(length.length).fill(-1);
  let last = -1;
  const nodes = graph.count;
  for (let pass = 0; pass < recording.passes; ++pass) {
    for (const node of order) {
      const slice = recording.sliceOf(node, step, pass);
      if (slice < 0) continue;
      const place = pass * nodes + node;
      const consider = (other: number) => {
        if (length[other] > 0 && (before[place] < 0 || length[other] > length[before[place]])) before[place] = other;
      };
      for (const other of predecessors.of(node)) consider(pass * nodes + other);
      if (pass > 0) for (const other of previousPass.of(node)) consider((pass - 1) * nodes + other);
      // Nodes too short for the clock still belong to a path.
      length[place] = Math.max(slices.duration[slice], 1e-9) + (before[place] < 0 ? 0 : length[before[place]]);
      if (last < 0 || length[place] > length[last]) last = place;
    }
  }
  const path: number[] = [];
  for (let place = last; place >= 0; place = before[place]) {
    path.push(recording.sliceOf(place % nodes, step, Math.floor(place / nodes)));
  }
  path.reverse();
  return { span: path.reduce((sum, slice) => sum + slices.duration[slice], 0), path };
}

export function analyseStep(recording: Recording, step: number): StepAnalysis {
  const { slices, threads } = recording.trace;
  const own = recording.ofStep(step);
  const begin = own.length > 0 ? recording.stepBegin[step] : 0;
  const end = own.length > 0 ? recording.stepEnd[step] : 0;
  const makespan = Math.max(0, end - begin);
  const ready = new Map<number, number>();
  const waiting: Interval[] = [];
  let work = 0;
  for (const slice of own) {
    work += slices.duration[slice];
    let since = begin;
    for (const other of recording.predecessors(slice)) since = Math.max(since, recording.end(other));
    ready.set(slice, since);
    waiting.push({ begin: since, end: slices.begin[slice] });
  }
  const { span, path } = longestPath(recording, step);
  const union = merged(waiting);
  const shares = threads.map((_, thread) => shareOf(recording, thread, { begin, end }, union));
  return {
    begin, end, makespan, work, span,
    bound: Math.max(work / threads.length, span),
    nothingReady: shares.reduce((sum, share) => sum + share.nothingReady, 0),
    scheduler: shares.reduce((sum, share) => sum + share.scheduler, 0),
    critical: path,
    onCritical: new Set(path),
    ready,
    threads: shares,
    waiting: openCounts(waiting),
  };
}

export interface StageRow {
  stage: number;
  count: number;
  total: number;
  mean: number;
  worst: number;
}

/** Sums by stage over the slices of a step, or over all slices recorded if step is -1. */
export function stageRows(recording: Recording, step: number): StageRow[] {
  const { slices, graph, stages } = recording.trace;
  const rows = stages.map((_, stage) => ({ stage, count: 0, total: 0, mean: 0, worst: 0 }));
  const add = (slice: number) => {
    const row = rows[graph.stage[slices.node[slice]]];
    ++row.count;
    row.total += slices.duration[slice];
    row.worst = Math.max(row.worst, slices.duration[slice]);
  };
  if (step >= 0) recording.ofStep(step).forEach(add);
  else for (let slice = 0; slice < slices.count; ++slice) add(slice);
  for (const row of rows) row.mean = row.count > 0 ? row.total / row.count : 0;
  return rows;
}
