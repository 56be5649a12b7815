// The page: reads its trace, builds the views and tells them what has changed.
import { showDetails } from './details';
import { byId } from './dom';
import { showFigures } from './figures';
import { plural, time } from './format';
import { GanttView } from './gantt_view';
import { GraphView } from './graph_view';
import { installComparison, namesOf } from './comparison';
import { Palette } from './palette';
import { Recording } from './recording';
import { Change, State } from './state';
import { showStages, showThreads } from './tables';
import { installTheme, readTheme } from './theme';
import { TimeWindow } from './time_window';
import { installTip } from './tip';
import { fillSwitch, installToolbar, showChips, showColours, showFilter, showPasses, showStep, showSteps, toggleCritical } from './toolbar';
import { readTrace } from './trace';

const state = new State();
const timeWindow = new TimeWindow();
let palette = new Palette(readTheme(), []);
const graph = new GraphView(byId('graph'), state, palette);
const gantts = [0, 1].map((which) => new GanttView(byId(`gantt${which}`), which, state, timeWindow, palette));

function renewPalette(): void {
  const stages = [...new Set(state.recordings.flatMap((recording) => recording.trace.stages))];
  palette = new Palette(readTheme(), stages);
  graph.usePalette(palette);
  for (const gantt of gantts) gantt.usePalette(palette);
  if (state.recordings.length === 0) return;
  showChips(state, palette);
  showStages(byId('stagetable'), state, palette);
}

function executorOf(settings: Record<string, unknown>, threads: number): string {
  const executor = String(settings.executor ?? '');
  const description = String(settings.description ?? '');
  if (description === '') return `${executor} on ${plural(threads, 'thread')}`;
  return description.startsWith(executor) ? description : `${executor}: ${description}`;
}

function showHeader(): void {
  const { trace } = state.recordings[0];
  const { settings, machine, threads } = trace;
  const two = state.recordings.length > 1;
  byId('title').textContent = trace.scenario || 'Step trace';
  document.title = `${trace.scenario || 'Step trace'} – step trace`;
  const size = `${plural(trace.graph.count, 'node')}, ${plural(trace.graph.edges.from.length, 'edge')}`;
  const parts = [
    executorOf(settings, threads.length),
    settings.formulation, settings.integrator, settings.step_s ? `step ${settings.step_s} s` : '',
    machine.processor, machine.cores ? plural(Number(machine.cores), 'core') : '',
    trace.droppedSteps > 0 ? `${plural(trace.droppedSteps, 'step')} dropped, buffer full` : '',
  ];
  byId('subtitle').textContent = parts.filter(Boolean).join(' · ');
  byId('subtitle').title = `${byId('subtitle').textContent}\n${trace.program} ${trace.created}`;
  const notes = state.recordings.flatMap((recording, which) => recording.trace.notes.map((note) => (two ? `${'AB'[which]}: ${note}` : note)));
  byId('notes').textContent = notes.map((note) => `${note}.`).join(' ');
  byId('notes').hidden = notes.length === 0;
  byId('graphnote').textContent = size;
  const overlapping = state.recordings.some((recording) => recording.overlapping);
  byId('othersteps').textContent = overlapping ? 'overlapping steps' : 'other steps';
  byId('remove').hidden = !two;
  byId('chart1').hidden = !two;
  byId('chartname0').hidden = !two;
}

function showActive(): void {
  const two = state.recordings.length > 1;
  byId('active').hidden = !two;
  if (two) fillSwitch(byId('active'), '', ['A', 'B'], state.active, (k) => state.setActive(k));
  const { graph: shown } = state.recording.trace;
  byId('graphnote').textContent = `${plural(shown.count, 'node')}, ${plural(shown.edges.from.length, 'edge')}`;
  byId('threadtitle').textContent = two ? `Idle time of ${'AB'[state.active]}` : 'Idle time';
}

function showChartNames(): void {
  state.recordings.forEach((recording, which) => {
    const { steps } = recording.trace;
    const bold = document.createElement('b');
    bold.textContent = `${'AB'[which]}  ${state.names[which]}`;
    byId(`chartname${which}`).replaceChildren(bold, `, step ${steps[state.stepOf(which)].number}`);
  });
}

function showScope(): void {
  fillSwitch(byId('scope'), '', ['this step', 'all steps'], state.tableOfAllSteps ? 1 : 0, (k) => {
    state.tableOfAllSteps = k === 1;
    showScope();
    showStages(byId('stagetable'), state, palette);
  });
}

function showShareScale(): void {
  const host = byId('sharescale');
  host.hidden = state.colourBy !== 'share';
  const { slices } = state.recording.trace;
  const costs = new Map<number, number>();
  for (const slice of state.recording.ofStep(state.stepOf(state.active))) {
    if (state.pass >= 0 && slices.pass[slice] !== state.pass) continue;
    costs.set(slices.node[slice], (costs.get(slices.node[slice]) ?? 0) + slices.duration[slice]);
  }
  const most = [...costs.values()].reduce((a, b) => Math.max(a, b), 0);
  host.replaceChildren('0', document.createElement('i'), `${time(most)} in ${state.pass < 0 ? 'the step' : `pass ${state.pass + 1}`}`);
}

function speakSelection(): void {
  const { selected, recording } = state;
  if (!selected) return;
  const { slices, graph: nodes, threads } = recording.trace;
  const found = recording.slicesOfNode(selected.node, state.stepOf(state.active), selected.pass);
  const times = found.map((slice) => `${time(slices.duration[slice])} on ${threads[slices.thread[slice]]}`);
  byId('live').textContent = `${nodes.name[selected.node]}, ${times.join(', ') || 'not run in this step'}`;
}

function showStepData(): void {
  timeWindow.setLongest(Math.max(...state.recordings.map((recording, which) => recording.analysis(state.stepOf(which)).makespan)));
  graph.refresh();
  for (const gantt of gantts) gantt.refresh();
  showFigures(byId('figures'), state);
  showStages(byId('stagetable'), state, palette);
  showThreads(byId('threadtable'), state);
  showDetails(byId('detailtitle'), byId('details'), state);
  showChartNames();
  showShareScale();
}

function showTraces(): void {
  document.body.classList.remove('empty');
  state.pass = Math.min(state.pass, state.recording.passes - 1);
  renewPalette();
  showHeader();
  showSteps(state);
  showPasses(state);
  showColours(state);
  showScope();
  showActive();
  graph.fit(false);
  showStepData();
}

const kReactions: Record<Change, () => void> = {
  traces: showTraces,
  active: () => {
    showActive();
    renewPalette();
    graph.fit(false);
    showStepData();
  },
  step: () => {
    showStep(state);
    showStepData();
  },
  selection: () => {
    showDetails(byId('detailtitle'), byId('details'), state);
    speakSelection();
    if (state.selected) {
      graph.reveal(state.selected.node);
      gantts[state.active].reveal(state.selected);
    }
    redrawOverlays();
  },
  hover: () => redrawOverlays(),
  filter: () => {
    showFilter(state);
    showStages(byId('stagetable'), state, palette);
    redrawAll();
  },
  look: () => {
    showShareScale();
    redrawAll();
  },
};

function redrawOverlays(): void {
  graph.redrawOverlay();
  for (const gantt of gantts) gantt.redrawOverlay();
}

function redrawAll(): void {
  graph.redraw();
  for (const gantt of gantts) gantt.redraw();
}

function tipOfGraph(): string {
  const hovered = state.hovered;
  if (!hovered) return '';
  const { trace } = state.recording;
  const found = state.recording.slicesOfNode(hovered.node, state.stepOf(state.active), hovered.pass);
  const lines = found.map((slice) => {
    const pass = trace.slices.pass[slice] + 1;
    return `pass ${pass}: ${time(trace.slices.duration[slice])} on ${trace.threads[trace.slices.thread[slice]]}`;
  });
  return [trace.graph.name[hovered.node], ...lines].join('\n');
}

function installKeys(): void {
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || byId<HTMLDialogElement>('helptext').open) return;
    if (state.recordings.length === 0) return;
    if (event.key === '[') state.setStep(state.step - 1);
    else if (event.key === ']') state.setStep(state.step + 1);
    else if (event.key === 'c') toggleCritical(state);
    else if (event.key === 'Escape') state.select(null);
    else if (event.key === '?') byId<HTMLDialogElement>('helptext').showModal();
  });
}

state.onChange((change) => kReactions[change]());
installTheme(byId<HTMLButtonElement>('theme'), renewPalette);
installToolbar(state);
installComparison(state);
installKeys();
installTip(graph.canvas, tipOfGraph);
for (const gantt of gantts) installTip(gantt.canvas, () => gantt.canvas.dataset.hint ?? '');
byId('help').addEventListener('click', () => byId<HTMLDialogElement>('helptext').showModal());
byId('fitgraph').addEventListener('click', () => graph.fit());
byId('fitgantt').addEventListener('click', () => timeWindow.fit());

// This serves scripts and tests that look at the page from outside.
Object.assign(window, { spokeViewer: { state, graph, gantts, window: timeWindow } });

const data = JSON.parse(byId('spoke-trace').textContent || 'null') as unknown;
if (data !== null) {
  try {
    const recording = new Recording(readTrace(data));
    state.setTraces([recording], namesOf([recording]));
  } catch (error) {
    byId('problem').textContent = `The trace in this page cannot be shown: ${(error as Error).message}`;
    byId('problem').hidden = false;
  }
}
