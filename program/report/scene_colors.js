// Colours of a scene by what its bodies bear, and their legends. Uses page_tools.js, space_math.js and
// scene.js.

const kViridis = [[72, 33, 115], [49, 104, 142], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/** What colours may show. */
const kColorings = {
  axial: {
    text: 'Axial force, tension positive', unit: 'N', isSigned: true,
    scale: [[49, 104, 184], [150, 184, 224], [200, 200, 200], [240, 160, 120], [196, 50, 40]],
  },
  bending: { text: 'Bending moment', unit: 'N m', scale: kViridis },
  displacement: { text: 'Displacement', unit: 'm', scale: kViridis },
  von_mises: { text: 'Von Mises stress', unit: 'MPa', factor: 1e-6, scale: kViridis },
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
  const { text, unit, factor = 1, isSigned, scale } = kColorings[kind];
  const stops = scale.map((rgb) => `rgb(${rgb.map(Math.round).join(' ')})`).join(', ');
  const bar = make('span', { className: 'bar' });
  bar.style.background = `linear-gradient(to right, ${stops})`;
  const value = (share) => `${numberText(factor * share * most)} ${unit}`;
  host.replaceChildren(`${text}: ${value(isSigned ? -1 : 0)}`, bar, value(1));
}

/** Colours of elements of beams and of nodes of solids at a state. */
class SceneColors {
  /** kind: of kColorings, or "tree"; most: its largest value ever. */
  constructor(scene, state, kind, most) {
    Object.assign(this, { scene, state, kind, most });
  }
  /** The share of the scale that shows a value. */
  shareOf(value) {
    const share = this.most > 0 ? value / this.most : 0;
    return Math.min(Math.max(kColorings[this.kind].isSigned ? 0.5 + 0.5 * share : share, 0), 1);
  }
  of(value) {
    return colorAt(kColorings[this.kind].scale, this.shareOf(value));
  }
  get plain() {
    return rgbOf(colorOf('--soft'));
  }
  /** The colour of an element of a strip by its number, whose inner node is `node`; null: that of its tree. */
  ofElement(element, node) {
    const { kind, state } = this;
    if (kind === 'tree') return null;
    if (kind === 'von_mises') return this.plain;
    if (kind !== 'displacement') {
      this.forces ??= state.forces(kind);
      return this.of(this.forces[element]);
    }
    const u = (k) => size(state.displacements.subarray(3 * k, 3 * k + 3));
    return this.of(0.5 * (u(node) + u(node + 1)));
  }
  /** What a solid shows: shares of a scale by node, or one colour; null: that of its tree. */
  ofMesh(m) {
    const { kind, state, scene } = this;
    if (kind === 'tree') return null;
    const values = kind === 'displacement' ? meshDisplacements(scene, state, m) : kind === 'von_mises' ? state.solids[m]?.vonMises() : null;
    if (!values) return { plain: this.plain };
    return { shares: values.map((value) => this.shareOf(value)), scale: kColorings[kind].scale };
  }
}

/** How far the nodes of a solid are from where they are with all bodies undeformed [m]. */
function meshDisplacements(scene, state, m) {
  const { surface } = scene.meshes[m];
  const [still, moved] = [0, 1].map((scale) => new Deformed(scene, state, scale).meshPlaces(m));
  return Float64Array.from({ length: scene.surfaces[surface].nodeCount }, (_, k) =>
    size(sub(moved.subarray(3 * k, 3 * k + 3), still.subarray(3 * k, 3 * k + 3))));
}
