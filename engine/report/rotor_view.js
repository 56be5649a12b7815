// An animated rotor seen from above: frames of the blades' nodes, in between on straight lines, and
// two views of them, in the hub's frame and in the inertial one. Uses time_plots.js.

/** Frames of a rotor. data: {times, hub: x, y, angle by frame, blades: [undeformed x, y by node],
 *  displacements: x, y by frame and node in hub axes, as shares of `unit`}. */
class Animation {
  constructor(data) {
    Object.assign(this, data);
    this.nodes = this.blades.reduce((sum, blade) => sum + blade.length / 2, 0);
    this.now = new Float64Array(2 * this.nodes);
    this.radius = this.blades.flatMap((b) => [...b]).length ? this.findRadius() : 1;
    this.largest = this.findLargest();
  }
  get begin() {
    return this.times[0];
  }
  get end() {
    return this.times[this.times.length - 1];
  }
  findRadius() {
    let radius = 0;
    for (const blade of this.blades)
      for (let k = 0; k < blade.length; k += 2)
        radius = Math.max(radius, Math.hypot(blade[k], blade[k + 1]));
    return radius;
  }
  /** The largest displacement of all [m], and when. */
  findLargest() {
    let square = 0;
    let frame = 0;
    const { displacements: d, nodes } = this;
    for (let k = 0; k < d.length; k += 2) {
      const size = d[k] * d[k] + d[k + 1] * d[k + 1];
      if (size > square) {
        square = size;
        frame = Math.floor(k / (2 * nodes));
      }
    }
    return { size: Math.sqrt(square) * this.unit, time: this.times[frame] };
  }
  /** Where a time stands between two frames. */
  place(time) {
    const after = Math.min(Math.max(1, lowerBound(this.times, time)), this.times.length - 1);
    const before = Math.max(0, after - 1);
    const length = this.times[after] - this.times[before];
    const share = length > 0 ? (time - this.times[before]) / length : 0;
    return { before, after, share: Math.min(Math.max(share, 0), 1) };
  }
  hubAt(time) {
    const { before, after, share } = this.place(time);
    const value = (c) =>
      this.hub[3 * before + c] + share * (this.hub[3 * after + c] - this.hub[3 * before + c]);
    return { x: value(0), y: value(1), angle: value(2) };
  }
  /** Displacements of all nodes [m] in hub axes; valid until the next call. */
  displacementsAt(time) {
    const { before, after, share } = this.place(time);
    const size = 2 * this.nodes;
    const [a, b] = [before * size, after * size];
    const d = this.displacements;
    for (let k = 0; k < size; ++k)
      this.now[k] = this.unit * (d[a + k] + share * (d[b + k] - d[a + k]));
    return this.now;
  }
  /** How far the hub travels: the box of its places. */
  travel() {
    const box = { x: [Infinity, -Infinity], y: [Infinity, -Infinity] };
    for (let k = 0; k < this.hub.length; k += 3)
      ['x', 'y'].forEach((c, i) => {
        box[c][0] = Math.min(box[c][0], this.hub[k + i]);
        box[c][1] = Math.max(box[c][1], this.hub[k + i]);
      });
    return box;
  }
}

class RotorView {
  /** settings: {scale, outline, trails}, shared by the views. */
  constructor(canvas, animation, settings, isInertial) {
    Object.assign(this, { canvas, animation, settings, isInertial });
    const box = animation.travel();
    this.travelSize = Math.max(box.x[1] - box.x[0], box.y[1] - box.y[0]);
    this.centre = { x: 0.5 * (box.x[0] + box.x[1]), y: 0.5 * (box.y[0] + box.y[1]) };
    // A hub that goes far takes the view with it.
    this.follows = isInertial && this.travelSize > 2 * animation.radius;
    this.time = animation.begin;
    new ResizeObserver(() => this.draw(this.time)).observe(canvas);
  }

  /** Half the width of what is shown [m]. */
  extent() {
    const { animation, settings } = this;
    const deformed = animation.radius + 0.35 * settings.scale * animation.largest.size;
    const reach = Math.min(deformed, 1.6 * animation.radius);
    const travel = this.isInertial && !this.follows ? 0.5 * this.travelSize : 0;
    return 1.1 * (reach + travel);
  }

  draw(time) {
    this.time = time;
    const { context, width, height } = prepareCanvas(this.canvas);
    const pixels = Math.min(width, height) / (2 * this.extent());
    const hub = this.isInertial ? this.animation.hubAt(time) : { x: 0, y: 0, angle: 0 };
    let centre = { x: 0, y: 0 };
    if (this.isInertial) centre = this.follows ? hub : this.centre;
    const at = (x, y) => [width / 2 + (x - centre.x) * pixels, height / 2 - (y - centre.y) * pixels];
    this.frame = { context, width, height, pixels, hub, centre, at };
    this.drawGround();
    if (this.isInertial && this.settings.trails) this.drawTrails();
    const displacements = this.animation.displacementsAt(time);
    if (this.settings.outline) this.drawBlades(displacements, 0, 'outline');
    this.drawBlades(displacements, this.settings.scale, 'blade');
    this.drawHub();
    this.drawRuler();
  }

  /** Rings around the hub, or squares that stand still. */
  drawGround() {
    const { context, width, height, pixels, centre, at } = this.frame;
    context.strokeStyle = colorOf('--rule');
    context.lineWidth = 1;
    context.beginPath();
    const step = roundTicks(0, this.extent(), 4).step;
    if (this.isInertial) {
      const [columns, rows] = [width / 2 / pixels, height / 2 / pixels];
      for (const x of roundTicks(centre.x - columns, centre.x + columns, (2 * columns) / step).ticks) {
        const [px] = at(x, 0);
        context.moveTo(Math.round(px) + 0.5, 0);
        context.lineTo(Math.round(px) + 0.5, height);
      }
      for (const y of roundTicks(centre.y - rows, centre.y + rows, (2 * rows) / step).ticks) {
        const [, py] = at(0, y);
        context.moveTo(0, Math.round(py) + 0.5);
        context.lineTo(width, Math.round(py) + 0.5);
      }
    } else {
      const [x, y] = at(0, 0);
      for (let r = step; r * pixels < Math.hypot(width, height) / 2; r += step) {
        context.moveTo(x + r * pixels, y);
        context.arc(x, y, r * pixels, 0, 2 * Math.PI);
      }
    }
    context.stroke();
  }

  /** Where the tips have been in the last tenth of the animation. */
  drawTrails() {
    const { animation, settings, frame } = this;
    const { context } = frame;
    const span = 0.1 * (animation.end - animation.begin);
    const kPieces = 60;
    let first = 0;
    animation.blades.forEach((blade, index) => {
      const tip = blade.length / 2 - 1;
      context.strokeStyle = seriesColor(index);
      context.lineWidth = 1.5;
      let last = null;
      for (let k = 0; k <= kPieces; ++k) {
        const time = this.time - span * (1 - k / kPieces);
        if (time < animation.begin) continue;
        const d = animation.displacementsAt(time);
        const point = this.place(animation.hubAt(time), blade, first, tip, d, settings.scale);
        if (last) {
          context.globalAlpha = 0.45 * (k / kPieces) ** 1.5;
          context.beginPath();
          context.moveTo(...last);
          context.lineTo(...point);
          context.stroke();
        }
        last = point;
      }
      first += tip + 1;
    });
    context.globalAlpha = 1;
  }

  /** A node on the screen. first: the blade's first node among all; k: the node in the blade. */
  place(hub, blade, first, k, displacements, scale) {
    const x = blade[2 * k] + scale * displacements[2 * (first + k)];
    const y = blade[2 * k + 1] + scale * displacements[2 * (first + k) + 1];
    const [cosine, sine] = [Math.cos(hub.angle), Math.sin(hub.angle)];
    return this.frame.at(hub.x + cosine * x - sine * y, hub.y + sine * x + cosine * y);
  }

  drawBlades(displacements, scale, kind) {
    const { context, hub } = this.frame;
    let first = 0;
    this.animation.blades.forEach((blade, index) => {
      const count = blade.length / 2;
      const isOutline = kind === 'outline';
      context.strokeStyle = isOutline ? colorOf('--soft') : seriesColor(index);
      context.lineWidth = isOutline ? 1.25 : 3.5;
      context.setLineDash(isOutline ? [5, 5] : []);
      context.lineCap = context.lineJoin = 'round';
      context.beginPath();
      const points = [];
      for (let k = 0; k < count; ++k)
        points.push(this.place(hub, blade, first, k, displacements, scale));
      points.forEach((point) => context.lineTo(...point));
      context.stroke();
      context.setLineDash([]);
      if (!isOutline) this.drawJoints(points, index);
      first += count;
    });
  }

  /** Dots where two bodies meet, and at the tip. */
  drawJoints(points, index) {
    const { context } = this.frame;
    const every = this.animation.joints[index];
    context.fillStyle = colorOf('--paper');
    context.lineWidth = 1.75;
    for (let k = every; every > 0 && k < points.length; k += every) {
      context.beginPath();
      context.arc(...points[k], 3, 0, 2 * Math.PI);
      context.fill();
      context.stroke();
    }
  }

  /** The hub, with a stroke that shows how it is turned. */
  drawHub() {
    const { context, hub, pixels, at } = this.frame;
    const radius = Math.max(7, this.animation.hubRadius * pixels);
    const [x, y] = at(hub.x, hub.y);
    context.fillStyle = colorOf('--panel');
    context.strokeStyle = colorOf('--ink');
    context.lineWidth = 2;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x + radius * Math.cos(hub.angle), y - radius * Math.sin(hub.angle));
    context.stroke();
  }

  drawRuler() {
    const { context, height, pixels } = this.frame;
    const { step } = roundTicks(0, this.extent(), 4);
    const y = height - 16;
    context.strokeStyle = context.fillStyle = colorOf('--soft');
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(14, y - 4);
    context.lineTo(14, y + 4);
    context.moveTo(14, y);
    context.lineTo(14 + step * pixels, y);
    context.moveTo(14 + step * pixels, y - 4);
    context.lineTo(14 + step * pixels, y + 4);
    context.stroke();
    context.font = '12px system-ui, sans-serif';
    context.textAlign = 'left';
    context.textBaseline = 'middle';
    context.fillText(`${numberText(step)} m`, 22 + step * pixels, y);
  }
}
