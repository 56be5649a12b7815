// A trace together with data derived from it once: adjacency, slices by thread, step and node.
import { Adjacency, adjacencyOf, Rows } from './adjacency';
import { analyseStep, StepAnalysis } from './analysis';
import { GraphLayout, layoutGraph } from './layout';
import { Trace } from './trace';

export class Recording {
  readonly adjacency: Adjacency;
  readonly layout: GraphLayout;
  /** Most passes of a step. */
  readonly passes: number;
  readonly byName: Map<string, number>;
  /** Steps overlap, for one run of the executor makes several: a window. */
  readonly overlapping: boolean;
  /** First begin and last end of each step, us. */
  readonly stepBegin: Float64Array;
  readonly stepEnd: Float64Array;
  /** The step of median makespan, of two in the middle the longer one, as `spoke trace` prints it. */
  readonly medianStep: number;
  private readonly threadRows: Rows;
  private readonly stepRows: Rows;
  private readonly places: Int32Array;
  private readonly analyses = new Map<number, StepAnalysis>();

  constructor(readonly trace: Trace) {
    const { slices, graph, steps, threads } = trace;
    this.adjacency = adjacencyOf(graph);
    this.layout = layoutGraph(graph, this.adjacency);
    this.byName = new Map(graph.name.map((name, node) => [name, node]));
    this.overlapping = Number(trace.settings.window_steps) > 1;
    const all = Int32Array.from({ length: slices.count }, (_, k) => k);
    this.threadRows = new Rows(threads.length, slices.thread, all);
    const inSteps = all.filter((k) => slices.step[k] >= 0 && slices.pass[k] >= 0);
    this.stepRows = new Rows(steps.length, inSteps.map((k) => slices.step[k]), inSteps);
    this.passes = inSteps.reduce((most, k) => Math.max(most, slices.pass[k] + 1), 1);
    this.places = new Int32Array(steps.length * this.passes * graph.count).fill(-1);
    this.stepBegin = new Float64Array(steps.length).fill(Infinity);
    this.stepEnd = new Float64Array(steps.length).fill(-Infinity);
    for (const k of inSteps) {
      const step = slices.step[k];
      this.places[this.place(slices.node[k], step, slices.pass[k])] = k;
      this.stepBegin[step] = Math.min(this.stepBegin[step], slices.begin[k]);
      this.stepEnd[step] = Math.max(this.stepEnd[step], slices.begin[k] + slices.duration[k]);
    }
    const byMakespan = steps.map((_, step) => step).sort((a, b) => this.makespan(a) - this.makespan(b));
    this.medianStep = byMakespan[steps.length >> 1];
  }

  private place(node: number, step: number, pass: number): number {
    return (step * this.passes + pass) * this.trace.graph.count + node;
  }

  /** Of all steps: from the first begin to the last end, us. */
  get extent(): number {
    return this.stepEnd.reduce((a, b) => Math.max(a, b), -Infinity) - this.stepBegin.reduce((a, b) => Math.min(a, b), Infinity);
  }

  /** From the first begin to the last end of a step, us. */
  makespan(step: number): number {
    return Math.max(0, this.stepEnd[step] - this.stepBegin[step]);
  }

  /** Slices of a thread or a step, ordered by begin. */
  ofThread(thread: number): Int32Array {
    return this.threadRows.of(thread);
  }
  ofStep(step: number): Int32Array {
    return this.stepRows.of(step);
  }

  /** The slice of a node in a pass of a step; -1 = none. */
  sliceOf(node: number, step: number, pass: number): number {
    if (step < 0 || pass < 0 || pass >= this.passes) return -1;
    return this.places[this.place(node, step, pass)];
  }

  /** The slices of a node in a step, by pass; in one pass only if `pass` is not -1. */
  slicesOfNode(node: number, step: number, pass = -1): number[] {
    const found: number[] = [];
    for (let p = 0; p < this.passes; ++p) {
      const slice = pass < 0 || pass === p ? this.sliceOf(node, step, p) : -1;
      if (slice >= 0) found.push(slice);
    }
    return found;
  }

  end(slice: number): number {
    return this.trace.slices.begin[slice] + this.trace.slices.duration[slice];
  }

  /** The slice of a node in the pass before; that of the last pass of the step before, if need be. */
  private inPreviousPass(node: number, step: number, pass: number): number {
    if (pass > 0) return this.sliceOf(node, step, pass - 1);
    for (let p = this.passes - 1; p >= 0 && step > 0; --p) {
      const slice = this.sliceOf(node, step - 1, p);
      if (slice >= 0) return slice;
    }
    return -1;
  }

  /** The slices that a slice waits for. */
  predecessors(slice: number): number[] {
    const { node, step, pass } = this.trace.slices;
    const [n, s, p] = [node[slice], step[slice], pass[slice]];
    const found: number[] = [];
    for (const other of this.adjacency.predecessors.of(n)) found.push(this.sliceOf(other, s, p));
    for (const other of this.adjacency.previousPass.of(n)) found.push(this.inPreviousPass(other, s, p));
    return found.filter((k) => k >= 0);
  }

  private inNextPass(node: number, step: number, pass: number): number {
    const slice = this.sliceOf(node, step, pass + 1);
    if (slice >= 0 || step + 1 >= this.trace.steps.length) return slice;
    return this.sliceOf(node, step + 1, 0);
  }

  /** The slices that wait for a slice. */
  successors(slice: number): number[] {
    const { node, step, pass } = this.trace.slices;
    const [n, s, p] = [node[slice], step[slice], pass[slice]];
    const found: number[] = [];
    for (const other of this.adjacency.successors.of(n)) found.push(this.sliceOf(other, s, p));
    for (const other of this.adjacency.nextPass.of(n)) found.push(this.inNextPass(other, s, p));
    return found.filter((k) => k >= 0);
  }

  analysis(step: number): StepAnalysis {
    let analysis = this.analyses.get(step);
    if (!analysis) {
      analysis = analyseStep(this, step);
      this.analyses.set(step, analysis);
    }
    return analysis;
  }
}
