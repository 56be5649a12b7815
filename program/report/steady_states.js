// A model in steady rotation as a scene: its place at each speed, and its motion in a mode. Uses
// page_tools.js, space_math.js and scene.js.

// Numbers of a node: displacement and rotation, real and imaginary parts of each.
const kShapeNumbers = 12;

/** data: as program/steady_report/steady_scene.cpp writes it. */
class SteadyStates {
  constructor(data) {
    this.scene = new Scene(data.scene);
    this.states = data.states.map((state) => ({
      ...state,
      value: state.value ?? state.speed, // what states differ by
      groups: this.decodeGroups(decode(state.groups, Float32Array)),
      place: state.hub ? poseBetween(state.hub, 0, 0, 0) : { p: [0, 0, 0], R: kUnit },
      displacements: decode(state.displacements, Float32Array),
      rotations: decode(state.rotations, Float32Array),
      solids: state.solids.map((numbers) => decode(numbers, Float32Array)),
      modes: (state.modes ?? []).map((mode) => ({
        ...mode,
        shape: decode(mode.shape, Int16Array),
        solids: mode.solids.map(({ unit, shares }) => ({ unit, shares: decode(shares, Int16Array) })),
      })),
    }));
    this.bounds = this.findBounds();
  }
  /** Poses of groups: of a rotor in the frame of its hub, whose group is the first, of a support in that in
   *  which it stands. */
  decodeGroups(numbers) {
    return Array.from({ length: this.scene.groups }, (_, g) =>
      g === 0 ? { p: [0, 0, 0], R: kUnit } : poseBetween(numbers, 7 * (g - 1), 7 * (g - 1), 0));
  }
  /** The same where the hub is at `place`: a model on a support is drawn in the frame that this stands in, others
   *  in that of the hub. */
  placeGroups(groups, { p, R }) {
    const rotor = this.scene.base?.group ?? 0;
    return groups.map((own, g) => (g >= rotor ? own : { p: add(p, turn(R, own.p)), R: product(R, own.R) }));
  }
  /** Of where the model stands at the first and at the last speed. */
  findBounds() {
    const both = [this.at(0), this.at(this.states.length - 1)].map((state) => boundsOfState(this.scene, state));
    return both[0].radius > both[1].radius ? both[0] : both[1];
  }

  /** Where the model stands at speed `k`. */
  at(k) {
    const { place, displacements, rotations, solids } = this.states[k];
    const groups = this.placeGroups(this.states[k].groups, place);
    return { hub: { p: [0, 0, 0], R: kUnit }, groups, displacements, rotations, solids: this.scene.solidsOf(solids) };
  }
  /** That, moved along a mode: by `amplitude` times the real part of shape times exp(i phase). */
  moved(k, mode, amplitude, phase) {
    const still = this.at(k);
    const [displacements, rotations] = [Float64Array.from(still.displacements), Float64Array.from(still.rotations)];
    const [c, s] = [amplitude * Math.cos(phase), amplitude * Math.sin(phase)];
    const { shape, units, first } = mode;
    for (let at = 0; at < shape.length; at += kShapeNumbers) {
      const node = 3 * (first + at / kShapeNumbers);
      for (let i = 0; i < 3; ++i) {
        displacements[node + i] += units.displacement * (c * shape[at + i] - s * shape[at + 3 + i]);
        rotations[node + i] += units.rotation * (c * shape[at + 6 + i] - s * shape[at + 9 + i]);
      }
    }
    const carried = Array.from({ length: 6 }, (_, i) => c * mode.hub.real[i] - s * mode.hub.imag[i]);
    const motion = { p: carried.slice(0, 3), R: rotationOf(carried.slice(3)) };
    const solids = this.scene.solidsOf(mode.solids.map((motion, m) => this.moveSolid(this.states[k].solids[m], motion, c, s)));
    const moved = { ...still, displacements, rotations, solids };
    if (!this.scene.base) return { ...moved, hub: motion };
    const { place: { p, R }, groups } = this.states[k];
    const place = { p: add(p, turn(R, motion.p)), R: product(R, motion.R) };
    return { ...moved, groups: this.moveOthers(this.placeGroups(groups, place), mode, c, s) };
  }
  /** Moves the other hubs of a support with what they carry, by the motions that they have in a mode. */
  moveOthers(groups, mode, c, s) {
    const made = [...groups];
    (mode.others ?? []).forEach(({ real, imag }, k) => {
      const { group, groups: carried } = this.scene.base.hubs[k];
      const motion = Array.from({ length: 6 }, (_, i) => c * real[i] - s * imag[i]);
      const [shift, R, { p: center }] = [motion.slice(0, 3), rotationOf(motion.slice(3)), groups[group]];
      for (const g of carried)
        made[g] = {
          p: add(add(center, shift), turn(R, sub(groups[g].p, center))),
          R: product(R, groups[g].R),
        };
    });
    return made;
  }
  /** Numbers of a solid, moved by its motion: real parts of all, then imaginary ones, those of stresses left out. */
  moveSolid(still, { unit, shares }, c, s) {
    if (shares.length === 0) return still;
    const count = shares.length / 2;
    const moved = Float64Array.from({ length: count }, (_, i) => unit * (c * shares[i] - s * shares[count + i]));
    still.subarray(0, count).forEach((value, i) => (moved[i] += value));
    return moved;
  }
  /** The amplitude by which a mode moves a node by `share` of the model's radius, or turns it by `share`
   *  times five, at most: a mode of torsion turns, and hardly moves. */
  amplitudeOf(mode, share) {
    const moves = Math.max(mode.largest.displacement / this.bounds.radius, mode.largest.rotation / 5);
    return moves > 0 ? share / moves : 0;
  }
}
