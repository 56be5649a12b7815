import assert from 'node:assert/strict';
import { test } from 'node:test';
import { merged, openCounts, stageRows } from '../src/analysis';
import { A1, A2, B1, B2, C, recordingOf, Slice } from './small_trace';

const near = (actual: number, expected: number) => assert.ok(Math.abs(actual - expected) < 1e-9, `${actual} is not ${expected}`);

// Thread 0: a1 0-2, b1 2-5, c 9-10. Thread 1: a2 0-1, late b2 6-9.
const kPass: Slice[] = [[A1, 1, 0, 0, 0, 2], [A2, 1, 0, 1, 0, 1], [B1, 1, 0, 0, 2, 3], [B2, 1, 0, 1, 6, 3], [C, 1, 0, 0, 9, 1]];

test('work, span, makespan and bound of one pass', () => {
  const step = recordingOf(kPass).analysis(0);
  near(step.work, 10);
  near(step.span, 6);  // a1 2, b1 3, c 1
  near(step.makespan, 10);
  near(step.bound, 6);
});

test('the bound is the work by the threads where that is larger than the span', () => {
  const serial: Slice[] = [[A1, 1, 0, 0, 0, 2], [A2, 1, 0, 0, 2, 1], [B1, 1, 0, 0, 3, 3], [B2, 1, 0, 0, 6, 3], [C, 1, 0, 0, 9, 1]];
  near(recordingOf(serial, 1).analysis(0).bound, 10);
});

test('the median step is that of median makespan, of two in the middle the longer one', () => {
  // Each step begins where the one before ends; the first one is cold.
  const stepsOf = (lengths: number[]) => {
    const begins = lengths.map((_, k) => lengths.slice(0, k).reduce((a, b) => a + b, 0));
    return recordingOf(lengths.map((length, k): Slice => [A1, 7 + k, 0, 0, begins[k], length]), 1, lengths.map((_, k) => 7 + k));
  };
  assert.equal(stepsOf([90, 3, 5, 1, 4]).medianStep, 4);
  assert.equal(stepsOf([90, 3, 5, 1]).medianStep, 2);
  assert.equal(stepsOf([90]).medianStep, 0);
  near(stepsOf([90, 3, 5]).makespan(1), 3);
});

test('the critical path holds the longest chain in order', () => {
  const recording = recordingOf(kPass);
  const nodes = recording.analysis(0).critical.map((slice) => recording.trace.slices.node[slice]);
  assert.deepEqual(nodes, [A1, B1, C]);
});

test('idle time is the scheduler\'s while a node is ready, and else the graph\'s', () => {
  const { threads, nothingReady, scheduler } = recordingOf(kPass).analysis(0);
  // b2 is ready from 1 and begins at 6. Thread 0 is idle 5-9, thread 1 is idle 1-6 and 9-10.
  near(threads[0].scheduler, 1);
  near(threads[0].nothingReady, 3);
  near(threads[1].scheduler, 5);
  near(threads[1].nothingReady, 1);
  near(scheduler, 6);
  near(nothingReady, 4);
  for (const share of threads) near(share.busy + share.scheduler + share.nothingReady, 10);
});

test('the path goes on through the next pass, and its nodes wait for those of the pass before', () => {
  const second = kPass.map(([node, step, , thread, begin, duration]): Slice => [node, step, 1, thread, begin + 12, duration]);
  const recording = recordingOf([...kPass, ...second], 2, [1], 2);
  const step = recording.analysis(0);
  near(step.span, 12);
  const a2 = recording.sliceOf(A2, 0, 1);
  assert.deepEqual(recording.predecessors(a2), [recording.sliceOf(C, 0, 0)]);
  near(step.ready.get(a2) as number, 10);  // the end of c; it began at 12
});

test('the first pass of a step waits for the last of the step before', () => {
  const second = kPass.map(([node, , pass, thread, begin, duration]): Slice => [node, 2, pass, thread, begin + 20, duration]);
  const recording = recordingOf([...kPass, ...second], 2, [1, 2]);
  assert.deepEqual(recording.predecessors(recording.sliceOf(A1, 1, 0)), [recording.sliceOf(C, 0, 0)]);
  assert.deepEqual(recording.successors(recording.sliceOf(C, 0, 0)).sort((a, b) => a - b), [recording.sliceOf(A1, 1, 0), recording.sliceOf(A2, 1, 0)].sort((a, b) => a - b));
});

test('a thread that runs another step is not idle', () => {
  const other: Slice[] = [[A1, 2, 0, 1, 1.5, 4]];
  const { threads } = recordingOf([...kPass, ...other], 2, [1, 2]).analysis(0);
  near(threads[1].busy, 8);
  near(threads[1].scheduler, 1);
});

test('slices of surplus passes belong to no step, but to the sums of all', () => {
  const recording = recordingOf([...kPass, [A1, -1, -1, 0, 30, 7]]);
  const total = (step: number) => stageRows(recording, step).reduce((sum, row) => sum + row.total, 0);
  near(total(0), 10);
  near(total(-1), 17);
  near(recording.analysis(0).work, 10);
});

test('rows of stages: count, total, mean, worst', () => {
  assert.deepEqual(stageRows(recordingOf(kPass), 0)[1], { stage: 1, count: 2, total: 6, mean: 3, worst: 3 });
});

test('unions and counts of intervals', () => {
  const intervals = [{ begin: 4, end: 5 }, { begin: 0, end: 2 }, { begin: 1, end: 3 }, { begin: 7, end: 7 }];
  assert.deepEqual(merged(intervals), [{ begin: 0, end: 3 }, { begin: 4, end: 5 }]);
  assert.deepEqual(openCounts(intervals).map(({ count }) => count), [1, 2, 1, 0, 1, 0]);
});
