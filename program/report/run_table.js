// The runs of a study as columns of numbers, and which of them are selected. Uses page_tools.js.

/** A parameter or response: its values by run, not finite where a run has none. */
class Column {
  constructor({ name, unit, values, choices }) {
    this.name = name;
    this.unit = unit;
    this.choices = choices ?? null; // texts whose places the values are
    this.values = values.map((value) => value ?? NaN);
    const finite = this.values.filter(Number.isFinite);
    this.low = finite.reduce((low, value) => Math.min(low, value), Infinity);
    this.high = finite.reduce((high, value) => Math.max(high, value), -Infinity);
    if (this.choices) [this.low, this.high] = [0, this.choices.length - 1];
    if (!(this.low <= this.high)) [this.low, this.high] = [0, 1];
    if (this.low === this.high) {
      const margin = Math.abs(this.low) * 0.05 || 1;
      [this.low, this.high] = [this.low - margin, this.high + margin];
    }
  }
  get title() {
    return this.unit ? `${this.name} [${this.unit}]` : this.name;
  }
  /** From 0 at the lowest value to 1 at the highest. */
  share(value) {
    return (value - this.low) / (this.high - this.low);
  }
  valueAt(share) {
    return this.low + share * (this.high - this.low);
  }
  text(value) {
    if (!Number.isFinite(value)) return 'none';
    if (!this.choices) return numberText(value);
    const last = this.choices.length - 1; // the axis of a single choice has a margin
    return this.choices[Math.min(Math.max(Math.round(value), 0), last)];
  }
}

/** All runs, and the interval that is brushed on each column, if one is. */
class RunTable {
  constructor(data) {
    this.runs = data.runs;
    this.scenario = data.scenario;
    this.keys = data.keys;
    this.parameters = data.parameters.map((column) => new Column(column));
    this.responses = data.responses.map((column) => new Column(column));
    this.columns = [...this.parameters, ...this.responses];
    this.brushes = new Map(); // column: [low, high]
    this.color = this.responses[0] ?? this.columns[0];
    this.chosen = null; // place of the chosen run
    this.hovered = null;
    this.listeners = [];
    this.select();
  }
  listen(callback) {
    this.listeners.push(callback);
  }
  changed() {
    for (const callback of this.listeners) callback();
  }
  select() {
    const brushes = [...this.brushes];
    this.selected = this.runs.map((_, i) =>
      brushes.every(([column, [low, high]]) => column.values[i] >= low && column.values[i] <= high));
    this.count = this.selected.reduce((count, is) => count + (is ? 1 : 0), 0);
    this.changed();
  }
  /** Brushes an interval of a column; null: none. */
  brush(column, interval) {
    if (interval) this.brushes.set(column, interval);
    else this.brushes.delete(column);
    this.select();
  }
  clear() {
    this.brushes.clear();
    this.select();
  }
  choose(place) {
    this.chosen = place;
    this.changed();
  }
  hover(place) {
    if (place === this.hovered) return;
    this.hovered = place;
    this.changed();
  }
  /** From blue over grey to orange. */
  colorAt(place) {
    const value = this.color.values[place];
    if (!Number.isFinite(value)) return colorOf('--bad');
    const share = Math.round(100 * this.color.share(value));
    return share < 50
      ? `color-mix(in oklab, ${colorOf('--s0')} ${100 - 2 * share}%, ${colorOf('--s6')})`
      : `color-mix(in oklab, ${colorOf('--s1')} ${2 * share - 100}%, ${colorOf('--s6')})`;
  }
  /** The command that makes a run alone. */
  replay(place) {
    const word = (text) => (/^[\w./=+-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
    const settings = this.keys
      .map((key, k) => {
        if (!key) return '';
        const { toml, values } = { ...key, values: this.parameters[k].values };
        return ` --set ${word(`${key.key}=${toml ? toml[values[place]] : values[place]}`)}`;
      })
      .join('');
    return `spoke run ${word(this.scenario)}${settings}`;
  }
}
