// Details of the selected node: times by pass, what it waited for and for how long.
import { element } from './dom';
import { percent, time } from './format';
import { Recording } from './recording';
import { State } from './state';

const kMostListed = 60;

function facts(recording: Recording, node: number): string {
  const { level } = recording.adjacency;
  return `level ${level[node] + 1} of ${level.reduce((most, k) => Math.max(most, k), 0) + 1}`;
}

function passTable(state: State, recording: Recording, node: number): HTMLElement {
  const { slices, threads } = recording.trace;
  const step = state.stepOf(state.active);
  const analysis = recording.analysis(step);
  const found = recording.slicesOfNode(node, step);
  if (found.length === 0) return element('p', { class: 'hint' }, 'It did not run in this step.');
  const cell = (text: string) => element('td', { class: 'number' }, text);
  const rows = found.map((slice) => element('tr', { class: slices.pass[slice] === state.selected?.pass ? 'now' : null },
    element('th', { scope: 'row' }, String(slices.pass[slice] + 1)),
    cell(time(slices.duration[slice])), cell(time(slices.begin[slice] - analysis.begin)),
    cell(time(Math.max(0, slices.begin[slice] - (analysis.ready.get(slice) ?? slices.begin[slice])))),
    element('td', {}, threads[slices.thread[slice]]),
    cell(slices.cluster[slice] < 0 ? '–' : String(slices.cluster[slice])),
    element('td', {}, analysis.onCritical.has(slice) ? 'yes' : '')));
  const names = ['pass', 'took', 'began at', 'waited, ready', 'thread', 'cluster', 'critical'];
  const head = names.map((name, k) => element('th', { scope: 'col', class: k > 0 && k !== 4 && k !== 6 ? 'number' : null }, name));
  const total = found.reduce((sum, slice) => sum + slices.duration[slice], 0);
  const foot = element('tr', {}, element('th', { scope: 'row' }, 'all'), cell(time(total)),
    element('td', { colspan: 5 }, `${percent(total / analysis.work)} of T1`));
  return element('table', {}, element('thead', {}, element('tr', {}, ...head)), element('tbody', {}, ...rows),
    found.length > 1 ? element('tfoot', {}, foot) : null);
}

interface Neighbour {
  node: number;
  note: string;
}

function list(state: State, title: string, neighbours: Neighbour[]): HTMLElement {
  const { graph } = state.recording.trace;
  const items = neighbours.slice(0, kMostListed).map(({ node, note }) => {
    const button = element('button', { type: 'button' }, graph.name[node]);
    button.addEventListener('click', () => state.select({ node, pass: state.selected?.pass ?? -1 }));
    button.addEventListener('pointerenter', () => state.hover({ node, pass: state.selected?.pass ?? -1 }));
    button.addEventListener('pointerleave', () => state.hover(null));
    return element('li', {}, button, note ? element('small', {}, ` ${note}`) : null);
  });
  if (neighbours.length > kMostListed) items.push(element('li', {}, `and ${neighbours.length - kMostListed} more`));
  return element('div', {}, element('h4', {}, `${title} (${neighbours.length})`), element('ul', {}, ...items));
}

/** The node among a slice's predecessors that ended last. */
function lastToEnd(recording: Recording, slice: number): number {
  let last = -1;
  for (const other of recording.predecessors(slice)) {
    if (last < 0 || recording.end(other) > recording.end(last)) last = other;
  }
  return last < 0 ? -1 : recording.trace.slices.node[last];
}

/** Fills the panel and its title. */
export function showDetails(title: HTMLElement, host: HTMLElement, state: State): void {
  const { selected, recording } = state;
  if (!selected) {
    title.replaceChildren('Node');
    host.replaceChildren(element('p', { class: 'hint' },
      'Select a node in the graph or a slice in the chart to see its times, what it waited for and what waits for it.'));
    return;
  }
  const { node, pass } = selected;
  const { adjacency } = recording;
  const slice = recording.slicesOfNode(node, state.stepOf(state.active), pass)[0] ?? -1;
  const last = slice >= 0 ? lastToEnd(recording, slice) : -1;
  const before = [...adjacency.predecessors.of(node)].map((n) => ({ node: n, note: n === last ? 'ended last' : '' }))
    .concat([...adjacency.previousPass.of(node)].map((n) => ({ node: n, note: n === last ? 'of the pass before, ended last' : 'of the pass before' })));
  const after = [...adjacency.successors.of(node)].map((n) => ({ node: n, note: '' }))
    .concat([...adjacency.nextPass.of(node)].map((n) => ({ node: n, note: 'of the next pass' })));
  title.replaceChildren(recording.trace.graph.name[node], element('span', {}, facts(recording, node)));
  host.replaceChildren(
    passTable(state, recording, node),
    element('div', { class: 'lists' }, list(state, 'waits for', before), list(state, 'then', after)));
}
