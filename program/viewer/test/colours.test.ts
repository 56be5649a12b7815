// The colours of stages differ for eyes that lack one kind of cone, by the simulation of Machado,
// Oliveira and Fernandes (2009) and the CIE 1976 difference of colours; text on them can be read.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import styles from '../src/styles.css';
import { inkOn, rgb } from '../src/theme';

const kEyes: Record<string, number[][]> = {
  ordinary: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
const kToXyz = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]];
const kWhite = [0.9505, 1, 1.089];
const kLeastDifference = 12;

const times = (matrix: number[][], v: number[]) => matrix.map((row) => row.reduce((sum, m, k) => sum + m * v[k], 0));

function linear(hex: string): number[] {
  return rgb(hex).map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
}

function lab(colour: number[]): number[] {
  const inside = colour.map((c) => Math.min(1, Math.max(0, c)));
  const [x, y, z] = times(kToXyz, inside).map((value, k) => {
    const share = value / kWhite[k];
    return share > 0.008856 ? Math.cbrt(share) : 7.787 * share + 16 / 116;
  });
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

/** The eight colours of a scheme: the first or the second time that the style sheet names them. */
function series(scheme: number): string[] {
  return Array.from({ length: 8 }, (_, k) => {
    const found = [...styles.matchAll(new RegExp(`--s${k}: (#[0-9a-f]{6})`, 'g'))];
    assert.equal(found.length, 2);
    return found[scheme][1];
  });
}

for (const [scheme, name] of ['light', 'dark'].entries()) {
  for (const [eyes, matrix] of Object.entries(kEyes)) {
    test(`colours differ: ${name}, ${eyes}`, () => {
      const seen = series(scheme).map((hex) => lab(times(matrix, linear(hex))));
      seen.forEach((a, i) => seen.slice(0, i).forEach((b, j) => {
        const difference = Math.hypot(...a.map((value, k) => value - b[k]));
        assert.ok(difference > kLeastDifference, `s${j} and s${i} differ by ${difference.toFixed(1)}`);
      }));
    });
  }
  test(`text on colours has a contrast of 4.2 or more: ${name}`, () => {
    const luminance = (hex: string) => times(kToXyz, linear(hex))[1];
    for (const hex of series(scheme)) {
      const [a, b] = [luminance(hex), luminance(inkOn(rgb(hex)))].sort((x, y) => y - x);
      assert.ok((a + 0.05) / (b + 0.05) >= 4.2, `${hex}: ${((a + 0.05) / (b + 0.05)).toFixed(2)}`);
    }
  });
}
