// Predecessors and successors of nodes as compressed rows, and a topological order.
import { Edges, StepGraph } from './trace';

export class Rows {
  private readonly first: Int32Array;
  private readonly entries: Int32Array;

  constructor(count: number, key: Int32Array, value: Int32Array) {
    this.first = new Int32Array(count + 1);
    for (const k of key) ++this.first[k + 1];
    for (let k = 0; k < count; ++k) this.first[k + 1] += this.first[k];
    const next = this.first.slice();
    this.entries = new Int32Array(key.length);
    for (let k = 0; k < key.length; ++k) this.entries[next[key[k]]++] = value[k];
  }

  of(k: number): Int32Array {
    return this.entries.subarray(this.first[k], this.first[k + 1]);
  }
}

export interface Adjacency {
  predecessors: Rows;
  successors: Rows;
  /** Nodes of the previous pass that a node waits for. */
  previousPass: Rows;
  nextPass: Rows;
  /** All nodes, each behind its predecessors within the pass. */
  order: Int32Array;
  /** Longest path from a source, in edges. */
  level: Int32Array;
}

function bothWays(count: number, edges: Edges): [Rows, Rows] {
  return [new Rows(count, edges.to, edges.from), new Rows(count, edges.from, edges.to)];
}

/** Throws if the edges of a pass form a cycle. */
export function adjacencyOf(graph: StepGraph): Adjacency {
  const [predecessors, successors] = bothWays(graph.count, graph.edges);
  const [previousPass, nextPass] = bothWays(graph.count, graph.nextPassEdges);
  const missing = new Int32Array(graph.count);
  for (const k of graph.edges.to) ++missing[k];
  const order = new Int32Array(graph.count);
  const level = new Int32Array(graph.count);
  let found = 0;
  for (let k = 0; k < graph.count; ++k) if (missing[k] === 0) order[found++] = k;
  for (let done = 0; done < found; ++done) {
    const node = order[done];
    for (const next of successors.of(node)) {
      level[next] = Math.max(level[next], level[node] + 1);
      if (--missing[next] === 0) order[found++] = next;
    }
  }
  if (found < graph.count) throw new Error('the edges of the step graph form a cycle');
  return { predecessors, successors, previousPass, nextPass, order, level };
}
