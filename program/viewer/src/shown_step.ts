// The content of a Gantt chart: a step of a recording, with the brackets above the threads.
import { StepAnalysis } from './analysis';
import { Bracket, passBrackets, stepBrackets } from './brackets';
import { Recording } from './recording';

export class ShownStep {
  readonly analysis: StepAnalysis;
  /** The step itself and those around it. */
  readonly steps: Bracket[];
  readonly passes: Bracket[];

  constructor(readonly recording: Recording, readonly step: number) {
    this.steps = stepBrackets(recording, step);
    this.analysis = recording.analysis(step);
    this.passes = passBrackets(recording, step);
  }
}
