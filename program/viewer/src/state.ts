// The state of the page: traces, chosen step, pass, node and filters. Views read it and are
// notified of changes.
import { Recording } from './recording';

/** A node of one recording; pass -1 = all passes of the chosen step. */
export interface Picked {
  node: number;
  pass: number;
}

export type ColourBy = 'stage' | 'share';
export type Change = 'traces' | 'step' | 'selection' | 'hover' | 'filter' | 'look' | 'active';

export class State {
  recordings: Recording[] = [];
  names: string[] = [];
  /** The recording that graph, tables and details show. */
  active = 0;
  /** Index into the first recording's steps. */
  step = 0;
  pass = -1;
  colourBy: ColourBy = 'stage';
  showCritical = true;
  tableOfAllSteps = false;
  readonly stages = new Set<string>();
  readonly subsystems = new Set<number>();
  selected: Picked | null = null;
  hovered: Picked | null = null;
  private readonly listeners: ((change: Change) => void)[] = [];

  get recording(): Recording {
    return this.recordings[this.active];
  }

  onChange(listener: (change: Change) => void): void {
    this.listeners.push(listener);
  }

  tell(change: Change): void {
    for (const listener of this.listeners) listener(change);
  }

  /** The chosen step in a recording: that of the same number, or else at the same place. */
  stepOf(which: number): number {
    if (which === 0) return this.step;
    const wanted = this.recordings[0].trace.steps[this.step].number;
    const { steps } = this.recordings[which].trace;
    const same = steps.findIndex((step) => step.number === wanted);
    return same >= 0 ? same : Math.min(this.step, steps.length - 1);
  }

  setTraces(recordings: Recording[], names: string[]): void {
    const node = this.selectedName();
    // The first step is a cold one, so a page opens on the median step. A further trace leaves it.
    if (this.recordings[0] !== recordings[0]) this.step = recordings[0].medianStep;
    this.recordings = recordings;
    this.names = names;
    this.active = 0;
    this.hovered = null;
    this.selected = this.pickByName(node, -1);
    this.tell('traces');
  }

  setStep(step: number): void {
    const last = this.recordings[0].trace.steps.length - 1;
    const next = Math.max(0, Math.min(last, step));
    if (next === this.step) return;
    this.step = next;
    this.hovered = null;
    this.tell('step');
  }

  setActive(which: number): void {
    if (which === this.active || which >= this.recordings.length) return;
    const node = this.selectedName();
    const pass = this.selected?.pass ?? -1;
    this.active = which;
    this.hovered = null;
    this.selected = this.pickByName(node, pass);
    this.tell('active');
  }

  select(picked: Picked | null): void {
    this.selected = picked;
    this.tell('selection');
  }

  hover(picked: Picked | null): void {
    if (picked?.node === this.hovered?.node && picked?.pass === this.hovered?.pass) return;
    this.hovered = picked;
    this.tell('hover');
  }

  /** What is looked at: the hovered node, or else the selected one. */
  get focus(): Picked | null {
    return this.hovered ?? this.selected;
  }

  /** The focus in another recording, where the node of the same name stands. */
  focusIn(which: number): Picked | null {
    const focus = this.focus;
    if (!focus || which === this.active) return focus;
    return this.pick(this.recordings[which], this.recording.trace.graph.name[focus.node], focus.pass);
  }

  isFiltered(): boolean {
    return this.stages.size > 0 || this.subsystems.size > 0;
  }

  /** Whether the filters show a node. */
  shows(recording: Recording, node: number): boolean {
    const { graph, stages } = recording.trace;
    if (this.stages.size > 0 && !this.stages.has(stages[graph.stage[node]])) return false;
    return this.subsystems.size === 0 || this.subsystems.has(graph.subsystem[node]);
  }

  private selectedName(): string | null {
    return this.selected ? this.recording.trace.graph.name[this.selected.node] : null;
  }

  private pickByName(name: string | null, pass: number): Picked | null {
    return name === null ? null : this.pick(this.recording, name, pass);
  }

  private pick(recording: Recording, name: string, pass: number): Picked | null {
    const node = recording.byName.get(name);
    return node === undefined ? null : { node, pass };
  }
}
