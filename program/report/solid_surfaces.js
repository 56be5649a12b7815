// Surfaces of solids: the drawn nodes of a mesh, and how coordinates of the solid displace and stress
// them. Uses page_tools.js and space_math.js.

/** Rows of a map from coordinates, columns of which are shares of units. */
class RowMap {
  constructor({ units, shares }) {
    this.units = decode(units, Float32Array);
    this.shares = decode(shares, Int16Array);
    this.rows = this.units.length > 0 ? this.shares.length / this.units.length : 0;
  }
  times(q) {
    const { units, shares, rows } = this;
    const scaled = Float64Array.from(units, (unit, c) => unit * q[c]);
    const made = new Float64Array(rows);
    for (let row = 0, at = 0; row < rows; ++row) {
      let sum = 0;
      for (let c = 0; c < scaled.length; ++c) sum += shares[at++] * scaled[c];
      made[row] = sum;
    }
    return made;
  }
}

/** By node, from stresses (xx, yy, zz, yz, xz, xy). */
function vonMisesOf(s) {
  const made = new Float64Array(s.length / 6);
  for (let k = 0, at = 0; k < made.length; ++k, at += 6) {
    const [a, b, c] = [s[at] - s[at + 1], s[at + 1] - s[at + 2], s[at + 2] - s[at]];
    const shear = s[at + 3] ** 2 + s[at + 4] ** 2 + s[at + 5] ** 2;
    made[k] = Math.sqrt(0.5 * (a * a + b * b + c * c) + 3 * shear);
  }
  return made;
}

class SolidSurface {
  /** data: as program/run_report/scene_data.cpp writes it. */
  constructor({ places, triangles, edges, shapes, stresses, hasStress }) {
    this.places = decode(places, Float32Array);
    this.triangles = decode(triangles, Int16Array);
    this.edges = decode(edges, Int16Array);
    this.shapes = shapes ? new RowMap(shapes) : null;
    this.stresses = stresses ? new RowMap(stresses) : null;
    this.nodeCount = this.places.length / 3;
    this.hasStress = Boolean(hasStress);
    this.middle = this.findMiddle();
    this.findSides();
  }
  /** The place of the node next to the mean of all. */
  findMiddle() {
    const at = (k) => this.places.subarray(3 * k, 3 * k + 3);
    const nodes = Array.from({ length: this.nodeCount }, (_, k) => k);
    const mean = times(1 / (this.nodeCount || 1), nodes.reduce((sum, k) => add(sum, at(k)), [0, 0, 0]));
    const off = nodes.map((k) => size(sub(at(k), mean)));
    const nearest = nodes.reduce((best, k) => (off[k] < off[best] ? k : best), 0);
    return this.nodeCount > 0 ? [...at(nearest)] : mean;
  }
  /** Triangles on both sides of each edge. */
  findSides() {
    const keyOf = (a, b) => Math.min(a, b) * this.nodeCount + Math.max(a, b);
    const sides = new Map();
    for (let k = 0; k < this.edges.length; k += 2) sides.set(keyOf(this.edges[k], this.edges[k + 1]), []);
    for (let t = 0; t < this.triangles.length; t += 3)
      for (let i = 0; i < 3; ++i)
        sides.get(keyOf(this.triangles[t + i], this.triangles[t + ((i + 1) % 3)]))?.push(t / 3);
    this.sides = [...sides.values()];
  }

  /** Numbers of a frame: modal coordinates, or displacements and then stresses by node. */
  get frameSize() {
    return this.shapes ? this.shapes.units.length : 4 * this.nodeCount;
  }
  /** At the numbers of a frame; none: at rest. */
  stateOf(numbers) {
    const { shapes, stresses, nodeCount, hasStress } = this;
    if (numbers.length === 0) return { u: new Float64Array(3 * nodeCount), vonMises: () => null };
    if (!shapes)
      return {
        u: numbers.subarray(0, 3 * nodeCount),
        vonMises: () => (hasStress && numbers.length > 3 * nodeCount ? numbers.subarray(3 * nodeCount) : null),
      };
    return { u: shapes.times(numbers), vonMises: () => (stresses ? vonMisesOf(stresses.times(numbers)) : null) };
  }
}
