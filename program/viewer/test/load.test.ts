import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadText } from '../src/load';
import { readTrace, TraceError } from '../src/trace';
import { A1, B1, Slice, smallData } from './small_trace';

const kSlices: Slice[] = [[B1, 1, 0, 1, 3, 1], [A1, 1, 0, 0, 1, 2]];

test('slices are put in order of their begin', () => {
  const { slices } = readTrace(smallData(kSlices));
  assert.deepEqual([...slices.node], [A1, B1]);
  assert.deepEqual([...slices.thread], [0, 1]);
  assert.deepEqual([...slices.duration], [2, 1]);
});

test('Chrome trace events give the same slices', () => {
  const data = smallData(kSlices);
  const { slices: _, ...spoke } = data;
  const named = [[7, 'thread 1'], [9, 'thread 0']].map(([tid, name]) => ({ ph: 'M', name: 'thread_name', tid, args: { name } }));
  const events = kSlices.map(([node, step, pass, thread, ts, dur]) => (
    { ph: 'X', cat: 'a', tid: thread === 1 ? 7 : 9, ts, dur, args: { node, step, pass, cluster: -1 } }));
  const whole = { ph: 'X', cat: 'step', tid: 9, ts: 0, dur: 9, args: { step: 1 } };
  const text = JSON.stringify({ traceEvents: [...named, whole, ...events], spoke });
  assert.deepEqual(loadText(text).slices, readTrace(data).slices);
});

test('notes are read, and a trace without them has none', () => {
  assert.deepEqual(readTrace({ ...smallData(kSlices), notes: ['one', 'two'] }).notes, ['one', 'two']);
  assert.deepEqual(readTrace(smallData(kSlices)).notes, []);
});

test('what more threads would gain is read, in microseconds', () => {
  const predictions = [{ threads: 4, scheduled_s: 2e-6, auto_s: 3e-6, auto_clusters: 5 }];
  const more = { window_steps: 9, passes_per_run: 18, work_s: 6e-6, span_s: 1e-6, predictions };
  const read = readTrace({ ...smallData(kSlices), more_threads: more }).moreThreads;
  assert.deepEqual(read?.rows, [{ threads: 4, scheduled: 2, byAuto: 3, clusters: 5 }]);
  assert.deepEqual([read?.windowSteps, read?.passes, read?.work, read?.span], [9, 18, 6, 1]);
  assert.equal(readTrace({ ...smallData(kSlices), more_threads: null }).moreThreads, null);
  assert.equal(readTrace(smallData(kSlices)).moreThreads, null);
});

const kWrong: [string, (data: any) => unknown, RegExp][] = [
  ['another format', (data) => ({ ...data, format: 'x' }), /not a trace of Spoke/],
  ['another version', (data) => ({ ...data, version: 2 }), /version is 2/],
  ['no steps', (data) => ({ ...data, steps: [] }), /no complete step/],
  ['a node that is not there', (data) => ({ ...data, slices: { ...data.slices, node: [0, 5] } }), /"node"\[1\] is 5/],
  ['columns of different lengths', (data) => ({ ...data, slices: { ...data.slices, pass: [0] } }), /"slices" differ/],
  ['times that are none', (data) => ({ ...data, slices: { ...data.slices, begin_us: [0, 'x'] } }), /"begin_us"\[1\]/],
  ['nothing', () => null, /no trace/],
];
for (const [name, change, message] of kWrong) {
  test(`refused: ${name}`, () => assert.throws(() => readTrace(change(smallData(kSlices))), (error) => error instanceof TraceError && message.test(error.message)));
}

test('refused: text that is no JSON, and events that are not of Spoke', () => {
  assert.throws(() => loadText('{"a"'), /neither a trace.html nor JSON/);
  assert.throws(() => loadText('{"traceEvents":[]}'), /not written by Spoke/);
});
