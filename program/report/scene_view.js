// Draws a scene on a canvas: faces from back to front, shaded, then lines and marks on top. Takes any
// state of the scene, from an animation or made otherwise. Uses page_tools.js, space_math.js, scene.js,
// camera.js and scene_marks.js.

// Direction from which light comes, in axes of the picture.
const kLight = unitOf([-0.35, 0.55, 0.75]);
const kThinnest = 1.4; // half the width of a thin beam [pixels]

/** "#rrggbb" as three numbers. */
function rgbOf(text) {
  const number = parseInt(text.slice(1), 16);
  return [number >> 16, (number >> 8) & 255, number & 255];
}

const kScales = {
  axial: [[49, 104, 184], [150, 184, 224], [200, 200, 200], [240, 160, 120], [196, 50, 40]],
  bending: [[72, 33, 115], [49, 104, 142], [33, 145, 140], [94, 201, 98], [253, 231, 37]],
};

/** The colour of a share of a scale, 0 to 1. */
function colorAt(scale, share) {
  const at = Math.min(Math.max(share, 0), 1) * (scale.length - 1);
  const k = Math.min(Math.floor(at), scale.length - 2);
  return scale[k].map((c, i) => c + (at - k) * (scale[k + 1][i] - c));
}

/** The legend of a scale of colours; none for those of trees. */
function showScale(host, kind, most) {
  host.hidden = kind === 'tree';
  if (host.hidden) return;
  const stops = kScales[kind].map((rgb) => `rgb(${rgb.map(Math.round).join(' ')})`).join(', ');
  const bar = make('span', { className: 'bar' });
  bar.style.background = `linear-gradient(to right, ${stops})`;
  const unit = kind === 'axial' ? 'N' : 'N m';
  const low = kind === 'axial' ? -most : 0;
  const what = kind === 'axial' ? 'Axial force, tension positive' : 'Bending moment';
  host.replaceChildren(`${what}: ${numberText(low)} ${unit}`, bar, `${numberText(most)} ${unit}`);
}

/** Points from a to b in the picture, to and fro in between. */
function coilPoints(a, b) {
  const kTurns = 6;
  const [x, y] = [b[0] - a[0], b[1] - a[1]];
  const length = Math.hypot(x, y);
  const half = length > 0 ? Math.min(5, 0.15 * length) / length : 0;
  const at = (share, side) => [
    a[0] + share * x - side * half * y, a[1] + share * y + side * half * x, a[2] + share * (b[2] - a[2])];
  const turns = Array.from({ length: 2 * kTurns }, (_, k) => at(0.2 + (0.6 * (k + 0.5)) / (2 * kTurns), k % 2 ? -1 : 1));
  return [a, at(0.2, 0), ...turns, at(0.8, 0), b];
}

class SceneView {
  /** bounds: {centre, radius, travel}; settings: {scale, color, outline, joints, loads, axes, names},
   *  shared by views. `colors(state)`: the colour of an element, or null for that of its tree. */
  constructor(canvas, scene, camera, settings, { isInertial, bounds, colors = () => null }) {
    Object.assign(this, { canvas, scene, camera, settings, isInertial, bounds, colors });
    // A hub that goes far takes the view with it.
    this.follows = isInertial && bounds.travel > bounds.radius;
    this.handling = new Handling(canvas, camera);
    this.shown = null;
    new ResizeObserver(() => this.shown && this.draw(...this.shown)).observe(canvas);
  }

  /** Half the width of what is shown [m]. */
  extent(largest) {
    const { bounds, settings } = this;
    const radius = this.follows ? bounds.radius - bounds.travel / 2 : bounds.radius;
    const reach = Math.min(radius + 0.35 * (settings.scale - 1) * largest, 1.6 * radius);
    return (1.06 * reach) / this.camera.zoom;
  }

  /** extras: {trails: lines in the inertial frame, as {tree, points}, the newest point last; largest:
   *  displacement that is ever shown [m]}. */
  draw(state, extras = {}) {
    const { trails = [], largest = 0 } = extras;
    Object.assign(this, { state, shown: [state, extras] });
    const { context, width, height } = prepareCanvas(this.canvas);
    const half = Math.min(width, height) / 2;
    const pixels = half / this.extent(largest);
    const basis = this.camera.basis();
    const hub = this.isInertial ? state.hub : { p: [0, 0, 0], R: kUnit };
    const centre = this.follows ? hub.p : this.bounds.centre;
    const middle = [width / 2 + half * this.camera.pan[0], height / 2 - half * this.camera.pan[1]];
    // Maps the hub's frame to the picture: x and y in pixels, depth in metres towards the eye.
    const R = product(basis, hub.R);
    const shift = turn(basis, sub(hub.p, centre));
    const toScreen = (v) => [middle[0] + pixels * v[0], middle[1] - pixels * v[1], v[2]];
    this.frame = {
      context, width, height, pixels, basis, hub, R, centre,
      at: (p) => toScreen(add(shift, turn(R, p))),
      inertialAt: (p) => toScreen(turn(basis, sub(p, centre))),
      extent: half / pixels,
    };
    this.deformed = new Deformed(this.scene, state, this.settings.scale);
    drawGround(this);
    if (this.settings.outline && (this.settings.scale > 0 || !this.isAtRest(state))) this.drawOutline();
    for (const trail of trails) this.drawTrail(trail);
    this.drawFaces();
    drawMarks(this);
  }
  isAtRest(state) {
    return state.displacements.every((u) => u === 0);
  }

  treeColor(tree) {
    return tree < 0 ? colorOf('--soft') : seriesColor(tree);
  }

  /** Undeformed axes, dashed. */
  drawOutline() {
    const { context, at } = this.frame;
    const rest = placesOf(this.scene, this.state, 0);
    context.strokeStyle = colorOf('--soft');
    context.lineWidth = 1.25;
    context.setLineDash([5, 5]);
    for (const { first, nodes } of this.scene.strips) {
      context.beginPath();
      for (let k = first; k < first + nodes; ++k) context.lineTo(...at(rest[k]));
      context.stroke();
    }
    context.setLineDash([]);
  }
  drawTrail({ tree, points }) {
    const { context, inertialAt } = this.frame;
    context.strokeStyle = this.treeColor(tree);
    context.lineWidth = 1.5;
    for (let k = 1; k < points.length; ++k) {
      context.globalAlpha = 0.45 * (k / (points.length - 1)) ** 1.5;
      context.beginPath();
      context.moveTo(...inertialAt(points[k - 1]));
      context.lineTo(...inertialAt(points[k]));
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  drawFaces() {
    this.faces = [];
    const element = this.colors(this.state);
    this.scene.strips.forEach((strip) => this.addStrip(strip, element));
    for (const solid of this.scene.solids) this.addSolid(solid);
    for (const link of this.scene.links) this.addLink(link);
    for (const loop of this.scene.loops) if (loop.kind === 'distance') this.addRod(loop);
    this.faces.sort((a, b) => a.depth - b.depth);
    const { context } = this.frame;
    context.lineJoin = 'round';
    for (const { points, color } of this.faces) {
      context.fillStyle = context.strokeStyle = color;
      context.lineWidth = points.length === 2 ? 2.5 : 0.8; // also hides the seam between faces
      context.beginPath();
      for (const [x, y] of points) context.lineTo(x, y);
      context.closePath();
      context.fill();
      context.stroke();
    }
  }
  /** A face, unless it is seen from behind. points: counterclockwise from outside. */
  addFace(points, rgb, isOpen = false) {
    const { pixels } = this.frame;
    const edge = (a, b) => [(b[0] - a[0]) / pixels, (a[1] - b[1]) / pixels, b[2] - a[2]];
    const [a, b, c] = points;
    let normal = cross(edge(a, b), edge(a, c));
    if (points.length > 3 && size(normal) < 1e-12) normal = cross(edge(a, c), edge(a, points[3]));
    if (normal[2] <= 0 && !isOpen) return;
    const lit = 0.62 + 0.42 * Math.max(0, dot(unitOf(normal), kLight));
    const depth = points.reduce((sum, p) => sum + p[2], 0) / points.length;
    const channel = (value) => Math.min(255, Math.round(value * lit));
    this.faces.push({ points, depth, color: `rgb(${channel(rgb[0])},${channel(rgb[1])},${channel(rgb[2])})` });
  }

  /** The outline of a ring in the picture. Thin ones are drawn as thick as can be seen. */
  outlineOf({ p, y, z, halfY, halfZ }, sides) {
    const { at, R, pixels } = this.frame;
    const thin = kThinnest / pixels;
    const [a, b] = [Math.max(halfY, thin), Math.max(halfZ, thin)];
    const [centre, ey, ez] = [at(p), turn(R, y), turn(R, z)];
    return Array.from({ length: sides }, (_, k) => {
      const angle = (2 * Math.PI * k) / sides;
      const [c, s] = [a * Math.cos(angle), b * Math.sin(angle)];
      return [
        centre[0] + pixels * (c * ey[0] + s * ez[0]),
        centre[1] - pixels * (c * ey[1] + s * ez[1]),
        centre[2] + c * ey[2] + s * ez[2],
      ];
    });
  }
  addStrip(strip, elementColor) {
    const sides = this.scene.elementCount > 600 ? 6 : 12;
    const plain = rgbOf(this.treeColor(strip.tree));
    const rings = this.deformed.ringsOf(strip);
    const outlines = rings.map((ring) => this.outlineOf(ring, sides));
    for (let k = 0; k + 1 < rings.length; ++k) {
      const element = strip.firstElement + rings[k].node - strip.first;
      const rgb = elementColor ? elementColor(element) : plain;
      const [inner, outer] = [outlines[k], outlines[k + 1]];
      for (let i = 0; i < sides; ++i) {
        const j = (i + 1) % sides;
        this.addFace([inner[i], inner[j], outer[j], outer[i]], rgb);
      }
      if (k === 0 && strip.hasRoot) this.addFace([...inner].reverse(), rgb);
      if (k + 2 === rings.length && strip.hasTip) this.addFace(outer, rgb);
    }
  }
  addSolid({ tree, node, group, vertices, faces }) {
    const rgb = rgbOf(this.treeColor(tree));
    const points = [];
    for (let k = 0; k < vertices.length; k += 3)
      points.push(this.frame.at(this.deformed.at({ node, group, xi: 0, p: vertices.subarray(k, k + 3) }).p));
    for (const face of faces) this.addFace(face.map((k) => points[k]), rgb);
  }
  addLink({ tree, node, from, to }) {
    const [a, b] = [from, to].map((p) => this.frame.at(this.deformed.at({ node, xi: 0, p }).p));
    this.addLine(a, b, this.treeColor(tree));
  }
  addLine(a, b, color) {
    this.faces.push({ points: [a, b], depth: (a[2] + b[2]) / 2, color });
  }
  /** The rod of a loop; as a coil if it gives. */
  addRod({ from, to, isSprung }) {
    const points = (isSprung ? coilPoints : (...ends) => ends)(
      ...[from, to].map((end) => this.frame.at(this.deformed.at(end).p)));
    for (let k = 1; k < points.length; ++k) this.addLine(points[k - 1], points[k], colorOf('--ink'));
  }
}
