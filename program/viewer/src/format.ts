// Numbers as the page writes them.

/** A time in microseconds with a unit that suits `scale` (default: the time itself). */
export function time(us: number, scale = Math.abs(us)): string {
  if (!Number.isFinite(us)) return '–';
  if (scale >= 1e6) return `${significant(us / 1e6)} s`;
  if (scale >= 1e3) return `${significant(us / 1e3)} ms`;
  return `${significant(us)} µs`;
}

/** Three significant digits, never an exponent for the sizes that occur. */
export function significant(value: number): string {
  const size = Math.abs(value);
  if (size < 0.0005) return '0';
  const digits = size >= 100 ? 0 : size >= 10 ? 1 : size >= 0.0995 ? 2 : 3;
  return value.toFixed(digits);
}

export function percent(share: number): string {
  if (!Number.isFinite(share)) return '–';
  const value = share * 100;
  return `${value >= 9.95 || value === 0 ? value.toFixed(0) : value.toFixed(1)} %`;
}

export function ratio(value: number): string {
  return Number.isFinite(value) ? `${significant(value)}×` : '–';
}

export function plural(count: number, word: string): string {
  return `${count} ${word}${count === 1 ? '' : word.endsWith('s') ? 'es' : 's'}`;
}
