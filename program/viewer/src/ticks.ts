// Marks of an axis.

/** The distance of marks: 1, 2 or 5 times a power of ten, so that they are `least` pixels apart. */
export function tickStep(perPixel: number, least: number): number {
  const wanted = perPixel * least;
  const power = 10 ** Math.floor(Math.log10(wanted));
  return [1, 2, 5, 10].map((k) => k * power).find((step) => step >= wanted) ?? wanted;
}
