// A mode as a moving picture. Uses steady_states.js, mode_choice.js, still_view.js and scene_view.js.

const kPeriod = 2; // of any mode, on the screen [s]

class ModeView {
  constructor(canvas, states, choice) {
    Object.assign(this, { states, choice, isPlaying: false, phase: 0 });
    const names = ['play', 'amplitude', 'share', 'outline'];
    this.controls = Object.fromEntries(names.map((name) => [name, document.getElementById(`mode-${name}`)]));
    const { scene, bounds } = states;
    this.settings = { scale: 1, color: 'tree', outline: true, joints: false, loads: false, names: false };
    this.camera = makeCamera(scene);
    // In the hub's steady frame, in which a free hub moves.
    this.view = new SceneView(canvas, scene, this.camera, this.settings, { isInertial: true, bounds: { ...bounds, radius: 1.1 * bounds.radius } });
    addLooks(document.getElementById('mode-looks'), this.camera);
    this.camera.fit = () => fit(scene, states.at(choice.speed), this.camera, bounds, canvas);
    this.camera.reset();
    this.camera.listen(() => this.draw());
    const { play, amplitude, outline } = this.controls;
    play.addEventListener('click', () => (this.isPlaying ? this.pause() : this.play()));
    amplitude.addEventListener('input', () => this.draw());
    outline.addEventListener('change', () => {
      this.settings.outline = outline.checked;
      this.draw();
    });
    choice.listen(() => this.draw());
  }

  draw() {
    const { states, choice, controls } = this;
    const share = Number(controls.amplitude.value) / 100;
    controls.share.textContent = `${controls.amplitude.value} %`;
    const { mode, speed } = choice;
    this.view.draw(mode ? states.moved(speed, mode, states.amplitudeOf(mode, share), this.phase) : states.at(speed));
  }
  play() {
    this.isPlaying = true;
    this.last = null;
    this.controls.play.textContent = 'Pause';
    requestAnimationFrame((now) => this.advance(now));
  }
  pause() {
    this.isPlaying = false;
    this.controls.play.textContent = 'Play';
  }
  advance(now) {
    if (!this.isPlaying) return;
    const passed = this.last === null ? 0 : (now - this.last) / 1000;
    // Who prefers less motion sees a picture every half second instead of a flow of them.
    const isCalm = matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (this.last === null || !isCalm || passed > 0.5) {
      this.last = now;
      this.phase += (2 * Math.PI * passed) / kPeriod;
      this.draw();
    }
    requestAnimationFrame((next) => this.advance(next));
  }
}
