// The figures of the chosen step; of two traces one above the other, with their ratios.
import { StepAnalysis } from './analysis';
import { element } from './dom';
import { percent, ratio, significant, time } from './format';
import { State } from './state';

interface Figure {
  name: string;
  meaning: string;
  value: (analysis: StepAnalysis, threads: number) => number;
  text: (value: number) => string;
  note?: (analysis: StepAnalysis, threads: number) => string;
}

const shareOfTime = (value: number, analysis: StepAnalysis, threads: number) =>
  percent(value / (analysis.makespan * threads));

const kFigures: Figure[] = [
  { name: 'T1, work', meaning: 'Sum of all slices of the step', value: (a) => a.work, text: time },
  { name: 'T∞, span', meaning: 'Longest path through all passes, weighted by the measured times', value: (a) => a.span, text: time,
    note: (a) => `T1 / T∞ ${significant(a.work / a.span)}` },
  { name: 'makespan', meaning: 'Last end minus first begin', value: (a) => a.makespan, text: time },
  { name: 'bound', meaning: 'max(T1 / P, T∞): no schedule on P threads is shorter', value: (a) => a.bound, text: time,
    note: (a) => `${ratio(a.makespan / a.bound)} taken` },
  { name: 'speedup', meaning: 'T1 / makespan', value: (a) => a.speedup, text: ratio, note: (_, p) => `on ${p}` },
  { name: 'idle: nothing ready', meaning: 'Idle time of all threads while no node of the step could begin',
    value: (a) => a.nothingReady, text: time, note: (a, p) => shareOfTime(a.nothingReady, a, p) },
  { name: 'idle: scheduler', meaning: 'Idle time of all threads while a ready node of the step waited',
    value: (a) => a.scheduler, text: time, note: (a, p) => shareOfTime(a.scheduler, a, p) },
];

export function showFigures(host: HTMLElement, state: State): void {
  const two = state.recordings.length > 1;
  host.classList.toggle('two', two);
  const analyses = state.recordings.map((recording, which) => recording.analysis(state.stepOf(which)));
  const threads = state.recordings.map((recording) => recording.trace.threads.length);
  const head = element('tr', {}, two ? element('td') : null, ...kFigures.map((figure) =>
    element('th', { scope: 'col' }, element('abbr', { title: figure.meaning }, figure.name))));
  const rows = analyses.map((analysis, which) => element('tr', { 'data-trace': 'AB'[which] },
    two ? element('th', { scope: 'row', title: state.names[which] }, `${'AB'[which]}  ${state.names[which]}`) : null,
    ...kFigures.map((figure) => element('td', { 'data-figure': figure.name },
      figure.text(figure.value(analysis, threads[which])),
      figure.note ? element('small', {}, figure.note(analysis, threads[which])) : null))));
  if (two) {
    rows.push(element('tr', {}, element('th', { scope: 'row' }, 'B / A'), ...kFigures.map((figure) =>
      element('td', {}, ratio(figure.value(analyses[1], threads[1]) / figure.value(analyses[0], threads[0]))))));
  }
  host.replaceChildren(element('table', {}, element('thead', {}, head), element('tbody', {}, ...rows)));
}
