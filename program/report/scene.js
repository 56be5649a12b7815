// A drawn model: nodes that states move, and the parts fixed to them. Places and directions of a
// scene are those of the undeformed model in the hub's frame. A state holds where groups of bodies
// are, and how nodes are displaced and turned from there. Uses page_tools.js, space_math.js and
// solid_surfaces.js.

const kRing = 13; // numbers of a ring: node, xi, place, y axis, z axis, two semi-axes

class Scene {
  /** data: as program/run_report/scene_data.cpp writes it. */
  constructor(data) {
    Object.assign(this, data);
    this.nodes = decode(data.nodes, Float32Array);
    this.nodeGroups = decode(data.nodeGroups, Int16Array);
    this.nodeCount = this.nodeGroups.length;
    let element = 0;
    this.strips = data.strips.map((strip) => {
      const made = { ...strip, rings: decode(strip.rings, Float32Array), firstElement: element };
      element += strip.nodes - 1;
      return made;
    });
    this.elementCount = element;
    this.strips.forEach((strip, k) => this.findEnds(strip, this.strips[k - 1]));
    this.solids = data.solids.map((solid) => ({ ...solid, vertices: decode(solid.vertices, Float32Array) }));
    this.surfaces = data.surfaces.map((surface) => new SolidSurface(surface));
  }

  /** Beams that go on have no ends to be seen where their bodies meet. */
  findEnds(strip, before) {
    Object.assign(strip, { hasRoot: true, hasTip: true });
    if (!before || before.tree !== strip.tree) return;
    const last = strip.first - 1;
    const isOne = before.first + before.nodes === strip.first && this.nodeGroups[last] === this.nodeGroups[strip.first];
    if (!isOne || size(sub(this.nodePlace(last), this.nodePlace(strip.first))) > 1e-6 * size(this.nodePlace(last))) return;
    before.hasTip = strip.hasRoot = false;
  }

  nodePlace(k) {
    return [this.nodes[3 * k], this.nodes[3 * k + 1], this.nodes[3 * k + 2]];
  }

  /** The model undeformed, its groups of bodies at `groups`. */
  stateAtRest(groups = []) {
    const none = new Float64Array(3 * this.nodeCount);
    return {
      hub: { p: [0, 0, 0], R: kUnit },
      groups: Array.from({ length: this.groups }, (_, g) => groups[g] ?? { p: [0, 0, 0], R: kUnit }),
      displacements: none,
      rotations: none,
      solids: this.solidsOf([]),
    };
  }
  /** States of solids by the numbers of a frame for each; at rest where there are none. */
  solidsOf(numbers) {
    return this.meshes.map(({ surface }, m) => this.surfaces[surface].stateOf(numbers[m] ?? []));
  }

  /** How far from a node what is fixed to it reaches; of node -1: from the hub's origin, or of an anchor
   *  from its own. */
  reachOf(node) {
    const p = node < 0 ? [0, 0, 0] : this.nodePlace(node);
    let reach = 0;
    for (const solid of this.solids)
      if (solid.node === node)
        for (let k = 0; k < solid.vertices.length; k += 3)
          reach = Math.max(reach, size(sub(solid.vertices.subarray(k, k + 3), p)));
    for (const { from, to } of this.loops)
      for (const end of [from, to]) if (end.node === node) reach = Math.max(reach, size(sub(end.p, p)));
    return reach;
  }
}

/** Where nodes are in the hub's frame, displacements multiplied by `scale`. */
function placesOf(scene, { groups, displacements: u }, scale) {
  return Array.from({ length: scene.nodeCount }, (_, k) => placeOf(scene, { groups, displacements: u }, scale, k));
}
function placeOf(scene, { groups, displacements: u }, scale, k) {
  const group = groups[scene.nodeGroups[k]];
  const d = [scale * u[3 * k], scale * u[3 * k + 1], scale * u[3 * k + 2]];
  return add(add(group.p, turn(group.R, scene.nodePlace(k))), d);
}

/** Where nodes of solids are in the hub's frame, some of them where there are very many. */
function placesOfMeshes(scene, state) {
  const count = scene.meshes.reduce((sum, { surface }) => sum + scene.surfaces[surface].nodeCount, 0);
  const step = 3 * Math.ceil(count / 20000 || 1);
  const deformed = new Deformed(scene, state, 1);
  const places = [];
  scene.meshes.forEach((_, m) => {
    const own = deformed.meshPlaces(m);
    for (let k = 0; k < own.length; k += step) places.push([own[k], own[k + 1], own[k + 2]]);
  });
  return places;
}

/** A scene at a state, displacements and rotations multiplied by `scale`; in the hub's frame. */
class Deformed {
  constructor(scene, state, scale) {
    Object.assign(this, { scene, state, scale });
    const th = state.rotations;
    this.places = placesOf(scene, state, scale);
    this.turns = this.places.map((_, k) =>
      product(this.ownTurn(th[3 * k], th[3 * k + 1], th[3 * k + 2]), state.groups[scene.nodeGroups[k]].R));
  }
  ownTurn(x, y, z) {
    const { scale } = this;
    return rotationOf([scale * x, scale * y, scale * z]);
  }

  /** Where a place {node, xi, p, group} is, and how it is turned; without a node it is fixed to its group. */
  at({ node, xi, p, group = 0 }) {
    const { scene, places, turns } = this;
    if (node < 0) {
      const { p: origin, R } = this.state.groups[group];
      return { p: add(origin, turn(R, p)), R };
    }
    const a = scene.nodePlace(node);
    if (xi === 0) return { p: add(places[node], turn(turns[node], sub(p, a))), R: turns[node] };
    // The axis between two nodes follows Hermite's cubics, whose tangents turn with the nodes.
    const chord = sub(scene.nodePlace(node + 1), a);
    const [x2, x3] = [xi * xi, xi * xi * xi];
    const weights = [1 - 3 * x2 + 2 * x3, 3 * x2 - 2 * x3, xi - 2 * x2 + x3, x3 - x2];
    const parts = [places[node], places[node + 1], turn(turns[node], chord), turn(turns[node + 1], chord)];
    const axis = [0, 1, 2].map((c) => parts.reduce((sum, part, k) => sum + weights[k] * part[c], 0));
    const th = this.state.rotations;
    const mix = (c) => th[3 * node + c] + xi * (th[3 * node + 3 + c] - th[3 * node + c]);
    const R = product(this.ownTurn(mix(0), mix(1), mix(2)), this.state.groups[scene.nodeGroups[node]].R);
    return { p: add(axis, turn(R, sub(p, add(a, times(xi, chord))))), R };
  }

  /** Where the drawn nodes of a solid are, three numbers each. */
  meshPlaces(m) {
    const { node, surface, axes } = this.scene.meshes[m];
    const { places } = this.scene.surfaces[surface];
    const { u } = this.state.solids[m];
    const [origin, R, { scale }] = [this.places[node], product(this.turns[node], axes), this];
    const made = new Float64Array(places.length);
    for (let k = 0; k < made.length; k += 3) {
      const [x, y, z] = [places[k] + scale * u[k], places[k + 1] + scale * u[k + 1], places[k + 2] + scale * u[k + 2]];
      for (let c = 0; c < 3; ++c) made[k + c] = origin[c] + R[3 * c] * x + R[3 * c + 1] * y + R[3 * c + 2] * z;
    }
    return made;
  }

  /** Centre and axes of the rings of a strip, the axes as long as the section's semi-axes. */
  ringsOf(strip) {
    const { rings } = strip;
    const made = [];
    for (let k = 0; k < rings.length; k += kRing) {
      const v = (at) => [rings[k + at], rings[k + at + 1], rings[k + at + 2]];
      const { p, R } = this.at({ node: rings[k], xi: rings[k + 1], p: v(2) });
      made.push({ p, y: turn(R, v(5)), z: turn(R, v(8)), halfY: rings[k + 11], halfZ: rings[k + 12], node: rings[k] });
    }
    return made;
  }
}

/** Centre and radius; a model that is nearly even around the hub has its centre there. */
function boundsOf(places, low, high, hubs) {
  let centre = times(0.5, add(low, high));
  const extent = size(times(0.5, sub(high, low)));
  const travel = Math.max(0, ...hubs.map((p) => size(sub(p, hubs[0]))));
  if (travel === 0 && size(sub(centre, hubs[0])) < 0.25 * extent) centre = hubs[0];
  const radius = places.reduce((most, { p, reach }) => Math.max(most, size(sub(p, centre)) + reach), 0);
  return { centre, radius: radius || 1, travel };
}
