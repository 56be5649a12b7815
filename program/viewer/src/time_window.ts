// The part of time that the Gantt charts show, relative to the begin of the chosen step: one for all
// charts, so that two traces stand on the same scale.
import { Glide } from './glide';

export class TimeWindow {
  /** Shown time, us. */
  from = 0;
  to = 1;
  /** Whole step shown; a new step is then fitted, too. */
  fitted = true;
  private longest = 1;
  private readonly glide = new Glide();
  private readonly listeners: (() => void)[] = [];

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  private set(from: number, to: number): void {
    this.from = from;
    this.to = to;
    for (const listener of this.listeners) listener();
  }

  /** The longest step to be shown, us. */
  setLongest(longest: number): void {
    this.longest = Math.max(longest, 1e-3);
    if (this.fitted) this.fit(false);
  }

  fit(smoothly = true): void {
    this.fitted = true;
    this.show(-0.02 * this.longest, 1.03 * this.longest, smoothly);
  }

  show(from: number, to: number, smoothly = true): void {
    if (smoothly) this.glide.start([this.from, this.to], [from, to], ([a, b]) => this.set(a, b));
    else this.set(from, to);
  }

  pan(share: number): void {
    this.glide.stop();
    this.fitted = false;
    const by = share * (this.to - this.from);
    this.set(this.from + by, this.to + by);
  }

  /** Zooms about a place given as a share of the width. */
  zoom(factor: number, at: number): void {
    this.glide.stop();
    this.fitted = false;
    const width = this.to - this.from;
    const next = Math.min(Math.max(width / factor, 0.02), this.longest * 5000);
    const centre = this.from + at * width;
    this.set(centre - at * next, centre + (1 - at) * next);
  }

  /** Brings a time into the middle of the view, unless all of it is seen. */
  reveal(begin: number, end: number): void {
    const width = this.to - this.from;
    if (begin >= this.from && end <= this.to) return;
    this.fitted = false;
    const next = Math.max(width, (end - begin) * 1.4);
    this.show((begin + end - next) / 2, (begin + end + next) / 2);
  }
}
