// Draws marks behind and on top of a scene: ground, joints and their axes, loads, section axes,
// names, the directions of the frame, a ruler. Uses page_tools.js, space_math.js and scene.js.

/** Size of a joint's mark [pixels]. */
const glyphSize = (view) => Math.min(Math.max(0.025 * view.bounds.radius * view.frame.pixels, 6), 15);

/** Rings around the hub's axis, or a grid that stands still. */
function drawGround(view) {
  const { context, extent, hub, centre, at, inertialAt } = view.frame;
  const { scene, camera } = view;
  const step = roundTicks(0, extent, 4).step;
  context.strokeStyle = colorOf('--rule');
  context.lineWidth = 1;
  context.beginPath();
  if (view.isInertial) {
    // The ground goes through the hub, or below a model that stands upright.
    const isUpright = !scene.isPlanar && Math.abs(dot(scene.axis, camera.up)) < 0.7;
    const level = dot(hub.p, camera.up) - (isUpright ? view.bounds.radius : 0);
    const point = (x, y) =>
      inertialAt(add(add(times(x, camera.east), times(y, camera.north)), times(level, camera.up)));
    const lines = 8;
    const [cx, cy] = [camera.east, camera.north].map((axis) => Math.round(dot(centre, axis) / step) * step);
    for (let k = -lines; k <= lines; ++k) {
      context.moveTo(...point(cx + k * step, cy - lines * step));
      context.lineTo(...point(cx + k * step, cy + lines * step));
      context.moveTo(...point(cx - lines * step, cy + k * step));
      context.lineTo(...point(cx + lines * step, cy + k * step));
    }
  } else {
    const [x, y] = acrossOf(scene.axis);
    for (let ring = 1; ring <= 6; ++ring)
      for (let k = 0; k <= 72; ++k) {
        const angle = (k * Math.PI) / 36;
        const p = add(times(ring * step * Math.cos(angle), x), times(ring * step * Math.sin(angle), y));
        if (k === 0) context.moveTo(...at(p));
        else context.lineTo(...at(p));
      }
  }
  context.stroke();
}

/** Two unit vectors across an axis. */
function acrossOf(axis) {
  const other = Math.abs(axis[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0];
  const x = unitOf(sub(other, times(dot(other, axis), axis)));
  return [x, cross(axis, x)];
}

function drawMarks(view) {
  drawBodyEnds(view);
  if (view.settings.axes) drawSectionAxes(view);
  drawHubAxis(view);
  if (view.settings.joints || view.settings.names)
    for (const { interfaces } of view.scene.meshes)
      for (const { node } of interfaces) drawInterface(view, node);
  if (view.settings.joints) {
    for (const joint of view.scene.joints) drawJoint(view, joint);
    for (const loop of view.scene.loops) drawLoop(view, loop);
  }
  if (view.settings.loads) drawLoads(view);
  if (view.settings.sensors) for (const sensor of view.scene.sensors) drawSensor(view, sensor);
  if (view.settings.names) drawNames(view);
  drawDirections(view);
  drawRuler(view);
}

/** A line with a head, on the screen. */
function drawArrow(context, from, to, heads = 1) {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  strokeLine(context, [from, to]);
  if (length < 3) return;
  const [x, y] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  const head = Math.min(8, 0.6 * length);
  for (let k = 0; k < heads; ++k) {
    const [tx, ty] = [to[0] - 5 * k * x, to[1] - 5 * k * y];
    context.beginPath();
    context.moveTo(tx, ty);
    context.lineTo(tx - head * x + 0.4 * head * y, ty - head * y - 0.4 * head * x);
    context.lineTo(tx - head * x - 0.4 * head * y, ty - head * y + 0.4 * head * x);
    context.closePath();
    context.fill();
  }
}

/** Text with the page's colour around it, so that it can be read on everything. */
function drawText(context, text, x, y, color) {
  context.font = '12px system-ui, sans-serif';
  context.lineJoin = 'round';
  context.lineWidth = 3.5;
  context.strokeStyle = colorOf('--panel');
  context.strokeText(text, x, y);
  context.fillStyle = color;
  context.fillText(text, x, y);
}

/** Dots where a body begins that another one carries, and at the tips. */
function drawBodyEnds(view) {
  const { context, at } = view.frame;
  const { strips, tips } = view.scene;
  context.fillStyle = colorOf('--paper');
  context.lineWidth = 1.5;
  const seen = new Set();
  const mark = (node, tree) => {
    const [x, y] = at(view.deformed.places[node]);
    context.strokeStyle = view.treeColor(tree);
    context.beginPath();
    context.arc(x, y, 2.5, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  };
  for (const { tree, first } of strips) {
    if (seen.has(tree)) mark(first, tree);
    seen.add(tree);
  }
  tips.forEach((node, tree) => seen.has(tree) && mark(node, tree));
}

/** At some sections, as far apart as can be read, their y axis, and their z axis. */
function drawSectionAxes(view) {
  const { context, at, pixels } = view.frame;
  const kApart = 45; // pixels
  context.lineWidth = 1.5;
  let last = [-Infinity, -Infinity];
  for (const strip of view.scene.strips)
    for (const { p, y, z, halfY, halfZ } of view.deformed.ringsOf(strip)) {
      const origin = at(p);
      if (Math.hypot(origin[0] - last[0], origin[1] - last[1]) < kApart) continue;
      last = origin;
      const length = Math.max(1.35 * Math.max(halfY, halfZ), 16 / pixels);
      [[y, '--s2'], [z, '--s3']].forEach(([axis, color]) => {
        context.strokeStyle = context.fillStyle = colorOf(color);
        drawArrow(context, origin, at(add(p, times(length, axis))));
      });
    }
}

function drawHubAxis(view) {
  const { context, at, pixels } = view.frame;
  if (view.scene.isPlanar) return drawHubTurn(view);
  const length = Math.max(0.2 * view.bounds.radius, 24 / pixels);
  context.strokeStyle = context.fillStyle = colorOf('--ink');
  context.lineWidth = 1.25;
  context.setLineDash([8, 3, 2, 3]);
  const { p, R } = view.state.groups[0]; // the hub, where it is not the frame that is drawn
  const end = turn(R, times(length, view.scene.axis));
  drawArrow(context, at(sub(p, end)), at(add(p, end)));
  context.setLineDash([]);
}

/** A stroke that shows how the hub of a planar model is turned. */
function drawHubTurn(view) {
  const { context, at, pixels } = view.frame;
  context.strokeStyle = colorOf('--ink');
  context.lineWidth = 2;
  const [hub] = view.scene.solids;
  const radius = hub ? Math.hypot(hub.vertices[0], hub.vertices[1]) : 10 / pixels;
  strokeLine(context, [at([0, 0, 0]), at([radius, 0, 0])]);
}

/** The axes of a joint's freedoms: a ring about those of rotation, arrows along those of translation,
 *  a double ring for all rotations, a square where nothing moves. */
function drawJoint(view, { kind, node, axes, coordinates }) {
  const place = { node, xi: 0, p: view.scene.nodePlace(node) };
  drawMotions(view, kind, place, axes, colorOf(coordinates.includes('prescribed') ? '--s3' : '--ink'));
}

/** A closure as a joint is drawn, in a colour of its own; dots at the ends of a rod. */
function drawLoop(view, { kind, from, to, axes }) {
  const color = colorOf('--bad');
  if (kind !== 'distance') return drawMotions(view, kind, to, axes, color);
  const { context, at } = view.frame;
  context.fillStyle = color;
  for (const end of [from, to]) {
    const [x, y] = at(view.deformed.at(end).p);
    context.beginPath();
    context.arc(x, y, 3, 0, 2 * Math.PI);
    context.fill();
  }
}

/** What a joint of a kind lets move at a place. */
function drawMotions(view, kind, place, axes, color) {
  const { context, at, R } = view.frame;
  const { p, R: own } = view.deformed.at(place);
  const centre = at(p);
  const glyph = glyphSize(view);
  context.strokeStyle = context.fillStyle = color;
  context.lineWidth = 1.75;
  const circle = (radius) => {
    context.beginPath();
    context.arc(centre[0], centre[1], radius, 0, 2 * Math.PI);
    context.stroke();
  };
  if (kind === 'fixed') context.strokeRect(centre[0] - 4, centre[1] - 4, 8, 8);
  if (kind === 'spherical') [0.35 * glyph, 0.6 * glyph].forEach(circle);
  axes.forEach((axis) => {
    const direction = turn(R, turn(own, axis));
    const end = (share) => [centre[0] + share * glyph * direction[0], centre[1] - share * glyph * direction[1]];
    strokeLine(context, [end(-1.6), end(1.6)]);
    if (kind !== 'prismatic') drawRing(context, centre, direction, 0.55 * glyph);
    if (kind === 'prismatic' || kind === 'cylindrical') {
      drawArrow(context, centre, end(1.9));
      drawArrow(context, centre, end(-1.9));
    }
  });
}

/** A circle about a direction of the picture's axes. */
function drawRing(context, centre, direction, radius) {
  const [x, y] = acrossOf(direction);
  const points = [];
  for (let k = 0; k <= 24; ++k) {
    const [c, s] = [Math.cos((k * Math.PI) / 12), Math.sin((k * Math.PI) / 12)];
    points.push([centre[0] + radius * (c * x[0] + s * y[0]), centre[1] - radius * (c * x[1] + s * y[1])]);
  }
  strokeLine(context, points);
}

/** Forces as arrows, moments as arrows with two heads; the largest of each kind is equally long. */
function drawLoads(view) {
  const { context, at, pixels, hub } = view.frame;
  const { loads } = view.scene;
  const most = (kind, isDistributed) =>
    Math.max(...loads.filter((load) => load.isDistributed === isDistributed).map((load) => size(load[kind])), 0);
  context.strokeStyle = context.fillStyle = colorOf('--bad');
  context.lineWidth = 1.75;
  for (const load of loads) {
    const place = view.deformed.at(load);
    const R = { inertial: null, hub: kUnit }[load.frame] ?? null;
    for (const kind of ['force', 'moment']) {
      const largest = most(kind, load.isDistributed);
      if (largest === 0 || size(load[kind]) === 0) continue;
      let v = load[kind];
      if (load.frame === 'inertial') v = turnBack(view.state.hub.R, v);
      else if (R === null) v = turn(place.R, v);
      const length = (load.isDistributed ? 34 : 60) / pixels / largest;
      const tip = add(place.p, times(length, v));
      drawArrow(context, at(place.p), at(tip), kind === 'moment' ? 2 : 1);
    }
  }
}

/** A ring with a dot in it at the point of an interface. */
function drawInterface(view, node) {
  const { context, at } = view.frame;
  const [x, y] = at(view.deformed.places[node]);
  context.fillStyle = colorOf('--paper');
  context.strokeStyle = colorOf('--ink');
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(x, y, 4, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.fillStyle = colorOf('--ink');
  context.beginPath();
  context.arc(x, y, 1.25, 0, 2 * Math.PI);
  context.fill();
}

function drawSensor(view, sensor) {
  const { context, at } = view.frame;
  const [x, y] = at(view.deformed.at(sensor).p);
  context.strokeStyle = colorOf('--s3');
  context.lineWidth = 2;
  strokeLine(context, [[x - 6, y - 6], [x + 6, y + 6]]);
  strokeLine(context, [[x - 6, y + 6], [x + 6, y - 6]]);
}

/** Names of blades and subsystems, solids, joints and sensors; none on top of another. */
function drawNames(view) {
  const { context, at, width } = view.frame;
  const { scene, deformed } = view;
  const taken = [];
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  const write = (text, [x, y], color) => {
    const w = 6.4 * text.length;
    const left = Math.min(Math.max(x + 9, 4), width - w - 4);
    const box = [left, y - 16, left + w, y - 2];
    if (taken.some((b) => box[0] < b[2] && b[0] < box[2] && box[1] < b[3] && b[1] < box[3])) return;
    taken.push(box);
    drawText(context, text, left, y - 9, color);
  };
  scene.trees.forEach((name, tree) => write(name, at(deformed.places[scene.tips[tree]]), view.treeColor(tree)));
  const short = (name) => name.split(' / ').pop();
  for (const { name, node } of scene.joints) write(short(name), at(deformed.places[node]), colorOf('--ink'));
  for (const { name, from, to } of scene.loops) {
    const [a, b] = [from, to].map((end) => deformed.at(end).p);
    write(short(name), at(times(0.5, add(a, b))), colorOf('--bad'));
  }
  for (const { name, node, group, vertices } of scene.solids)
    if (node >= 0 || group > 0)
      write(short(name), at(deformed.at({ node, group, xi: 0, p: vertices.subarray(0, 3) }).p), colorOf('--soft'));
  for (const { interfaces } of scene.meshes)
    for (const { name, node } of interfaces) {
      const [x, y] = at(deformed.places[node]);
      write(name, [x, y + 20], colorOf('--ink')); // below, as a joint may stand there
    }
  for (const { name, node, surface, axes } of scene.meshes)
    write(short(name), at(deformed.at({ node, xi: 0, p: add(scene.nodePlace(node), turn(axes, scene.surfaces[surface].middle)) }).p), colorOf('--soft'));
  for (const sensor of scene.sensors) write(sensor.name, at(deformed.at(sensor).p), colorOf('--s3'));
}

/** The axes of the frame that is shown, and gravity, in a corner. */
function drawDirections(view) {
  const { context, width, height, basis, R } = view.frame;
  const [x, y] = [width - 46, height - 46];
  context.lineWidth = 1.5;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const draw = (v, name, color, length) => {
    const end = [x + length * v[0], y - length * v[1]];
    context.strokeStyle = context.fillStyle = color;
    context.lineWidth = 1.5;
    drawArrow(context, [x, y], end);
    if (Math.hypot(v[0], v[1]) > 0.25)
      drawText(context, name, x + (length + 9) * v[0], y - (length + 9) * v[1], color);
  };
  ['x', 'y', 'z'].forEach((name, c) =>
    draw(turn(basis, [0, 1, 2].map((k) => (k === c ? 1 : 0))), name, colorOf('--soft'), 24));
  const { gravity } = view.scene;
  if (size(gravity) === 0) return;
  const inView = view.isInertial ? turn(basis, gravity) : turn(R, turnBack(view.state.hub.R, gravity));
  draw(unitOf(inView), 'g', colorOf('--bad'), 30);
}

function drawRuler(view) {
  const { context, height, pixels, extent } = view.frame;
  const { step } = roundTicks(0, extent, 4);
  const y = height - 16;
  context.strokeStyle = colorOf('--soft');
  context.lineWidth = 1.5;
  strokeLine(context, [[14, y - 4], [14, y + 4]]);
  strokeLine(context, [[14, y], [14 + step * pixels, y]]);
  strokeLine(context, [[14 + step * pixels, y - 4], [14 + step * pixels, y + 4]]);
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  drawText(context, `${numberText(step)} m`, 22 + step * pixels, y, colorOf('--soft'));
}
