// Colours of stages: eight that colour-blind eyes tell apart, then the same eight hatched one way, and the
// other way. Stages are also named in nodes, slices and rows, so that nothing is said by colour alone.
import { inkOn, rgb, Theme } from './theme';

export interface Paint {
  /** For fillStyle; the hatched ones are patterns. */
  fill: string | CanvasPattern;
  plain: string;
  hatched: boolean;
  /** Whether its stripes fall from left to right. */
  falls: boolean;
  ink: string;
}

/** Mixes a colour with another by the given share of the other, as "#rrggbb". */
export function mix(a: string, b: string, share: number): string {
  const [from, to] = [rgb(a), rgb(b)];
  const hex = from.map((c, k) => Math.round(c + (to[k] - c) * share).toString(16).padStart(2, '0'));
  return `#${hex.join('')}`;
}

function hatch(colour: string, paper: string, falls: boolean): CanvasPattern {
  const size = 8 * devicePixelRatio;
  const tile = document.createElement('canvas');
  tile.width = tile.height = size;
  const context = tile.getContext('2d') as CanvasRenderingContext2D;
  context.fillStyle = colour;
  context.fillRect(0, 0, size, size);
  context.strokeStyle = mix(colour, paper, 0.55);
  context.lineWidth = size / 5;
  for (let k = -1; k <= 1; ++k) {
    context.beginPath();
    context.moveTo((k - 0.25) * size, (falls ? -0.25 : 1.25) * size);
    context.lineTo((k + 1.25) * size, (falls ? 1.25 : -0.25) * size);
    context.stroke();
  }
  const pattern = context.createPattern(tile, 'repeat') as CanvasPattern;
  pattern.setTransform(new DOMMatrix().scale(1 / devicePixelRatio));
  return pattern;
}

export class Palette {
  private readonly paints = new Map<string, Paint>();
  private readonly dimmed = new Map<string, string>();

  /** Stages keep the number of their first mention, so that two traces agree on colours. */
  constructor(readonly theme: Theme, private readonly stages: string[]) {}

  stage(name: string): Paint {
    let paint = this.paints.get(name);
    if (!paint) {
      const number = Math.max(0, this.stages.indexOf(name));
      const plain = this.theme.series[number % 8];
      const hatched = number >= 8;
      const falls = number % 24 >= 16;
      const fill = hatched ? hatch(plain, this.theme.paper, falls) : plain;
      paint = { plain, hatched, falls, fill, ink: inkOn(rgb(plain)) };
      this.paints.set(name, paint);
    }
    return paint;
  }

  /** The stage's colour faded into the background. */
  faint(name: string, share = 0.78): string {
    const key = `${name} ${share}`;
    let colour = this.dimmed.get(key);
    if (!colour) {
      colour = mix(this.stage(name).plain, this.theme.paper, share);
      this.dimmed.set(key, colour);
    }
    return colour;
  }

  /** The colour of a share between 0 and 1 of the largest. */
  share(value: number): Paint {
    const stops = this.theme.share;
    const at = Math.min(1, Math.max(0, value)) * (stops.length - 1);
    const k = Math.min(stops.length - 2, Math.floor(at));
    const colour = stops[k].map((c, i) => Math.round(c + (stops[k + 1][i] - c) * (at - k))) as [number, number, number];
    const plain = `rgb(${colour.join(',')})`;
    return { plain, fill: plain, hatched: false, falls: false, ink: inkOn(colour) };
  }
}

/** The same paint for the style sheet. */
export function swatchStyle(palette: Palette, stage: string): string {
  const { plain, hatched, falls } = palette.stage(stage);
  if (!hatched) return `background:${plain}`;
  const stripe = mix(plain, palette.theme.paper, 0.55);
  return `background:repeating-linear-gradient(${falls ? 45 : 135}deg,${plain} 0 3px,${stripe} 3px 5px)`;
}
