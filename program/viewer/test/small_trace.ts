// A trace small enough to be worked out by hand. One pass, two subsystems:
//   a1 -> b1 -> c,  a2 -> b2 -> c        and from c of one pass to a1, a2 of the next
import { Recording } from '../src/recording';
import { readTrace } from '../src/trace';

export type Slice = [node: number, step: number, pass: number, thread: number, begin: number, duration: number];

export const A1 = 0, B1 = 1, A2 = 2, B2 = 3, C = 4;

/** The data as they stand in a page. */
export function smallData(slices: Slice[], threads = 2, steps = [1], passes = 1): Record<string, unknown> {
  const column = (k: number) => slices.map((slice) => slice[k]);
  return {
    format: 'spoke-trace', version: 1, program: 'Spoke', created: '', scenario: 'small',
    settings: { executor: 'serial' }, machine: {}, subsystem_word: 'blade', subsystems: ['blade 1', 'blade 2'], stages: ['a', 'b', 'c'],
    graph: {
      stage: [0, 1, 0, 1, 2], subsystem: [0, 0, 1, 1, -1], body: [-1, -1, -1, -1, -1], name: ['a1', 'b1', 'a2', 'b2', 'c'],
      edges: { from: [A1, B1, A2, B2], to: [B1, C, B2, C] },
      next_pass_edges: { from: [C, C], to: [A1, A2] },
    },
    threads: Array.from({ length: threads }, (_, k) => `thread ${k}`),
    steps: steps.map((step) => ({ step, time_s: step / 1000, passes })),
    dropped_steps: 0, recording_cost_s: 0,
    slices: {
      node: column(0), step: column(1), pass: column(2), cluster: slices.map(() => -1), thread: column(3),
      begin_us: column(4), duration_us: column(5),
    },
  };
}

export function recordingOf(...input: Parameters<typeof smallData>): Recording {
  return new Recording(readTrace(smallData(...input)));
}
