// Two canvases on top of each other: one that seldom changes, and one that follows the pointer.
import { oncePerFrame } from './dom';

export abstract class Layers {
  protected width = 0;
  protected height = 0;
  readonly canvas: HTMLCanvasElement;
  private readonly base: HTMLCanvasElement;
  private baseStale = true;
  private readonly frame = oncePerFrame(() => this.draw());
  /** How long the last frame took to draw, ms; for tests. */
  lastFrame = 0;

  /** The upper canvas gets the keys and the pointer. */
  constructor(readonly host: HTMLElement, label: string, keys: string) {
    this.base = document.createElement('canvas');
    this.base.setAttribute('aria-hidden', 'true');
    this.canvas = document.createElement('canvas');
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'application');
    this.canvas.setAttribute('aria-label', label);
    this.canvas.setAttribute('aria-description', keys);
    host.append(this.base, this.canvas);
    new ResizeObserver(() => this.resize()).observe(host);  // calls back once at the start, too
  }

  protected abstract drawBase(context: CanvasRenderingContext2D): void;
  protected abstract drawOverlay(context: CanvasRenderingContext2D): void;
  protected resized(): void {}

  redraw(): void {
    this.baseStale = true;
    this.frame();
  }

  redrawOverlay(): void {
    this.frame();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.width = clientWidth;
    this.height = clientHeight;
    for (const canvas of [this.base, this.canvas]) {
      canvas.width = Math.round(clientWidth * devicePixelRatio);
      canvas.height = Math.round(clientHeight * devicePixelRatio);
    }
    this.resized();
    this.baseStale = true;
    this.draw();
  }

  private draw(): void {
    if (this.width === 0) return;
    const start = performance.now();
    if (this.baseStale) this.drawOn(this.base, (context) => this.drawBase(context));
    this.baseStale = false;
    this.drawOn(this.canvas, (context) => this.drawOverlay(context));
    this.lastFrame = performance.now() - start;
  }

  private drawOn(canvas: HTMLCanvasElement, draw: (context: CanvasRenderingContext2D) => void): void {
    const context = canvas.getContext('2d') as CanvasRenderingContext2D;
    context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    context.clearRect(0, 0, this.width, this.height);
    context.save();
    draw(context);
    context.restore();
  }
}

/** Calls back with the distance dragged, and with the place of a click that was no drag. */
export function onDrag(
  canvas: HTMLCanvasElement, moved: (dx: number, dy: number) => void, clicked: (x: number, y: number) => void,
): void {
  let last: { x: number; y: number } | null = null;
  let travelled = 0;
  canvas.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    last = { x: event.offsetX, y: event.offsetY };
    travelled = 0;
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!last) return;
    const [dx, dy] = [event.offsetX - last.x, event.offsetY - last.y];
    travelled += Math.abs(dx) + Math.abs(dy);
    last = { x: event.offsetX, y: event.offsetY };
    if (travelled > 4) {
      canvas.classList.add('dragged');
      moved(dx, dy);
    }
  });
  const end = () => {
    last = null;
    canvas.classList.remove('dragged');
  };
  canvas.addEventListener('pointerup', (event) => {
    if (last && travelled <= 4) clicked(event.offsetX, event.offsetY);
    end();
  });
  canvas.addEventListener('pointercancel', end);
}

const kMeasured = 100;
const widths = new Map<string, number>();
let measure: CanvasRenderingContext2D | null = null;

/** The width of a text in a bold font of one pixel. */
export function widthOf(text: string): number {
  let width = widths.get(text);
  if (width === undefined) {
    if (!measure) {
      measure = document.createElement('canvas').getContext('2d') as CanvasRenderingContext2D;
      measure.font = `600 ${kMeasured}px ${getComputedStyle(document.body).fontFamily}`;
    }
    width = measure.measureText(text).width / kMeasured;
    widths.set(text, width);
  }
  return width;
}

/** The first of some texts that fits a width in a font of `size` pixels; '' if none does. */
export function fitting(candidates: string[], width: number, size: number): string {
  return candidates.find((text) => widthOf(text) * size <= width) ?? '';
}

export function arrowHead(context: CanvasRenderingContext2D, x: number, y: number, angle: number, size: number): void {
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x - size * Math.cos(angle - 0.45), y - size * Math.sin(angle - 0.45));
  context.lineTo(x - size * Math.cos(angle + 0.45), y - size * Math.sin(angle + 0.45));
  context.closePath();
  context.fill();
}
