// The direction from which a scene is seen, in parallel projection, changed by pointer and keys.
// Uses space_math.js.

const kTurnStep = Math.PI / 36; // per key stroke
const kRight = Math.PI / 2;

/** A direction of view, shared by views. `up` is a unit vector. */
class Camera {
  constructor(up, yaw, pitch) {
    this.up = up;
    this.fit = () => ({ zoom: 1, pan: [0, 0] }); // view in a new direction
    const x = Math.abs(up[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0];
    this.east = unitOf(sub(x, times(dot(x, up), up)));
    this.north = cross(up, this.east);
    this.first = { yaw, pitch };
    this.listeners = [];
    this.reset();
  }
  reset() {
    this.look(this.first.yaw, this.first.pitch);
  }
  listen(callback) {
    this.listeners.push(callback);
  }
  changed() {
    for (const callback of this.listeners) callback();
  }
  look(yaw, pitch) {
    Object.assign(this, { yaw, pitch });
    Object.assign(this, this.fit());
    this.changed();
  }
  turnBy(yaw, pitch) {
    this.yaw += yaw;
    this.pitch = Math.min(Math.max(this.pitch + pitch, -kRight), kRight);
    this.changed();
  }
  /** Moves the picture; in shares of half the view. */
  panBy(x, y) {
    this.pan = [this.pan[0] + x, this.pan[1] + y];
    this.changed();
  }
  /** About a point of the picture, in shares of half the view from its middle. */
  zoomBy(factor, about = [0, 0]) {
    const zoom = Math.min(Math.max(this.zoom * factor, 0.2), 200);
    const grown = zoom / this.zoom;
    this.pan = this.pan.map((p, c) => about[c] + grown * (p - about[c]));
    this.zoom = zoom;
    this.changed();
  }
  /** Right, up and towards the eye: rows of a rotation. */
  basis() {
    const [c, s, cp, sp] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch), Math.sin(this.pitch)];
    const flat = add(times(c, this.east), times(s, this.north));
    const eye = add(times(cp, flat), times(sp, this.up));
    const right = add(times(-s, this.east), times(c, this.north));
    return [...right, ...cross(eye, right), ...eye];
  }
}

/** Upward: against gravity, along the axis that is nearest to it; of a planar model z. */
function upOf(scene) {
  const g = scene.gravity;
  const most = Math.max(...g.map(Math.abs));
  if (scene.isPlanar || most === 0) return [0, 0, 1];
  const at = g.findIndex((c) => Math.abs(c) === most);
  return [0, 1, 2].map((c) => (c === at ? -Math.sign(g[c]) : 0));
}

/** Planar models from above; others obliquely, so that a rotor's disc is seen. */
function makeCamera(scene) {
  const up = upOf(scene);
  if (scene.isPlanar) return new Camera(up, -kRight, kRight);
  const camera = new Camera(up, 0, 0);
  const flat = [dot(scene.axis, camera.east), dot(scene.axis, camera.north)];
  const isLevel = Math.abs(dot(scene.axis, up)) < 0.7;
  const yaw = isLevel ? Math.atan2(-flat[1], -flat[0]) + 0.7 : -1.0;
  return new Camera(up, yaw, isLevel ? 0.25 : 0.5);
}

/** Lets pointer, wheel and keys on a canvas move a camera. The wheel zooms once the canvas has the
 *  focus, so that it scrolls the page otherwise. */
class Handling {
  constructor(canvas, camera) {
    Object.assign(this, { canvas, camera });
    this.pointers = new Map();
    const on = (name, handle, options) => canvas.addEventListener(name, handle, options);
    on('pointerdown', (event) => this.press(event));
    on('pointermove', (event) => this.drag(event));
    for (const name of ['pointerup', 'pointercancel'])
      on(name, (event) => this.pointers.delete(event.pointerId));
    on('contextmenu', (event) => event.preventDefault());
    on('dblclick', () => camera.reset());
    on('wheel', (event) => this.roll(event), { passive: false });
    on('keydown', (event) => this.type(event));
  }
  /** In shares of half the view from its middle, up positive. */
  placeOf({ clientX, clientY }) {
    const box = this.canvas.getBoundingClientRect();
    const half = Math.min(box.width, box.height) / 2;
    return [(clientX - box.left - box.width / 2) / half, (box.top + box.height / 2 - clientY) / half];
  }
  press(event) {
    this.canvas.focus({ preventScroll: true });
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, this.placeOf(event));
    event.preventDefault();
  }
  drag(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = this.placeOf(event);
    this.pointers.set(event.pointerId, now);
    const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
    const others = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
    if (others.length > 0) {
      const apart = (place) => Math.hypot(place[0] - others[0][0], place[1] - others[0][1]);
      this.camera.panBy(dx / 2, dy / 2);
      if (apart(before) > 0) this.camera.zoomBy(apart(now) / apart(before), others[0]);
    } else if (event.shiftKey || (event.buttons & 6) !== 0) {
      this.camera.panBy(dx, dy);
    } else {
      this.camera.turnBy(-1.8 * dx, -1.8 * dy);
    }
  }
  roll(event) {
    if (document.activeElement !== this.canvas && !event.ctrlKey) return;
    event.preventDefault();
    this.camera.zoomBy(Math.exp(-0.0015 * event.deltaY), this.placeOf(event));
  }
  type(event) {
    const { camera } = this;
    const move = (x, y) => (event.shiftKey ? camera.panBy(-0.1 * x, -0.1 * y) : camera.turnBy(kTurnStep * x, kTurnStep * y));
    const actions = {
      ArrowLeft: () => move(-1, 0), ArrowRight: () => move(1, 0),
      ArrowUp: () => move(0, 1), ArrowDown: () => move(0, -1),
      '+': () => camera.zoomBy(1.25), '=': () => camera.zoomBy(1.25), '-': () => camera.zoomBy(0.8),
      0: () => camera.reset(),
    };
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    action();
  }
}

/** Buttons that look from fixed directions. */
function addLooks(host, camera) {
  const looks = { Top: [-kRight, kRight], Front: [-kRight, 0], Side: [0, 0], Oblique: [-1.0, 0.5] };
  for (const [name, [yaw, pitch]] of Object.entries(looks)) {
    const button = make('button', { type: 'button', textContent: name });
    button.addEventListener('click', () => camera.look(yaw, pitch));
    host.append(button);
  }
  const reset = make('button', { type: 'button', textContent: 'Reset view' });
  reset.addEventListener('click', () => camera.reset());
  host.append(reset);
}
