// The figures of the chosen step, for two traces one above the other, with their ratios.
import { StepAnalysis } from './analysis';
import { element } from './dom';
import { percent, ratio, significant, time } from './format';
import { Recording } from './recording';
import { State } from './state';

interface Figure {
  name: string;
  meaning: string;
  value: (analysis: StepAnalysis, recording: Recording) => number;
  text: (value: number) => string;
  note?: (analysis: StepAnalysis, recording: Recording) => string;
}

const shareOfTime = (value: number, analysis: StepAnalysis, recording: Recording) =>
  percent(value / (analysis.makespan * recording.trace.threads.length));

/** The time that a step takes: its makespan, or where steps overlap the mean of all. */
const timePerStep = (analysis: StepAnalysis, recording: Recording) =>
  recording.overlapping ? recording.extent / recording.trace.steps.length : analysis.makespan;

/** The least time per step; where steps overlap, the span of one does not bound it. */
const bound = (analysis: StepAnalysis, recording: Recording) =>
  recording.overlapping ? analysis.work / recording.trace.threads.length : analysis.bound;

/** The bound with what P threads do at once on this machine, by what one does, instead of P; null if not known. */
function boundAtCapacity(analysis: StepAnalysis, recording: Recording): number | null {
  const { machine, threads } = recording.trace;
  const capacity = machine.capacity as { before: number; after: number } | null | undefined;
  if (!capacity || threads.length === 1) return null;
  const share = analysis.work / Math.min(threads.length, Math.max(capacity.before, capacity.after));
  return recording.overlapping ? share : Math.max(share, analysis.span);
}

const kFigures: Figure[] = [
  { name: 'T1, work', meaning: 'Sum of all slices of the step', value: (a) => a.work, text: time },
  { name: 'T∞, span', meaning: 'Longest path through all passes, weighted by the measured times', value: (a) => a.span, text: time,
    note: (a) => `T1 / T∞ ${significant(a.work / a.span)}` },
  { name: 'makespan', meaning: 'Last end minus first begin', value: (a) => a.makespan, text: time,
    note: (a, r) => (r.overlapping ? `${time(timePerStep(a, r))} a step` : '') },
  { name: 'bound', meaning: 'max(T1 / P, T∞): no schedule on P threads is shorter. Where steps overlap, T1 / P. At capacity: P is what all threads did of one thread’s work when they ran the same loop', value: bound, text: time,
    note: (a, r) => {
      const atCapacity = boundAtCapacity(a, r);
      return `${ratio(timePerStep(a, r) / bound(a, r))} taken` + (atCapacity ? `, ${time(atCapacity)} at capacity` : '');
    } },
  { name: 'speedup', meaning: 'T1 / makespan; where steps overlap, T1 / mean time of a step', value: (a, r) => a.work / timePerStep(a, r),
    text: ratio, note: (_, r) => `on ${r.trace.threads.length}` },
  { name: 'idle: nothing ready', meaning: 'Idle time of all threads while no node of the step could begin',
    value: (a) => a.nothingReady, text: time, note: (a, r) => shareOfTime(a.nothingReady, a, r) },
  { name: 'idle: scheduler', meaning: 'Idle time of all threads while a ready node of the step waited',
    value: (a) => a.scheduler, text: time, note: (a, r) => shareOfTime(a.scheduler, a, r) },
];

export function showFigures(host: HTMLElement, state: State): void {
  const two = state.recordings.length > 1;
  host.classList.toggle('two', two);
  const analyses = state.recordings.map((recording, which) => recording.analysis(state.stepOf(which)));
  const { recordings } = state;
  const head = element('tr', {}, two ? element('td') : null, ...kFigures.map((figure) =>
    element('th', { scope: 'col' }, element('abbr', { title: figure.meaning }, figure.name))));
  const rows = analyses.map((analysis, which) => element('tr', { 'data-trace': 'AB'[which] },
    two ? element('th', { scope: 'row', title: state.names[which] }, `${'AB'[which]}  ${state.names[which]}`) : null,
    ...kFigures.map((figure) => element('td', { 'data-figure': figure.name },
      figure.text(figure.value(analysis, recordings[which])),
      figure.note ? element('small', {}, figure.note(analysis, recordings[which])) : null))));
  if (two) {
    rows.push(element('tr', {}, element('th', { scope: 'row' }, 'B / A'), ...kFigures.map((figure) =>
      element('td', {}, ratio(figure.value(analyses[1], recordings[1]) / figure.value(analyses[0], recordings[0]))))));
  }
  host.replaceChildren(element('table', {}, element('thead', {}, head), element('tbody', {}, ...rows)));
}
