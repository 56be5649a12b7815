// A recorded trace in memory: columns as typed arrays, and the look-ups that the views need.

export interface Edges {
  from: Int32Array;
  to: Int32Array;
}

/** One pass of a step. Numbers of subsystems and bodies are 0-based, -1 = none. */
export interface StepGraph {
  count: number;
  stage: Int32Array;
  subsystem: Int32Array;
  body: Int32Array;
  name: string[];
  edges: Edges;
  /** From a node of one pass to a node of the next. */
  nextPassEdges: Edges;
}

export interface StepInfo {
  number: number;
  /** Time at the step's end, s. */
  time: number;
  passes: number;
}

/** Columns by slice, ordered by begin. Times in microseconds since the recording began. */
export interface Slices {
  count: number;
  node: Int32Array;
  /** Index into `Trace.steps`; -1 = a surplus pass, which belongs to no step. */
  step: Int32Array;
  pass: Int32Array;
  cluster: Int32Array;
  thread: Int32Array;
  begin: Float64Array;
  duration: Float64Array;
}

/** A step on a number of threads, as simulated. Times in microseconds. */
export interface StepOnThreads {
  threads: number;
  scheduled: number;
  byAuto: number;
  /** Of auto's plan; 1: serially. */
  clusters: number;
}

export interface MoreThreads {
  /** Steps and passes that a run of the graph makes. */
  windowSteps: number;
  passes: number;
  /** T1 and Tinf of a step, in microseconds. */
  work: number;
  span: number;
  rows: StepOnThreads[];
}

export interface Trace {
  program: string;
  created: string;
  scenario: string;
  settings: Record<string, unknown>;
  machine: Record<string, unknown>;
  subsystemWord: string;
  /** Names of subsystems by index. */
  subsystems: string[];
  stages: string[];
  graph: StepGraph;
  threads: string[];
  steps: StepInfo[];
  droppedSteps: number;
  /** What else to know of how the steps were made, a sentence each. */
  notes: string[];
  /** What more threads would gain; null: it was not asked. */
  moreThreads: MoreThreads | null;
  slices: Slices;
}

/** What a subsystem is called; by its number in files that have no names. */
export function subsystemName(trace: Trace, subsystem: number): string {
  return trace.subsystems[subsystem] ?? `${trace.subsystemWord} ${subsystem + 1}`;
}

export class TraceError extends Error {}

type Json = Record<string, unknown>;

function objectAt(parent: Json, key: string): Json {
  const value = parent[key];
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    throw new TraceError(`"${key}" is missing or not an object`);
  }
  return value as Json;
}

function listAt(parent: Json, key: string): unknown[] {
  const value = parent[key];
  if (!Array.isArray(value)) throw new TraceError(`"${key}" is missing or not a list`);
  return value;
}

function textAt(parent: Json, key: string): string {
  const value = parent[key];
  return value === undefined || value === null ? '' : String(value);
}

/** A column of whole numbers in [least, limit). */
function indices(parent: Json, key: string, least: number, limit: number): Int32Array {
  const values = listAt(parent, key);
  const column = new Int32Array(values.length);
  for (let k = 0; k < values.length; ++k) {
    const value = values[k];
    if (!Number.isInteger(value) || (value as number) < least || (value as number) >= limit) {
      throw new TraceError(`"${key}"[${k}] is ${String(value)}, not a whole number from ${least} to ${limit - 1}`);
    }
    column[k] = value as number;
  }
  return column;
}

function times(parent: Json, key: string): Float64Array {
  const column = Float64Array.from(listAt(parent, key) as number[]);
  const wrong = column.findIndex((value) => !Number.isFinite(value));
  if (wrong >= 0) throw new TraceError(`"${key}"[${wrong}] is not a number`);
  return column;
}

function equalLengths(what: string, columns: { length: number }[]): number {
  const count = columns[0].length;
  if (columns.some((column) => column.length !== count)) {
    throw new TraceError(`the columns of "${what}" differ in length`);
  }
  return count;
}

function readEdges(parent: Json, key: string, nodes: number): Edges {
  const edges = objectAt(parent, key);
  const from = indices(edges, 'from', 0, nodes);
  const to = indices(edges, 'to', 0, nodes);
  equalLengths(key, [from, to]);
  return { from, to };
}

const kMany = 2 ** 31 - 1;

function readGraph(source: Json, stages: number): StepGraph {
  const stage = indices(source, 'stage', 0, stages);
  const subsystem = indices(source, 'subsystem', -1, kMany);
  const body = indices(source, 'body', -1, kMany);
  const name = listAt(source, 'name').map(String);
  const count = equalLengths('graph', [stage, subsystem, body, name]);
  return {
    count, stage, subsystem, body, name,
    edges: readEdges(source, 'edges', count),
    nextPassEdges: readEdges(source, 'next_pass_edges', count),
  };
}

function readSteps(source: unknown[]): StepInfo[] {
  return source.map((entry) => {
    const step = entry as Json;
    return { number: Number(step.step), time: Number(step.time_s), passes: Number(step.passes) };
  });
}

function readMoreThreads(source: Json): MoreThreads {
  const rows = listAt(source, 'predictions').map((entry) => {
    const row = entry as Json;
    return {
      threads: Number(row.threads), scheduled: 1e6 * Number(row.scheduled_s),
      byAuto: 1e6 * Number(row.auto_s), clusters: Number(row.auto_clusters),
    };
  });
  return {
    windowSteps: Number(source.window_steps), passes: Number(source.passes_per_run),
    work: 1e6 * Number(source.work_s), span: 1e6 * Number(source.span_s), rows,
  };
}

/** The columns reordered by begin, unless they are ordered already. */
function orderedByBegin(slices: Slices): Slices {
  const { begin, count } = slices;
  let ordered = true;
  for (let k = 1; k < count && ordered; ++k) ordered = begin[k - 1] <= begin[k];
  if (ordered) return slices;
  const order = Int32Array.from({ length: count }, (_, k) => k).sort((a, b) => begin[a] - begin[b]);
  return {
    count,
    node: order.map((k) => slices.node[k]),
    step: order.map((k) => slices.step[k]),
    pass: order.map((k) => slices.pass[k]),
    cluster: order.map((k) => slices.cluster[k]),
    thread: order.map((k) => slices.thread[k]),
    begin: Float64Array.from(order, (k) => slices.begin[k]),
    duration: Float64Array.from(order, (k) => slices.duration[k]),
  };
}

function readSlices(source: Json, graph: StepGraph, threads: number, steps: StepInfo[]): Slices {
  const indexOf = new Map(steps.map((step, index) => [step.number, index]));
  const node = indices(source, 'node', 0, graph.count);
  const step = indices(source, 'step', -1, kMany);
  const pass = indices(source, 'pass', -1, 1024);
  const cluster = indices(source, 'cluster', -1, kMany);
  const thread = indices(source, 'thread', 0, threads);
  const begin = times(source, 'begin_us');
  const duration = times(source, 'duration_us');
  const count = equalLengths('slices', [node, step, pass, cluster, thread, begin, duration]);
  for (let k = 0; k < count; ++k) step[k] = indexOf.get(step[k]) ?? -1;
  return orderedByBegin({ count, node, step, pass, cluster, thread, begin, duration });
}

/** Reads the data of a trace.html. Throws TraceError with what is wrong. */
export function readTrace(data: unknown): Trace {
  if (typeof data !== 'object' || data === null) throw new TraceError('it holds no trace');
  const source = data as Json;
  if (source.format !== 'spoke-trace') throw new TraceError('it is not a trace of Spoke');
  if (source.version !== 1) {
    throw new TraceError(`its version is ${String(source.version)}; this page reads version 1`);
  }
  const stages = listAt(source, 'stages').map(String);
  const graph = readGraph(objectAt(source, 'graph'), stages.length);
  const threads = listAt(source, 'threads').map(String);
  const steps = readSteps(listAt(source, 'steps'));
  if (steps.length === 0) throw new TraceError('it holds no complete step');
  return {
    program: textAt(source, 'program'),
    created: textAt(source, 'created'),
    scenario: textAt(source, 'scenario'),
    settings: objectAt(source, 'settings'),
    machine: (source.machine ?? {}) as Json,
    subsystemWord: textAt(source, 'subsystem_word') || 'subsystem',
    subsystems: source.subsystems === undefined ? [] : listAt(source, 'subsystems').map(String),
    stages, graph, threads, steps,
    droppedSteps: Number(source.dropped_steps ?? 0),
    notes: source.notes === undefined ? [] : listAt(source, 'notes').map(String),
    moreThreads: source.more_threads ? readMoreThreads(objectAt(source, 'more_threads')) : null,
    slices: readSlices(objectAt(source, 'slices'), graph, threads.length, steps),
  };
}
