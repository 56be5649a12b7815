// Bars above the threads that say when steps and passes began and ended; overlapping ones are stacked.
import type { Recording } from './recording';

export interface Bracket {
  begin: number;
  end: number;
  line: number;
  number: number;
}

const kMostLines = 3;

/** Gives each bar the first line that is free at its begin; what finds none shares the last. */
export function stack(bars: { begin: number; end: number; number: number }[]): Bracket[] {
  const free: number[] = [];
  return bars.map((bar) => {
    let line = free.findIndex((until) => until <= bar.begin);
    if (line < 0) line = Math.min(free.length, kMostLines - 1);
    free[line] = Math.max(free[line] ?? -Infinity, bar.end);
    return { ...bar, line };
  });
}

export function stepBrackets(recording: Recording): Bracket[] {
  const { steps } = recording.trace;
  const bars = steps.map((_, number) => ({ begin: recording.stepBegin[number], end: recording.stepEnd[number], number }));
  return stack(bars.filter((bar) => bar.end >= bar.begin).sort((a, b) => a.begin - b.begin));
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
