// The mode of a page that is chosen, the one under the pointer, and the text about a mode. Uses
// page_tools.js.

/** A branch is a mode followed over the speeds; `branch.modes[k]`: its mode at speed k, or null. */
class ModeChoice {
  /** varied: name and unit of what states differ by. */
  constructor(branches, states, varied = { name: 'speed', unit: 'rad/s' }) {
    Object.assign(this, { branches, states, varied, hovered: null, listeners: [] });
    branches.forEach((branch, b) => Object.assign(branch, { isShown: true, color: b }));
    this.branch = 0;
    this.speed = 0;
  }
  listen(callback) {
    this.listeners.push(callback);
  }
  changed() {
    for (const callback of this.listeners) callback(this);
  }

  /** The label of an axis along which states stand. */
  get axis() {
    const { name, unit } = this.varied;
    return unit ? `${name} [${unit}]` : name;
  }
  valueText(k) {
    return `${numberText(this.states[k].value)} ${this.varied.unit}`.trim();
  }

  modeOf(branch, k) {
    const at = this.branches[branch]?.modes[k];
    return at === undefined || at === null ? null : this.states[k].modes[at];
  }
  get mode() {
    return this.modeOf(this.branch, this.speed);
  }
  /** Chooses the mode of a branch at the speed nearest to `k` at which it has one. */
  choose(branch, k) {
    const count = this.states.length;
    const known = Array.from({ length: count }, (_, i) => i).filter((i) => this.modeOf(branch, i));
    if (known.length === 0) return;
    this.branch = branch;
    this.speed = known.reduce((best, i) => (Math.abs(i - k) < Math.abs(best - k) ? i : best));
    this.changed();
  }
  /** To the next speed, or to the branch next above or below at this speed. */
  step(speeds, branches) {
    if (speeds !== 0) {
      for (let k = this.speed + speeds; k >= 0 && k < this.states.length; k += speeds)
        if (this.modeOf(this.branch, k)) return this.choose(this.branch, k);
      return undefined;
    }
    const here = this.branches.map((_, b) => b).filter((b) => this.modeOf(b, this.speed) && this.branches[b].isShown);
    here.sort((a, b) => this.modeOf(a, this.speed).frequency - this.modeOf(b, this.speed).frequency);
    const next = here[here.indexOf(this.branch) + branches];
    return next === undefined ? undefined : this.choose(next, this.speed);
  }
  hover(point) {
    if (this.hovered?.branch === point?.branch && this.hovered?.speed === point?.speed) return;
    this.hovered = point;
    this.changed();
  }
  describe(branch, k) {
    const mode = this.modeOf(branch, k);
    if (!mode) return '';
    const { speed } = this.states[k];
    const perRevolution = speed !== 0 ? `, ${numberText((2 * Math.PI * mode.frequency) / Math.abs(speed))} per revolution` : '';
    const damping = mode.damping === 0 ? 'undamped' : `damping ratio ${numberText(mode.damping)}`;
    const at = this.varied.unit ? this.valueText(k) : `a ${this.varied.name} of ${this.valueText(k)}`;
    return `${mode.of}: ${mode.name} at ${at}: ${numberText(mode.frequency)} Hz${perRevolution}, ${mode.grows ? 'grows, ' : ''}${damping}`;
  }
}
