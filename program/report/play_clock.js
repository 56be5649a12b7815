// Play and pause of a moving picture.

class PlayClock {
  /** `advance` is told of the seconds since its last call, and says whether there is more to come. */
  constructor(button, advance) {
    Object.assign(this, { button, advance, isPlaying: false });
  }
  play() {
    this.isPlaying = true;
    this.restart();
    this.button.textContent = 'Pause';
    requestAnimationFrame((now) => this.tick(now));
  }
  pause() {
    this.isPlaying = false;
    this.button.textContent = 'Play';
  }
  /** Forgets the last call, as if that were now. */
  restart() {
    this.last = null;
  }
  tick(now) {
    if (!this.isPlaying) return;
    const passed = this.last === null ? 0 : (now - this.last) / 1000;
    // Users who prefer less motion see a picture every half second instead of a flow of them.
    const isCalm = matchMedia('(prefers-reduced-motion: reduce)').matches;
    let goesOn = true;
    if (this.last === null || !isCalm || passed > 0.5) {
      this.last = now;
      goesOn = this.advance(passed);
    }
    if (goesOn) requestAnimationFrame((next) => this.tick(next));
    else this.pause();
  }
}
