// Moves numbers smoothly to new values, or at once for people who prefer that.

const kDuration = 180;

export class Glide {
  private token = 0;

  /** Calls `set` with values on the way from `from` to `to`; a new call ends the one before. */
  start(from: number[], to: number[], set: (values: number[]) => void): void {
    const token = ++this.token;
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
      set(to);
      return;
    }
    const begin = performance.now();
    const advance = (now: number) => {
      if (token !== this.token) return;
      const t = Math.min(1, Math.max(0, (now - begin) / kDuration));
      const eased = 1 - (1 - t) ** 3;
      set(from.map((value, k) => value + (to[k] - value) * eased));
      if (t < 1) requestAnimationFrame(advance);
    };
    requestAnimationFrame(advance);
  }

  stop(): void {
    ++this.token;
  }
}
