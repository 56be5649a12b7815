// Makes traces of rotors with prescribed hub as `spoke trace` writes them, by a schedule simulated with
// random times: what the tests of the trace page look at. Same options, same trace.
//   node rotor_trace.mjs PAGE.html OUT.html [KEY=VALUE]...    puts one into a built page

import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const STAGES = ['hub motion', 'coordinates', 'position', 'velocity', 'mass', 'inverse', 'effective',
  'hub solve', 'multipliers', 'recovery', 'finish', 'sensors'];
const COSTS = [0.12, 0.25, 0.6, 0.9, 1.6, 2.9, 1.4, 0.5, 0.7, 1.3, 0.3, 0.35];

function makeRandom(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** One pass: the nodes of each blade's chain, and the hub's solve behind all. */
function makeGraph(blades, bodies) {
  const graph = { stage: [], subsystem: [], body: [], name: [], edges: { from: [], to: [] },
    next_pass_edges: { from: [], to: [] } };
  const add = (stage, blade, body, ...before) => {
    const node = graph.stage.push(STAGES.indexOf(stage)) - 1;
    graph.subsystem.push(blade);
    graph.body.push(body);
    graph.name.push([blade < 0 ? '' : `blade ${blade + 1}`, body < 0 ? '' : `body ${body + 1}`, stage].filter(Boolean).join(' / '));
    for (const from of before) {
      graph.edges.from.push(from);
      graph.edges.to.push(node);
    }
    return node;
  };
  const perBody = Array.from({ length: bodies }, (_, body) => body);
  const finishes = [];
  for (let blade = 0; blade < blades; ++blade) {
    const motion = add('hub motion', blade, -1);
    const coordinates = add('coordinates', blade, -1);
    const position = add('position', blade, -1, coordinates);
    const velocity = add('velocity', blade, -1, motion, position);
    const mass = perBody.map((body) => add('mass', blade, body, velocity));
    const inverse = perBody.map((body) => add('inverse', blade, body, mass[body]));
    const effective = add('effective', blade, -1, ...inverse);
    const multipliers = add('multipliers', blade, -1, effective);
    const recovery = perBody.map((body) => add('recovery', blade, body, multipliers));
    const finish = add('finish', blade, -1, ...recovery);
    const sensors = add('sensors', blade, -1, finish);
    graph.next_pass_edges.from.push(sensors, finish);
    graph.next_pass_edges.to.push(coordinates, motion);
    finishes.push(finish);
  }
  add('hub solve', -1, -1, ...finishes);
  return graph;
}

/** All runs of nodes with what they wait for. Unless `window`, a step begins when the one before has ended. */
function makeRuns(graph, steps, passes, window) {
  const runs = [];
  const place = new Map();
  const nodes = graph.stage.length;
  const solve = nodes - 1;
  for (let step = 0; step < steps; ++step) {
    const barrier = runs.length;
    for (let pass = 0; pass < passes; ++pass) {
      for (let node = 0; node < nodes; ++node) {
        if (node === solve && pass < passes - 1) continue;
        place.set((step * passes + pass) * nodes + node, runs.length);
        runs.push({ node, step, pass, missing: 0, after: [], ready: 0 });
      }
    }
    if (!window && step > 0) {
      const last = place.get(((step - 1) * passes + passes - 1) * nodes + solve);
      for (let k = barrier; k < runs.length; ++k) link(runs, last, k);
    }
  }
  const at = (round, node) => place.get(round * nodes + node);
  for (let round = 0; round < steps * passes; ++round) {
    graph.edges.from.forEach((from, k) => link(runs, at(round, from), at(round, graph.edges.to[k])));
    if (round === 0) continue;
    const { from, to } = graph.next_pass_edges;
    from.forEach((node, k) => link(runs, at(round - 1, node), at(round, to[k])));
  }
  return runs;
}

function link(runs, from, to) {
  if (from === undefined || to === undefined) return;
  runs[from].after.push(to);
  ++runs[to].missing;
}

/** A queue of the runs that are ready, the earliest first. */
class Ready {
  heap = [];
  constructor(runs) { this.runs = runs; }
  less(a, b) { return this.runs[a].ready - this.runs[b].ready || a - b; }
  push(run) {
    const { heap } = this;
    let k = heap.push(run) - 1;
    for (let up = (k - 1) >> 1; k > 0 && this.less(heap[k], heap[up]) < 0; k = up, up = (k - 1) >> 1) {
      [heap[k], heap[up]] = [heap[up], heap[k]];
    }
  }
  pop() {
    const { heap } = this;
    const top = heap[0];
    const last = heap.pop();
    if (heap.length > 0) heap[0] = last;
    for (let k = 0; ;) {
      let least = k;
      for (const child of [2 * k + 1, 2 * k + 2]) {
        if (child < heap.length && this.less(heap[child], heap[least]) < 0) least = child;
      }
      if (least === k) return top;
      [heap[k], heap[least]] = [heap[least], heap[k]];
      k = least;
    }
  }
}

const round3 = (time) => Math.round(time * 1000) / 1000;

/** Runs all on threads; `byBlade` gives each blade a thread of its own, as nested OpenMP teams do. */
function schedule(runs, graph, threads, random, byBlade) {
  const ready = new Ready(runs);
  runs.forEach((run, k) => run.missing === 0 && ready.push(k));
  const free = new Float64Array(threads);
  const slices = [];
  for (let done = 0; done < runs.length; ++done) {
    const run = runs[ready.pop()];
    const blade = graph.subsystem[run.node];
    let thread = byBlade ? Math.max(0, blade) % threads : 0;
    for (let k = 0; k < threads && !byBlade; ++k) if (free[k] < free[thread]) thread = k;
    const begin = round3(Math.max(free[thread], run.ready) + 0.04 + 0.12 * random() + (random() < 0.02 ? 1.2 : 0));
    const duration = round3(COSTS[graph.stage[run.node]] * (0.85 + 0.3 * random() + (random() < 0.01 ? 1.5 : 0)));
    free[thread] = round3(begin + duration);
    slices.push({ node: run.node, step: run.step, pass: run.pass, thread, begin, duration });
    for (const next of run.after) {
      runs[next].ready = Math.max(runs[next].ready, free[thread]);
      if (--runs[next].missing === 0) ready.push(next);
    }
  }
  return slices.sort((a, b) => a.begin - b.begin);
}

/** The data of a trace.html. */
export function rotorTrace({ blades = 3, bodies = 4, threads = 2, steps = 20, passes = 3, window = false, byBlade = false,
  executor = 'flow_graph', firstStep = 1201, seed = 1 } = {}) {
  const graph = makeGraph(blades, bodies);
  const slices = schedule(makeRuns(graph, steps, passes, window), graph, threads, makeRandom(seed), byBlade);
  const column = (key) => slices.map((slice) => slice[key]);
  return {
    format: 'spoke-trace', version: 1, program: 'Spoke 0.1.0', created: '2026-11-21T15:00:00Z',
    scenario: `rotor ${blades}x${bodies}`,
    settings: { executor, description: byBlade ? 'one team member per blade' : 'oneTBB, every node a task', threads: String(threads),
      formulation: 'structured', integrator: 'generalized_alpha', step_s: 0.001, window_steps: window ? 8 : 1 },
    machine: { processor: 'simulated processor', cores: threads, load: 0.4 },
    subsystem_word: 'blade', stages: STAGES, graph,
    threads: Array.from({ length: threads }, (_, k) => (k === 0 ? 'main' : `worker ${k}`)),
    steps: Array.from({ length: steps }, (_, k) => ({ step: firstStep + k, time_s: (firstStep + k) / 1000, passes })),
    dropped_steps: 0, recording_cost_s: 3e-8,
    slices: {
      node: column('node'), step: slices.map((slice) => firstStep + slice.step), pass: column('pass'),
      cluster: slices.map((slice) => (byBlade ? graph.subsystem[slice.node] : -1)), thread: column('thread'),
      begin_us: column('begin'), duration_us: column('duration'),
    },
  };
}

/** The same as Chrome trace events with all but the slices in the key "spoke". */
export function asChromeTrace(data) {
  const { slices, ...spoke } = data;
  const names = data.threads.map((name, k) => ({ ph: 'M', name: 'thread_name', pid: 1, tid: k + 1, args: { name } }));
  const events = slices.node.map((node, k) => ({
    ph: 'X', name: data.graph.name[node], cat: data.stages[data.graph.stage[node]], pid: 1, tid: slices.thread[k] + 1,
    ts: slices.begin_us[k], dur: slices.duration_us[k],
    args: { node, step: slices.step[k], pass: slices.pass[k], cluster: slices.cluster[k] },
  }));
  const step = { ph: 'X', name: 'step', cat: 'step', pid: 1, tid: 0, ts: 0, dur: 1, args: {} };
  return { traceEvents: [...names, step, ...events], spoke };
}

/** A built page with data in it. */
export function pageWith(page, data) {
  const [before, after] = page.split('<script type="application/json" id="spoke-trace">null</script>');
  const json = JSON.stringify(data).replaceAll('</', '<\\/');
  return `${before}<script type="application/json" id="spoke-trace">${json}</script>${after}`;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [page, out, ...options] = process.argv.slice(2);
  const read = (value) => (/^[\d.]+$|^true$|^false$/.test(value) ? JSON.parse(value) : value);
  const chosen = Object.fromEntries(options.map((option) => option.split('=')).map(([key, value]) => [key, read(value)]));
  writeFileSync(out, pageWith(readFileSync(page, 'utf8'), rotorTrace(chosen)));
}
