// The table of stages, the table of threads, and that of more threads.
import { stageRows } from './analysis';
import { element } from './dom';
import { percent, plural, ratio, time } from './format';
import { Palette, swatchStyle } from './palette';
import { State } from './state';
import { MoreThreads } from './trace';

function headRow(names: string[]): HTMLElement {
  return element('thead', {}, element('tr', {}, ...names.map((name, k) =>
    element('th', { scope: 'col', class: k > 0 && name !== '' ? 'number' : null }, name))));
}

function number(text: string, value?: number): HTMLElement {
  return element('td', { class: 'number', 'data-value': value ?? null }, text);
}

/** Totals of another trace by the stage's name. */
function otherTotals(state: State): Map<string, number> | null {
  if (state.recordings.length < 2) return null;
  const other = 1 - state.active;
  const recording = state.recordings[other];
  const rows = stageRows(recording, state.tableOfAllSteps ? -1 : state.stepOf(other));
  return new Map(rows.map((row) => [recording.trace.stages[row.stage], row.total]));
}

export function showStages(host: HTMLElement, state: State, palette: Palette): void {
  const { recording } = state;
  const { stages } = recording.trace;
  const rows = stageRows(recording, state.tableOfAllSteps ? -1 : state.stepOf(state.active)).filter((row) => row.count > 0);
  const others = otherTotals(state);
  const [own, other] = state.active === 0 ? ['A', 'B'] : ['B', 'A'];
  const total = rows.reduce((sum, row) => sum + row.total, 0);
  const most = rows.reduce((largest, row) => Math.max(largest, row.total), 0);
  const body = rows.map((row) => {
    const name = stages[row.stage];
    const faded = state.stages.size > 0 && !state.stages.has(name);
    return element('tr', { class: faded ? 'faded' : null, 'data-stage': name },
      element('th', { scope: 'row' }, element('i', { style: swatchStyle(palette, name) }), name),
      number(String(row.count), row.count), number(time(row.total), row.total),
      others ? number(time(others.get(name) ?? NaN), others.get(name)) : null,
      others ? number(ratio((others.get(name) ?? NaN) / row.total)) : null,
      number(time(row.mean), row.mean), number(time(row.worst), row.worst),
      others ? null : number(percent(row.total / total)),
      others ? null : element('td', { class: 'meter' },
        element('span', { class: 'bar', style: `width:${(100 * row.total) / most}%` })));
  });
  const otherTotal = others ? [...others.values()].reduce((sum, value) => sum + value, 0) : 0;
  const foot = element('tr', {}, element('th', { scope: 'row' }, 'all'),
    number(String(rows.reduce((sum, row) => sum + row.count, 0))), number(time(total), total),
    others ? number(time(otherTotal), otherTotal) : null, others ? number(ratio(otherTotal / total)) : null,
    element('td'), element('td'), others ? null : element('td'), others ? null : element('td'));
  const names = others
    ? ['stage', 'count', `total ${own}`, `total ${other}`, `${other} / ${own}`, 'mean', 'worst']
    : ['stage', 'count', 'total', 'mean', 'worst', 'share', ''];
  host.replaceChildren(element('table', {}, headRow(names), element('tbody', {}, ...body), element('tfoot', {}, foot)));
}

function moreThreadsTable({ windowSteps, passes, work, span, rows }: MoreThreads): HTMLElement {
  const runs = windowSteps > 1 ? `windows of ${windowSteps} steps` : `runs of ${plural(passes, 'pass')}`;
  const body = rows.map((row) => element('tr', { title: `auto: ${row.clusters === 1 ? 'serial' : plural(row.clusters, 'cluster')}` },
    element('th', { scope: 'row' }, String(row.threads)), number(time(row.scheduled), row.scheduled), number(ratio(work / row.scheduled)),
    number(time(row.byAuto), row.byAuto), number(ratio(work / row.byAuto))));
  return element('table', { id: 'morethreads' },
    element('caption', {}, `More threads, simulated in ${runs}: at most ${ratio(work / span)}`),
    headRow(['threads', 'schedule', 'speedup', 'auto', 'speedup']), element('tbody', {}, ...body));
}

export function showThreads(host: HTMLElement, state: State): void {
  const analysis = state.recording.analysis(state.stepOf(state.active));
  const { threads, moreThreads } = state.recording.trace;
  const split = (busy: number, scheduler: number, all: number) => element('td', { class: 'splitted' },
    element('div', { class: 'split' }, element('span', { style: `width:${(100 * busy) / all}%` }),
      element('span', { style: `width:${(100 * scheduler) / all}%` })));
  const rows = analysis.threads.map((share, k) => element('tr', {},
    element('th', { scope: 'row' }, threads[k]), split(share.busy, share.scheduler, analysis.makespan),
    number(percent(share.busy / analysis.makespan), share.busy),
    number(time(share.nothingReady), share.nothingReady), number(time(share.scheduler), share.scheduler)));
  const all = analysis.makespan * threads.length;
  const busy = all - analysis.nothingReady - analysis.scheduler;
  const foot = element('tr', {}, element('th', { scope: 'row' }, 'all'), split(busy, analysis.scheduler, all),
    number(percent(busy / all), busy), number(time(analysis.nothingReady), analysis.nothingReady),
    number(time(analysis.scheduler), analysis.scheduler));
  const table = element('table', {}, headRow(['thread', '', 'busy', 'nothing ready', 'scheduler']),
    element('tbody', {}, ...rows), element('tfoot', {}, foot));
  host.replaceChildren(table, ...(moreThreads ? [moreThreadsTable(moreThreads)] : []));
}
