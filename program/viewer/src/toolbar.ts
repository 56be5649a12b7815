// Step selector, pass and colour switches, filters.
import { byId, element } from './dom';
import { plural, time } from './format';
import { Palette, swatchStyle } from './palette';
import { State } from './state';
import { subsystemName } from './trace';

/** Buttons of which one is pressed. */
export function fillSwitch(host: HTMLElement, title: string, names: string[], chosen: number, choose: (k: number) => void): void {
  const buttons = names.map((name, k) => {
    const button = element('button', { type: 'button', 'aria-pressed': String(k === chosen) }, name);
    button.addEventListener('click', () => {
      choose(k);
      (host.querySelectorAll('button')[k] as HTMLButtonElement | undefined)?.focus();
    });
    return button;
  });
  host.replaceChildren(...(title ? [element('span', {}, title)] : []), ...buttons);
}

export function installToolbar(state: State): void {
  const slider = byId<HTMLInputElement>('step');
  slider.addEventListener('input', () => state.setStep(Number(slider.value)));
  byId('previous').addEventListener('click', () => state.setStep(state.step - 1));
  byId('next').addEventListener('click', () => state.setStep(state.step + 1));
  byId('critical').addEventListener('click', () => toggleCritical(state));
  byId('clear').addEventListener('click', () => {
    state.stages.clear();
    state.subsystems.clear();
    state.tell('filter');
    byId('stages').querySelector('button')?.focus();
  });
}

export function toggleCritical(state: State): void {
  state.showCritical = !state.showCritical;
  byId('critical').setAttribute('aria-pressed', String(state.showCritical));
  state.tell('look');
}

/** Bars of the steps' makespans, at the places of the slider's thumb. */
function drawMakespans(state: State): void {
  const svg = byId('makespans');
  const [recording] = state.recordings;
  const lengths = recording.trace.steps.map((_, k) => recording.makespan(k));
  // A step that was interrupted does not flatten the others.
  const most = 2.5 * recording.makespan(recording.medianStep);
  const longest = Math.max(1e-9, Math.min(lengths.reduce((a, b) => Math.max(a, b), 0), most));
  const count = lengths.length;
  svg.setAttribute('viewBox', '0 0 1000 100');
  const pitch = 1000 / Math.max(1, count - 1);
  const width = Math.min(60, pitch * 0.72);
  svg.replaceChildren(...lengths.map((length, k) => {
    const bar = document.createElementNS('http://www.w3.org/2000/svg', 'rect');
    const height = Math.max(3, (96 * Math.min(length, longest)) / longest);
    const x = count === 1 ? 500 : k * pitch;
    const shape = { x: x - width / 2, y: 100 - height, width, height };
    for (const [name, value] of Object.entries(shape)) bar.setAttribute(name, value.toFixed(1));
    bar.addEventListener('click', () => state.setStep(k));
    const title = document.createElementNS('http://www.w3.org/2000/svg', 'title');
    title.textContent = `step ${recording.trace.steps[k].number}: ${time(length)}`;
    bar.append(title);
    return bar;
  }));
}

export function showStep(state: State): void {
  const { steps } = state.recordings[0].trace;
  const step = steps[state.step];
  const slider = byId<HTMLInputElement>('step');
  slider.max = String(steps.length - 1);
  slider.value = String(state.step);
  slider.setAttribute('aria-valuetext', `step ${step.number}`);
  byId<HTMLButtonElement>('previous').disabled = state.step === 0;
  byId<HTMLButtonElement>('next').disabled = state.step === steps.length - 1;
  byId('makespans').querySelectorAll('rect').forEach((bar, k) => bar.classList.toggle('chosen', k === state.step));
  const place = state.step === state.recordings[0].medianStep && steps.length > 2 ? ', the median' : '';
  byId('stepname').replaceChildren(element('b', {}, `step ${step.number}`), ` (${state.step + 1} of ${steps.length}${place})`,
    element('span', {}, `t = ${Number(step.time.toPrecision(7))} s, ${plural(step.passes, 'pass')}`));
}

export function showSteps(state: State): void {
  drawMakespans(state);
  showStep(state);
}

export function showPasses(state: State): void {
  const most = Math.max(...state.recordings.map((recording) => recording.passes));
  byId('passes').hidden = most < 2;
  const names = ['all', ...Array.from({ length: most }, (_, k) => String(k + 1))];
  fillSwitch(byId('passes'), 'pass', names, state.pass + 1, (k) => {
    state.pass = k - 1;
    if (state.selected) state.selected = { node: state.selected.node, pass: state.pass };
    showPasses(state);
    state.tell('step');
  });
}

export function showColours(state: State): void {
  fillSwitch(byId('colours'), 'colour', ['stage', 'share of time'], state.colourBy === 'stage' ? 0 : 1, (k) => {
    state.colourBy = k === 0 ? 'stage' : 'share';
    showColours(state);
    state.tell('look');
  });
}

function chip<T>(state: State, set: Set<T>, value: T, label: string, style: string | null): HTMLElement {
  const button = element('button', { type: 'button', 'aria-pressed': String(set.has(value)) },
    style === null ? null : element('i', { style }), label);
  button.addEventListener('click', () => {
    if (set.has(value)) set.delete(value);
    else set.add(value);
    button.setAttribute('aria-pressed', String(set.has(value)));
    state.tell('filter');
  });
  return button;
}

/** Chips of stages and subsystems; none pressed shows all. */
export function showChips(state: State, palette: Palette): void {
  const { recording } = state;
  const { stages, graph, subsystemWord } = recording.trace;
  const used = new Set(graph.stage);
  byId('stages').replaceChildren(...stages.filter((_, k) => used.has(k))
    .map((stage) => chip(state, state.stages, stage, stage, swatchStyle(palette, stage))));
  const subsystems = [...new Set(graph.subsystem)].filter((k) => k >= 0).sort((a, b) => a - b);
  const host = byId('subsystems');
  host.hidden = subsystems.length < 2;
  host.classList.add('numbers');
  host.setAttribute('aria-label', `Show only these ${subsystemWord}s`);
  const chips = subsystems.map((k) => {
    const name = subsystemName(recording.trace, k);
    const isNumbered = name === `${subsystemWord} ${k + 1}`;
    const made = chip(state, state.subsystems, k, isNumbered ? String(k + 1) : name, null);
    made.setAttribute('aria-label', name);
    return made;
  });
  host.replaceChildren(element('span', {}, subsystemWord), ...chips);
}

export function showFilter(state: State): void {
  byId('clear').style.visibility = state.isFiltered() ? 'visible' : 'hidden';
}
