// Draws a scene on a canvas: faces from back to front, shaded, then lines and marks on top. Takes any
// state of the scene, from an animation or made otherwise. Uses page_tools.js, space_math.js, scene.js,
// scene_colors.js, camera.js and scene_marks.js.

// Direction from which light comes, in axes of the picture.
const kLight = unitOf([-0.35, 0.55, 0.75]);
const kThinnest = 1.4; // half the width of a thin beam [pixels]
const kLine = 2.5; // width of links and rods [pixels]
const kEven = 0.04; // shares of a scale that look alike

/** "#rrggbb" as three numbers. */
function rgbOf(text) {
  const number = parseInt(text.slice(1), 16);
  return [number >> 16, (number >> 8) & 255, number & 255];
}

/** A colour [r, g, b] in some light. */
function litColor(rgb, lit) {
  const channel = (value) => Math.min(255, Math.round(value * lit));
  return `rgb(${channel(rgb[0])},${channel(rgb[1])},${channel(rgb[2])})`;
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
   *  shared by views. `colors(state)`: as a SceneColors; by default those of trees. */
  constructor(canvas, scene, camera, settings, { isInertial, bounds, colors = (state) => new SceneColors(scene, state, 'tree', 0) }) {
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
    return state.displacements.every((u) => u === 0) && state.solids.every(({ u }) => u.every((c) => c === 0));
  }

  treeColor(tree) {
    return tree < 0 ? colorOf('--soft') : seriesColor(tree);
  }

  /** Undeformed axes and edges of solids, dashed. */
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
    this.scene.meshes.forEach((mesh, m) => this.drawMeshOutline(mesh, m));
    context.setLineDash([]);
  }
  drawMeshOutline({ surface }, m) {
    const { context, at } = this.frame;
    const { edges } = this.scene.surfaces[surface];
    const places = new Deformed(this.scene, this.state, 0).meshPlaces(m);
    context.lineWidth = 1;
    context.beginPath();
    for (let k = 0; k < edges.length; k += 2) {
      context.moveTo(...at(places.subarray(3 * edges[k], 3 * edges[k] + 3)));
      context.lineTo(...at(places.subarray(3 * edges[k + 1], 3 * edges[k + 1] + 3)));
    }
    context.stroke();
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
    const colors = this.colors(this.state);
    this.scene.strips.forEach((strip) => this.addStrip(strip, colors));
    this.scene.meshes.forEach((mesh, m) => this.addMesh(mesh, m, colors.ofMesh(m)));
    for (const solid of this.scene.solids) this.addSolid(solid);
    for (const link of this.scene.links) this.addLink(link);
    for (const loop of this.scene.loops) if (loop.kind === 'distance') this.addRod(loop);
    this.faces.sort((a, b) => a.depth - b.depth);
    const { context } = this.frame;
    context.lineJoin = 'round';
    for (const { points, color, width } of this.faces) {
      context.fillStyle = context.strokeStyle = color;
      context.lineWidth = width; // of a face it hides the seam to the next one
      context.beginPath();
      for (const [x, y] of points) context.lineTo(x, y);
      context.closePath();
      context.fill();
      context.stroke();
    }
  }
  /** How bright a face is; 0 if it is seen from behind. points: counterclockwise from outside. */
  litOf(points, isOpen = false) {
    const { pixels } = this.frame;
    const edge = (a, b) => [(b[0] - a[0]) / pixels, (a[1] - b[1]) / pixels, b[2] - a[2]];
    const [a, b, c] = points;
    let normal = cross(edge(a, b), edge(a, c));
    if (points.length > 3 && size(normal) < 1e-12) normal = cross(edge(a, c), edge(a, points[3]));
    if (normal[2] <= 0 && !isOpen) return 0;
    return 0.62 + 0.42 * Math.max(0, dot(unitOf(normal), kLight));
  }
  pushFace(points, color) {
    const depth = points.reduce((sum, p) => sum + p[2], 0) / points.length;
    this.faces.push({ points, depth, color, width: 0.8 });
  }
  /** A face, unless it is seen from behind; whether it is there. */
  addFace(points, rgb, isOpen = false) {
    const lit = this.litOf(points, isOpen);
    if (lit > 0) this.pushFace(points, litColor(rgb, lit));
    return lit > 0;
  }
  /** A triangle whose corners have shares of a scale: colours change evenly across it. */
  addShadedTriangle(points, shares, scale) {
    const lit = this.litOf(points);
    if (lit === 0) return false;
    const [low, high] = [Math.min(...shares), Math.max(...shares)];
    const [[ax, ay], [bx, by], [cx, cy]] = points;
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (high - low < kEven || Math.abs(area) < 1e-3) {
      this.pushFace(points, litColor(colorAt(scale, (shares[0] + shares[1] + shares[2]) / 3), lit));
      return true;
    }
    // The gradient of the share in the picture.
    const [b, c] = [shares[1] - shares[0], shares[2] - shares[0]];
    const [gx, gy] = [(b * (cy - ay) - c * (by - ay)) / area, (c * (bx - ax) - b * (cx - ax)) / area];
    const length = (high - low) / (gx * gx + gy * gy);
    const [x, y] = points[shares.indexOf(low)];
    const color = this.frame.context.createLinearGradient(x, y, x + length * gx, y + length * gy);
    const stops = [low, ...scale.map((_, k) => k / (scale.length - 1)).filter((s) => s > low && s < high), high];
    for (const s of stops) color.addColorStop((s - low) / (high - low), litColor(colorAt(scale, s), lit));
    this.pushFace(points, color);
    return true;
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
  addStrip(strip, colors) {
    const sides = this.scene.elementCount > 600 ? 6 : 12;
    const plain = rgbOf(this.treeColor(strip.tree));
    const rings = this.deformed.ringsOf(strip);
    const outlines = rings.map((ring) => this.outlineOf(ring, sides));
    for (let k = 0; k + 1 < rings.length; ++k) {
      const element = strip.firstElement + rings[k].node - strip.first;
      const rgb = colors.ofElement(element, rings[k].node) ?? plain;
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
  /** A solid: its triangles, and on top of them its sharp edges. */
  addMesh({ tree, surface }, m, shading) {
    const { triangles, edges, sides, nodeCount } = this.scene.surfaces[surface];
    const plain = rgbOf(this.treeColor(tree));
    const places = this.deformed.meshPlaces(m);
    const points = Array.from({ length: nodeCount }, (_, k) => this.frame.at(places.subarray(3 * k, 3 * k + 3)));
    const isSeen = new Uint8Array(triangles.length / 3);
    for (let t = 0; t < isSeen.length; ++t) {
      const corners = [triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]];
      const own = corners.map((k) => points[k]);
      isSeen[t] = shading?.shares
        ? this.addShadedTriangle(own, corners.map((k) => shading.shares[k]), shading.scale)
        : this.addFace(own, shading?.plain ?? plain);
    }
    const [r, g, b] = plain.map((c) => Math.round((shading ? 0.2 : 0.45) * c));
    const nearer = 2e-3 * this.bounds.radius;
    sides.forEach((both, k) => {
      if (!both.some((t) => isSeen[t])) return;
      const [from, to] = [points[edges[2 * k]], points[edges[2 * k + 1]]];
      this.addLine(from, to, `rgb(${r},${g},${b})`, 1, nearer);
    });
  }
  addLink({ tree, node, from, to }) {
    const [a, b] = [from, to].map((p) => this.frame.at(this.deformed.at({ node, xi: 0, p }).p));
    this.addLine(a, b, this.treeColor(tree));
  }
  addLine(a, b, color, width = kLine, nearer = 0) {
    this.faces.push({ points: [a, b], depth: (a[2] + b[2]) / 2 + nearer, color, width });
  }
  /** The rod of a loop; as a coil if it gives. */
  addRod({ from, to, isSprung }) {
    const points = (isSprung ? coilPoints : (...ends) => ends)(
      ...[from, to].map((end) => this.frame.at(this.deformed.at(end).p)));
    for (let k = 1; k < points.length; ++k) this.addLine(points[k - 1], points[k], colorOf('--ink'));
  }
}
