// Vectors of three numbers, and rotations as nine numbers row by row.

const kUnit = [1, 0, 0, 0, 1, 0, 0, 0, 1];

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (factor, a) => [factor * a[0], factor * a[1], factor * a[2]];
const size = (a) => Math.hypot(a[0], a[1], a[2]);
const unitOf = (a) => times(1 / (size(a) || 1), a);

/** R v. */
const turn = (R, v) => [
  R[0] * v[0] + R[1] * v[1] + R[2] * v[2],
  R[3] * v[0] + R[4] * v[1] + R[5] * v[2],
  R[6] * v[0] + R[7] * v[1] + R[8] * v[2],
];
/** R^T v. */
const turnBack = (R, v) => [
  R[0] * v[0] + R[3] * v[1] + R[6] * v[2],
  R[1] * v[0] + R[4] * v[1] + R[7] * v[2],
  R[2] * v[0] + R[5] * v[1] + R[8] * v[2],
];
/** R^T. */
const transposed = (R) => [R[0], R[3], R[6], R[1], R[4], R[7], R[2], R[5], R[8]];
/** A B. */
function product(A, B) {
  const C = new Array(9);
  for (let i = 0; i < 3; ++i)
    for (let j = 0; j < 3; ++j)
      C[3 * i + j] = A[3 * i] * B[j] + A[3 * i + 1] * B[3 + j] + A[3 * i + 2] * B[6 + j];
  return C;
}

/** The rotation by a rotation vector. */
function rotationOf(v) {
  const angle = size(v);
  if (angle < 1e-12) return kUnit;
  const [x, y, z] = times(1 / angle, v);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const d = 1 - c;
  return [
    c + d * x * x, d * x * y - s * z, d * x * z + s * y,
    d * x * y + s * z, c + d * y * y, d * y * z - s * x,
    d * x * z - s * y, d * y * z + s * x, c + d * z * z,
  ];
}

/** The rotation of a quaternion (w, x, y, z) of any length. */
function rotationOfQuaternion(q) {
  const n = 1 / (Math.hypot(...q) || 1);
  const [w, x, y, z] = q.map((c) => c * n);
  return [
    1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
    2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
    2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y),
  ];
}

/** Between two poses (x, y, z, w, x, y, z), as {p, R}. */
function poseBetween(numbers, a, b, share) {
  const mix = (k, sign = 1) => numbers[a + k] + share * (sign * numbers[b + k] - numbers[a + k]);
  let product = 0;
  for (let k = 3; k < 7; ++k) product += numbers[a + k] * numbers[b + k];
  const sign = product < 0 ? -1 : 1; // q and -q are one rotation
  return {
    p: [mix(0), mix(1), mix(2)],
    R: rotationOfQuaternion([mix(3, sign), mix(4, sign), mix(5, sign), mix(6, sign)]),
  };
}
