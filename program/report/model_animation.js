// States of a scene over time, and in between on straight lines. Uses page_tools.js, space_math.js and
// scene.js.

/** data: {times; hub: by frame (place, angle about the axis), a pose, or on a support the pose at an angle
 *  of 0 and the angle; groups: poses by frame and group but the first, on a support in the frame of its
 *  base, which has its own in the inertial frame; displacements, rotations: by frame and node, as shares of units; forces; solids:
   *  numbers of frames; largest: what solids show at most, and when they are displaced most}. */
class ModelAnimation {
  constructor(scene, data) {
    this.scene = scene;
    this.times = decode(data.times, Float32Array);
    this.hub = decode(data.hub, Float32Array);
    this.groups = decode(data.groups, Float32Array);
    this.displacements = decode(data.displacements, Int16Array);
    this.rotations = decode(data.rotations, Int16Array);
    this.units = data.units;
    this.forces = { axial: decode(data.axial, Int16Array), bending: decode(data.bending, Int16Array) };
    this.solids = data.solids.map(({ numbers, shares, units }) =>
      numbers === undefined ? { shares: decode(shares, Int16Array), units } : { shares: decode(numbers, Float32Array), units: [1, 1] });
    this.ofSolids = data.largest;
    this.hubSize = this.hub.length / this.times.length;
    this.nodeSize = this.displacements.length / (this.times.length * scene.nodeCount);
    this.turnSize = this.rotations.length / (this.times.length * scene.nodeCount);
    this.largest = this.findLargest();
    this.bounds = [false, true].map((isInertial) => this.findBounds(isInertial));
  }
  get begin() {
    return this.times[0];
  }
  get end() {
    return this.times[this.times.length - 1];
  }

  /** The largest displacement of all [m], and when. */
  findLargest() {
    let [square, frame] = [0, 0];
    const { displacements: d, nodeSize } = this;
    for (let k = 0; k < d.length; k += nodeSize) {
      let sum = 0;
      for (let c = 0; c < nodeSize; ++c) sum += d[k + c] * d[k + c];
      if (sum > square) [square, frame] = [sum, Math.floor(k / (nodeSize * this.scene.nodeCount))];
    }
    const ofNodes = { size: Math.sqrt(square) * this.units.displacement, time: this.times[frame] };
    const { displacement, time } = this.ofSolids;
    return displacement > ofNodes.size ? { size: displacement, time } : ofNodes;
  }
  /** The largest value of a kind of colours: in size, in SI units. */
  largestOf(kind) {
    if (kind === 'displacement') return this.scene.meshes.length > 0 ? this.largest.size : 0;
    if (kind === 'von_mises') return this.ofSolids.vonMises;
    return this.forces[kind].reduce((most, value) => Math.max(most, Math.abs(value)), 0) * this.units[kind];
  }

  /** Where a time stands between two frames. */
  place(time) {
    const after = Math.min(Math.max(1, lowerBound(this.times, time)), this.times.length - 1);
    const before = Math.max(0, after - 1);
    const length = this.times[after] - this.times[before];
    const share = length > 0 ? (time - this.times[before]) / length : 0;
    return { before, after, share: Math.min(Math.max(share, 0), 1) };
  }
  hubAt({ before, after, share }) {
    const { hub, hubSize } = this;
    const [a, b] = [hubSize * before, hubSize * after];
    if (hubSize === 7) return poseBetween(hub, a, b, share);
    const value = (c) => hub[a + c] + share * (hub[b + c] - hub[a + c]);
    if (hubSize === 8) {
      const { p, R } = poseBetween(hub, a, b, share);
      return { p, R: product(R, rotationOf(times(value(7), this.scene.axis))) };
    }
    return { p: [value(0), value(1), value(2)], R: rotationOf(times(value(3), this.scene.axis)) };
  }
  groupAt(group, { before, after, share }) {
    if (group === 0) return { p: [0, 0, 0], R: kUnit };
    const moving = this.scene.groups - 1;
    return poseBetween(this.groups, 7 * (moving * before + group - 1), 7 * (moving * after + group - 1), share);
  }
  /** Numbers of a frame, in between of two; of a node three: of the plane x, y and the angle. */
  spread(numbers, unit, perNode, { before, after, share }) {
    const { nodeCount } = this.scene;
    const made = new Float64Array(3 * nodeCount);
    const [a, b] = [perNode * nodeCount * before, perNode * nodeCount * after];
    for (let k = 0; k < nodeCount; ++k)
      for (let c = 0; c < perNode; ++c) {
        const at = perNode * k + c;
        made[3 * k + (perNode === 1 ? 2 : c)] = unit * (numbers[a + at] + share * (numbers[b + at] - numbers[a + at]));
      }
    return made;
  }
  /** Numbers of each solid; those of a nodal one are displacements, and behind them stresses. */
  solidsAt({ before, after, share }) {
    return this.solids.map(({ shares, units }, m) => {
      const surface = this.scene.surfaces[this.scene.meshes[m].surface];
      const { frameSize } = surface;
      if (shares.length === 0) return [];
      const stresses = surface.shapes ? frameSize : 3 * surface.nodeCount;
      return Float64Array.from({ length: frameSize }, (_, i) => {
        const [a, b] = [shares[frameSize * before + i], shares[frameSize * after + i]];
        return units[i < stresses ? 0 : 1] * (a + share * (b - a));
      });
    });
  }
  forcesAt(kind, { before, after, share }) {
    const { elementCount } = this.scene;
    const numbers = this.forces[kind];
    const made = new Float64Array(elementCount);
    for (let e = 0; e < elementCount; ++e) {
      const [a, b] = [numbers[elementCount * before + e], numbers[elementCount * after + e]];
      made[e] = this.units[kind] * (a + share * (b - a));
    }
    return made;
  }

  /** Where the hub is if the end of its support is displaced and turned `scale` times as much. */
  movedHub(hub, base, displacements, rotations, scale) {
    const node = this.scene.base.hub;
    const more = (v) => times(scale - 1, turn(base.R, [v[3 * node], v[3 * node + 1], v[3 * node + 2]]));
    return { p: add(hub.p, more(displacements)), R: product(rotationOf(more(rotations)), hub.R) };
  }
  /** Moves the other hubs of a support, and what they carry, where they are if it is deformed `scale` times as much. */
  moveOtherHubs({ groups, displacements, rotations }, scale) {
    for (const { node, group, groups: carried } of this.scene.base.hubs) {
      const more = (v) => times(scale - 1, [v[3 * node], v[3 * node + 1], v[3 * node + 2]]);
      const [shift, R, { p: center }] = [more(displacements), rotationOf(more(rotations)), groups[group]];
      for (const g of carried)
        groups[g] = {
          p: add(add(center, shift), turn(R, sub(groups[g].p, center))),
          R: product(R, groups[g].R),
        };
    }
  }
  /** Takes what is on a support from the frame of its base to that of the hub. */
  turnToHub(state, scale) {
    const { scene } = this;
    const { group: first } = scene.base;
    const { groups, displacements, rotations } = state;
    const base = groups[first];
    if (scale !== 1) this.moveOtherHubs(state, scale);
    const hub = this.movedHub(state.hub, base, displacements, rotations, scale);
    const toHub = { p: turnBack(hub.R, sub(base.p, hub.p)), R: product(transposed(hub.R), base.R) };
    state.hub = hub;
    groups[first] = toHub;
    for (let g = first + 1; g < groups.length; ++g)
      groups[g] = { p: add(toHub.p, turn(toHub.R, groups[g].p)), R: product(toHub.R, groups[g].R) };
    for (let k = 0; k < scene.nodeCount; ++k)
      if (scene.nodeGroups[k] >= first)
        for (const v of [displacements, rotations])
          v.set(turn(toHub.R, [v[3 * k], v[3 * k + 1], v[3 * k + 2]]), 3 * k);
    return state;
  }

  /** The state at a time. `scale`: by which it will be deformed; a hub goes with its support. */
  at(time, scale = 1) {
    const place = this.place(time);
    const state = {
      hub: this.hubAt(place),
      groups: Array.from({ length: this.scene.groups }, (_, g) => this.groupAt(g, place)),
      displacements: this.spread(this.displacements, this.units.displacement, this.nodeSize, place),
      rotations: this.spread(this.rotations, this.units.rotation, this.turnSize, place),
      solids: this.scene.solidsOf(this.solidsAt(place)),
      forces: (kind) => this.forcesAt(kind, place),
    };
    return this.scene.base ? this.turnToHub(state, scale) : state;
  }
  /** Where a node is at a time, in the inertial frame. */
  nodeAt(node, time, scale) {
    if (this.scene.base) {
      const state = this.at(time, scale);
      return add(state.hub.p, turn(state.hub.R, placeOf(this.scene, state, scale, node)));
    }
    const place = this.place(time);
    const group = this.groupAt(this.scene.nodeGroups[node], place);
    const hub = this.hubAt(place);
    let p = add(group.p, turn(group.R, this.scene.nodePlace(node)));
    const { before, after, share } = place;
    const { displacements: d, nodeSize } = this;
    const at = (frame, c) => d[nodeSize * (this.scene.nodeCount * frame + node) + c];
    const u = [0, 1, 2].map((c) =>
      c < nodeSize ? scale * this.units.displacement * (at(before, c) + share * (at(after, c) - at(before, c))) : 0,
    );
    return add(hub.p, turn(hub.R, add(p, u)));
  }

  /** The sphere in which all is that is ever seen; how far the hub travels. */
  findBounds(isInertial) {
    const frames = Math.min(this.times.length, 60);
    const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    const hubs = [];
    const places = [];
    const reaches = Array.from({ length: this.scene.nodeCount }, (_, k) => this.scene.reachOf(k));
    for (let f = 0; f < frames; ++f) {
      const time = this.times[Math.round((f * (this.times.length - 1)) / Math.max(1, frames - 1))];
      const state = this.at(time);
      const { p, R } = isInertial ? state.hub : { p: [0, 0, 0], R: kUnit };
      hubs.push(p);
      places.push({ p, reach: this.scene.reachOf(-1) });
      placesOf(this.scene, state, 1).forEach((v, k) =>
        places.push({ p: add(p, turn(R, v)), reach: reaches[k] }));
      for (const v of placesOfMeshes(this.scene, state)) places.push({ p: add(p, turn(R, v)), reach: 0 });
    }
    for (const { p, reach } of places)
      for (let c = 0; c < 3; ++c) {
        low[c] = Math.min(low[c], p[c] - reach);
        high[c] = Math.max(high[c], p[c] + reach);
      }
    return boundsOf(places, low, high, hubs);
  }
}
