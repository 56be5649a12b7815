// Bars above the threads that say when steps and passes began and ended; overlapping ones are stacked.
import type { Recording } from './recording';

export interface Bracket {
  begin: number;
  end: number;
  line: number;
  number: number;
}

const kMostLines = 3;

type Bar = Omit<Bracket, 'line'>;

/** Gives each bar, the first ones first, the first line on which it covers no other; what finds none of
 *  the three lines is left out. */
export function stack(bars: Bar[]): Bracket[] {
  const placed: Bracket[][] = Array.from({ length: kMostLines }, () => []);
  for (const bar of bars) {
    const line = placed.findIndex((others) => others.every((other) => other.end <= bar.begin || other.begin >= bar.end));
    if (line >= 0) placed[line].push({ ...bar, line });
  }
  return placed.flat();
}

const kMostSteps = 200;

/** The steps around the chosen one, which gets the first line. */
export function stepBrackets(recording: Recording, chosen: number): Bracket[] {
  const distance = (bar: Bar) => Math.abs(bar.number - chosen);
  const bars = recording.trace.steps.map((_, number) => (
    { begin: recording.stepBegin[number], end: recording.stepEnd[number], number }));
  const near = bars.filter((bar) => bar.end >= bar.begin && distance(bar) <= kMostSteps);
  return stack(near.sort((a, b) => distance(a) - distance(b)));
}

export function passBrackets(recording: Recording, step: number): Bracket[] {
  const bars: { begin: number; end: number; number: number }[] = [];
  const { slices } = recording.trace;
  for (const slice of recording.ofStep(step)) {
    const number = slices.pass[slice];
    const bar = (bars[number] ??= { begin: Infinity, end: -Infinity, number });
    bar.begin = Math.min(bar.begin, slices.begin[slice]);
    bar.end = Math.max(bar.end, recording.end(slice));
  }
  return stack(bars.filter((bar) => bar !== undefined));
}

export function lines(brackets: Bracket[]): number {
  return brackets.reduce((most, bracket) => Math.max(most, bracket.line + 1), 0);
}
