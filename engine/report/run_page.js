// The page of a run: decodes its data, makes the plots and the animation, and ties them together.
// Uses time_plots.js and rotor_view.js.

/** Numbers that the page carries as base64: of little-endian Float32 or Int16. */
function decode(text, Type) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Type(bytes.buffer);
}

/** Decodes [t, value, t, value, ...]. */
function decodeCurve({ name, samples }) {
  const numbers = decode(samples, Float32Array);
  return {
    name,
    times: numbers.filter((_, k) => k % 2 === 0),
    values: numbers.filter((_, k) => k % 2 === 1),
  };
}

/** "blade 1" to "blade 3" as "blades 1-3"; other names one after the other. */
function joinNames(names) {
  const numbers = names.map((name) => Number(/^blade (\d+)$/.exec(name)?.[1]));
  if (names.length === 1 || numbers.some(Number.isNaN)) return names.join(', ');
  const ranges = [];
  for (const number of numbers) {
    const last = ranges[ranges.length - 1];
    if (last && last[1] === number - 1) last[1] = number;
    else ranges.push([number, number]);
  }
  return `blades ${ranges.map(([a, b]) => (a === b ? a : `${a}\u2013${b}`)).join(', ')}`;
}

/** Curves that nobody could tell apart become one, in the colour of the first. */
function mergeEqual(curves) {
  const size = Math.max(...curves.map(({ values }) => values.reduce((m, v) => Math.max(m, Math.abs(v)), 0)));
  const isSame = (a, b) =>
    a.values.length === b.values.length &&
    a.values.every((value, k) => Math.abs(value - b.values[k]) <= 1e-5 * size);
  const groups = [];
  curves.forEach((curve, color) => {
    const group = groups.find(({ first }) => isSame(first, curve));
    if (group) group.names.push(curve.name);
    else groups.push({ first: curve, color, names: [curve.name] });
  });
  return groups.map(({ first, color, names }) => ({ ...first, color, name: joinNames(names) }));
}

function decodeAnimation(animation) {
  return new Animation({
    ...animation,
    times: decode(animation.times, Float32Array),
    hub: decode(animation.hub, Float32Array),
    blades: animation.blades.map((blade) => decode(blade, Float32Array)),
    displacements: decode(animation.displacements, Int16Array),
  });
}

/** A scale at which the largest displacement is seen: 1, 2 or 5 times a power of ten. */
function visibleScale(animation) {
  const wanted = (0.06 * animation.radius) / animation.largest.size;
  if (!(wanted > 1)) return 1;
  const power = 10 ** Math.floor(Math.log10(wanted));
  return Math.min(100, power * [5, 2, 1].find((factor) => factor * power <= wanted));
}

/** The animation's controls, two views and the clock that moves them. */
class Player {
  constructor(animation, axis) {
    this.animation = animation;
    this.axis = axis;
    this.isPlaying = false;
    this.controls = Object.fromEntries(
      ['play', 'time', 'now', 'speed', 'scale', 'times', 'outline', 'trails'].map((name) => [
        name,
        document.getElementById(`film-${name}`),
      ]),
    );
    this.settings = { scale: visibleScale(animation), outline: true, trails: true };
    this.views = ['hub', 'inertial'].map((name) => {
      const canvas = document.getElementById(`film-${name}`);
      return new RotorView(canvas, animation, this.settings, name === 'inertial');
    });
    if (this.views[1].follows)
      document.getElementById('film-inertial-note').textContent = ', following the hub';
    this.prepareControls();
    this.seek(animation.largest.time);
  }

  prepareControls() {
    const { play, time, speed, scale, outline, trails } = this.controls;
    const { animation } = this;
    time.min = animation.begin;
    time.max = animation.end;
    time.step = (animation.end - animation.begin) / 2000;
    scale.value = 100 * Math.log10(this.settings.scale);
    play.addEventListener('click', () => (this.isPlaying ? this.pause() : this.play()));
    time.addEventListener('input', () => this.seek(Number(time.value)));
    speed.addEventListener('change', () => (this.lastFrame = null));
    scale.addEventListener('input', () => {
      this.settings.scale = Number((10 ** (scale.value / 100)).toPrecision(2));
      this.redraw();
    });
    for (const [name, box] of Object.entries({ outline, trails }))
      box.addEventListener('change', () => {
        this.settings[name] = box.checked;
        this.redraw();
      });
  }

  seek(time) {
    this.time = Math.min(Math.max(time, this.animation.begin), this.animation.end);
    this.axis.marker = this.time;
    this.axis.changed();
    this.redraw();
  }

  redraw() {
    const { time, now, scale, times } = this.controls;
    const text = `${this.time.toFixed(2)} s`;
    time.value = this.time;
    time.setAttribute('aria-valuetext', text);
    now.textContent = text;
    times.textContent = `\u00d7 ${this.settings.scale}`;
    scale.setAttribute('aria-valuetext', `${this.settings.scale} times`);
    for (const view of this.views) view.draw(this.time);
  }

  play() {
    this.isPlaying = true;
    this.lastFrame = null;
    if (this.time >= this.animation.end) this.seek(this.animation.begin);
    this.controls.play.textContent = 'Pause';
    requestAnimationFrame((now) => this.advance(now));
  }
  pause() {
    this.isPlaying = false;
    this.controls.play.textContent = 'Play';
  }
  advance(now) {
    if (!this.isPlaying) return;
    const passed = this.lastFrame === null ? 0 : (now - this.lastFrame) / 1000;
    // Who prefers less motion sees a picture every half second instead of a flow of them.
    const isCalm = matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (this.lastFrame === null || !isCalm || passed > 0.5) {
      this.lastFrame = now;
      this.seek(this.time + passed * Number(this.controls.speed.value));
    }
    if (this.time >= this.animation.end) this.pause();
    else requestAnimationFrame((next) => this.advance(next));
  }
}

function startPage() {
  const data = JSON.parse(document.getElementById('run-data').textContent);
  const axis = new TimeAxis(0, data.end);
  const region = document.getElementById('spoken');
  const say = (text) => (region.textContent = text);
  const player = data.film ? new Player(decodeAnimation(data.film), axis) : null;
  const host = document.getElementById('plots');
  const plots = data.plots.map((plot) => ({ ...plot, curves: mergeEqual(plot.curves.map(decodeCurve)) }));
  for (const plot of plots)
    new TimePlot(host, plot, axis, say, (time) => {
      player?.pause();
      player?.seek(time);
    });
  const shown = document.getElementById('plots-shown');
  const reset = document.getElementById('plots-reset');
  reset.addEventListener('click', () => axis.reset());
  axis.listen(() => {
    shown.textContent = `${numberText(axis.view[0])} to ${numberText(axis.view[1])} s`;
    reset.disabled = !axis.isZoomed;
  });
  axis.changed();
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    axis.changed();
    player?.redraw();
  });
}

startPage();
