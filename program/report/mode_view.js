// A mode as a moving picture. Uses steady_states.js, mode_choice.js, play_clock.js,
// fit_view.js and scene_view.js.

const kPeriod = 2; // period of any mode on the screen [s]

class ModeView {
  constructor(canvas, states, choice) {
    Object.assign(this, { states, choice, phase: 0 });
    const names = ['play', 'amplitude', 'share', 'outline'];
    this.controls = Object.fromEntries(names.map((name) => [name, document.getElementById(`mode-${name}`)]));
    const { scene, bounds } = states;
    this.settings = { scale: 1, color: 'tree', outline: true, joints: false, loads: false, names: false };
    this.camera = makeCamera(scene);
    // The view is in the hub's steady frame, in which a free hub moves.
    this.view = new SceneView(canvas, scene, this.camera, this.settings, { isInertial: true, bounds: { ...bounds, radius: 1.1 * bounds.radius } });
    addLooks(document.getElementById('mode-looks'), this.camera);
    this.camera.fit = () => fit(scene, states.at(choice.speed), this.camera, bounds, canvas);
    this.camera.reset();
    this.camera.listen(() => this.draw());
    const { play, amplitude, outline } = this.controls;
    this.clock = new PlayClock(play, (passed) => this.advance(passed));
    play.addEventListener('click', () => (this.clock.isPlaying ? this.clock.pause() : this.play()));
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
    this.clock.play();
  }
  advance(passed) {
    this.phase += (2 * Math.PI * passed) / kPeriod;
    this.draw();
    return true;
  }
}
