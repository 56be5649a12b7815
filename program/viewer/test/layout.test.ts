import assert from 'node:assert/strict';
import { test } from 'node:test';
import { adjacencyOf } from '../src/adjacency';
import { layoutGraph } from '../src/layout';
import { stack } from '../src/brackets';
import { tickStep } from '../src/ticks';
import { StepGraph } from '../src/trace';
import { A1, A2, B1, B2, C, recordingOf } from './small_trace';

test('levels are longest paths, and a cycle is refused', () => {
  const { graph } = recordingOf([]).trace;
  assert.deepEqual([...adjacencyOf(graph).level], [0, 1, 0, 1, 2]);
  const circle: StepGraph = { ...graph, edges: { from: Int32Array.of(A1, B1), to: Int32Array.of(B1, A1) } };
  assert.throws(() => adjacencyOf(circle), /cycle/);
});

test('edges go down, lanes stand side by side, nodes of no lane are centred', () => {
  const { layout, trace } = recordingOf([]);
  trace.graph.edges.from.forEach((from, k) => assert.ok(layout.y[from] < layout.y[trace.graph.edges.to[k]]));
  assert.ok(layout.x[A1] < layout.x[A2] && layout.x[B1] < layout.x[B2]);
  assert.equal(layout.x[C], layout.totalWidth / 2);
});

/** A wide pass: one source, `bodies` nodes in parallel, in each of `blades` lanes. */
function fan(blades: number, bodies: number): StepGraph {
  const graph = { stage: [] as number[], subsystem: [] as number[], body: [] as number[], from: [] as number[], to: [] as number[] };
  for (let blade = 0; blade < blades; ++blade) {
    const source = graph.stage.push(0) - 1;
    graph.subsystem.push(blade);
    graph.body.push(-1);
    for (let body = 0; body < bodies; ++body) {
      graph.from.push(source);
      graph.to.push(graph.stage.push(1) - 1);
      graph.subsystem.push(blade);
      graph.body.push(body);
    }
  }
  const none = { from: new Int32Array(0), to: new Int32Array(0) };
  return {
    count: graph.stage.length, stage: Int32Array.from(graph.stage), subsystem: Int32Array.from(graph.subsystem),
    body: Int32Array.from(graph.body), name: graph.stage.map(String),
    edges: { from: Int32Array.from(graph.from), to: Int32Array.from(graph.to) }, nextPassEdges: none,
  };
}

for (const [blades, bodies] of [[1, 3], [3, 4], [24, 39], [2, 200]]) {
  test(`no node covers another: ${blades} blades of ${bodies}`, () => {
    const graph = fan(blades, bodies);
    const { x, y, width, nodeHeight, totalWidth, totalHeight } = layoutGraph(graph, adjacencyOf(graph));
    for (let a = 0; a < graph.count; ++a) {
      assert.ok(x[a] - width[a] / 2 >= 0 && x[a] + width[a] / 2 <= totalWidth && y[a] <= totalHeight);
      for (let b = 0; b < a; ++b) {
        assert.ok(Math.abs(x[a] - x[b]) >= (width[a] + width[b]) / 2 || Math.abs(y[a] - y[b]) >= nodeHeight);
      }
    }
  });
}

test('overlapping bars get lines of their own, the first ones first, on three lines at most', () => {
  const bars = [[4, 8], [0, 4], [3, 6], [2, 9], [5, 7]].map(([begin, end], number) => ({ begin, end, number }));
  assert.deepEqual(stack(bars).map((bar) => [bar.number, bar.line]), [[0, 0], [1, 0], [2, 1], [3, 2]]);
});

test('ticks stand at 1, 2 or 5 times a power of ten', () => {
  assert.deepEqual([0.013, 0.3, 1, 7].map((perPixel) => Number(tickStep(perPixel, 10).toPrecision(6))), [0.2, 5, 10, 100]);
});
