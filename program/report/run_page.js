// The page of a run: decodes its data, makes the plots and the moving picture, and ties them together.
// Uses time_plots.js, model_animation.js, play_clock.js and scene_view.js.

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

/** A scale at which the largest displacement is seen: 1, 2 or 5 times a power of ten. */
function visibleScale(animation) {
  const wanted = (0.06 * animation.bounds[0].radius) / animation.largest.size;
  if (!(wanted > 1) || wanted === Infinity) return 1;
  const power = 10 ** Math.floor(Math.log10(wanted));
  return Math.min(100, power * [5, 2, 1].find((factor) => factor * power <= wanted));
}

/** The animation's controls, two views and the clock that moves them. */
class Player {
  constructor(scene, animation, axis) {
    Object.assign(this, { scene, animation, axis });
    const names = ['play', 'time', 'now', 'speed', 'scale', 'times', 'color', 'outline', 'trails', 'joints', 'loads', 'names'];
    this.controls = Object.fromEntries(names.map((name) => [name, document.getElementById(`animation-${name}`)]));
    this.settings = { scale: visibleScale(animation), color: 'tree', outline: true, trails: true, joints: false, loads: false, names: false };
    this.camera = makeCamera(scene);
    this.views = ['hub', 'inertial'].map((name, k) => {
      const canvas = document.getElementById(`animation-${name}`);
      const colors = (state) => new SceneColors(scene, state, this.settings.color, this.most[this.settings.color]);
      return new SceneView(canvas, scene, this.camera, this.settings, { isInertial: k === 1, bounds: animation.bounds[k], colors });
    });
    if (this.views[1].follows)
      document.getElementById('animation-inertial-note').textContent = ', following the hub';
    addLooks(document.getElementById('animation-looks'), this.camera);
    this.prepareControls();
    this.prepareColors();
    this.camera.listen(() => this.drawSoon());
    this.seek(animation.largest.time);
  }

  prepareControls() {
    const { play, time, speed, scale } = this.controls;
    const { animation, scene } = this;
    time.min = animation.begin;
    time.max = animation.end;
    time.step = (animation.end - animation.begin) / 2000;
    scale.value = 100 * Math.log10(this.settings.scale);
    this.clock = new PlayClock(play, (passed) => this.advance(passed));
    play.addEventListener('click', () => (this.clock.isPlaying ? this.pause() : this.play()));
    time.addEventListener('input', () => this.seek(Number(time.value)));
    speed.addEventListener('change', () => this.clock.restart());
    scale.addEventListener('input', () => {
      this.settings.scale = Number((10 ** (scale.value / 100)).toPrecision(2));
      this.redraw();
    });
    const deforms = animation.largest.size > 0;
    scale.parentElement.hidden = !deforms;
    const hasMarks = { outline: deforms, joints: scene.joints.length + scene.loops.length > 0, loads: scene.loads.length > 0 };
    for (const name of ['outline', 'trails', 'joints', 'loads', 'names']) {
      const box = this.controls[name];
      box.parentElement.hidden = hasMarks[name] === false;
      box.checked = this.settings[name];
      box.addEventListener('change', () => {
        this.settings[name] = box.checked;
        this.redraw();
      });
    }
  }
  /** Offers what there is. */
  prepareColors() {
    const { color } = this.controls;
    this.most = Object.fromEntries(Object.keys(kColorings).map((kind) => [kind, this.animation.largestOf(kind)]));
    for (const option of [...color.options])
      if (option.value !== 'tree' && !(this.most[option.value] > 0)) option.remove();
    color.parentElement.hidden = color.options.length < 2;
    color.addEventListener('change', () => {
      this.settings.color = color.value;
      showScale(document.getElementById('animation-colors'), color.value, this.most[color.value]);
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
    const { time, now, scale, times: factor } = this.controls;
    const text = `${this.time.toFixed(2)} s`;
    time.value = this.time;
    time.setAttribute('aria-valuetext', text);
    now.textContent = text;
    factor.textContent = `\u00d7 ${this.settings.scale}`;
    scale.setAttribute('aria-valuetext', `${this.settings.scale} times`);
    this.draw();
  }
  draw() {
    const state = this.animation.at(this.time, this.settings.scale);
    const largest = this.animation.largest.size;
    this.views[0].draw(state, { largest });
    this.views[1].draw(state, { largest, trails: this.settings.trails ? this.trails() : [] });
  }
  /** Once, however often the camera moves before the next picture. */
  drawSoon() {
    if (this.isDue) return;
    this.isDue = true;
    requestAnimationFrame(() => {
      this.isDue = false;
      this.draw();
    });
  }
  /** Where the tips have been in the last tenth of the animation. */
  trails() {
    const kPieces = 60;
    const { animation, scene, settings } = this;
    const begin = Math.max(animation.begin, this.time - 0.1 * (animation.end - animation.begin));
    if (begin >= this.time) return [];
    return scene.tips.map((node, tree) => ({
      tree,
      points: Array.from({ length: kPieces + 1 }, (_, k) =>
        animation.nodeAt(node, begin + (k / kPieces) * (this.time - begin), settings.scale)),
    }));
  }

  play() {
    if (this.time >= this.animation.end) this.seek(this.animation.begin);
    this.clock.play();
  }
  pause() {
    this.clock.pause();
  }
  advance(passed) {
    this.seek(this.time + passed * Number(this.controls.speed.value));
    return this.time < this.animation.end;
  }
}

function startPage() {
  const data = JSON.parse(document.getElementById('run-data').textContent);
  const axis = new TimeAxis(0, data.end);
  axis.events = data.events ?? [];
  const region = document.getElementById('spoken');
  const say = (text) => (region.textContent = text);
  const scene = data.animation ? new Scene(data.scene) : null;
  const player = scene ? new Player(scene, new ModelAnimation(scene, data.animation), axis) : null;
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
