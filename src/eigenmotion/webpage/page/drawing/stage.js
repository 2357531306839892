// stage.js: stage for drawings on a plain canvas; in space, nearer strokes cover those behind.

const TURN_A_PIXEL = 0.008;

class Stage {
  constructor(canvas, about, brush) {
    Object.assign(this, { canvas, about, brush });
    this.view = { zoom: 1, pan: [0, 0], yaw: -0.9, pitch: 0.45 };
    this.touched = false;
    gestures(canvas, {
      drag: (dx, dy, shifted) => this.dragged(dx, dy, shifted),
      zoom: (factor, x, y) => this.zoomed(factor, x, y),
    });
  }

  // Whether the view is the user's; then a button beside the canvas resets it.
  get touched() { return this.canvas.classList.contains("touched"); }
  set touched(yes) { this.canvas.classList.toggle("touched", yes); }

  get space() { return this.about.dimension === 3; }

  dragged(dx, dy, shifted) {
    if (this.space && !shifted) {
      this.view.yaw -= dx * TURN_A_PIXEL;
      this.view.pitch = Math.max(-1.5, Math.min(1.5, this.view.pitch + dy * TURN_A_PIXEL));
    } else {
      this.view.pan = [this.view.pan[0] + dx, this.view.pan[1] + dy];
    }
    this.touched = true;
    this.draw();
  }

  zoomed(factor, x, y) {
    const { pan } = this.view, [cx, cy] = [this.canvas.clientWidth / 2, this.canvas.clientHeight / 2];
    this.view.zoom *= factor;
    this.view.pan = [x - cx - (x - cx - pan[0]) * factor, y - cy - (y - cy - pan[1]) * factor];
    this.touched = true;
    this.draw();
  }

  reset() {
    Object.assign(this.view, { zoom: 1, pan: [0, 0], yaw: -0.9, pitch: 0.45 });
    this.touched = false;
    this.fit(this.motion);
    this.draw();
  }

  fit(motion) {
    if (this.box && this.touched) return;
    this.box = motion.box();
    this.framed = null;
  }

  show(motion, t) {
    if (motion !== this.motion) this.fit(motion);
    Object.assign(this, { motion, t });
    this.draw();
  }

  // Screen axes: right, up, towards the eye.
  axes() {
    if (!this.space) return [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    const { yaw, pitch } = this.view;
    const right = [-Math.sin(yaw), Math.cos(yaw), 0];
    const eye = [Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch)];
    return [right, cross(eye, right), eye];
  }

  get middle() { return this.frame().middle; }

  // The middle and the size of the motion as seen from here; kept until the view turns.
  frame() {
    const { yaw, pitch } = this.view;
    if (this.framed?.yaw === yaw && this.framed?.pitch === pitch) return this.framed;
    const [right, up] = this.axes(), { low, high, points } = this.box;
    const centre = mix(low, high, 0.5);
    const ends = (axis, k) => {
      if (!points.length) return [low[k] - centre[k], high[k] - centre[k]];
      let [least, most] = [Infinity, -Infinity];
      for (const { at, room } of points) {
        const place = dot(minus(at, centre), axis);
        [least, most] = [Math.min(least, place - room), Math.max(most, place + room)];
      }
      return [least, most];
    };
    const [left, rightmost] = ends(right, 0), [bottom, top] = ends(up, 1);
    const middle = plus(plus(centre, right, (left + rightmost) / 2), up, (bottom + top) / 2);
    this.framed = { yaw, pitch, middle, across: rightmost - left, upwards: top - bottom };
    return this.framed;
  }

  camera() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const [right, up, eye] = this.axes(), { across, upwards } = this.frame();
    const scale = this.view.zoom * 0.9 * Math.min(width / (across || 1e-9), height / (upwards || 1e-9), 1e9);
    const [x0, y0] = [width / 2 + this.view.pan[0], height / 2 + this.view.pan[1]];
    return {
      scale,
      screen: (p) => { const q = minus(p, this.middle); return [x0 + scale * dot(q, right), y0 - scale * dot(q, up)]; },
      depth: (p) => dot(p, eye),
      light: (normal) => Math.abs(dot(normal, unit(plus(plus(eye, up, 0.6), right, 0.4)))),
    };
  }

  draw() {
    if (!this.motion?.rows || !this.canvas.clientWidth) return;
    sharpen(this.canvas, this.brush);
    const camera = this.camera(), look = theme();
    const allStrokes = strokes(this.about, this.motion.drawn(this.t), this.box.size).flatMap(faceByFace);
    allStrokes.push(...this.paths());
    const depth = (stroke) => stroke.points.reduce((sum, p) => sum + camera.depth(p), 0) / stroke.points.length;
    if (this.space) {
      for (const stroke of allStrokes) stroke.depth = stroke.kind === "floor" ? -Infinity : depth(stroke);
      allStrokes.sort((a, b) => a.depth - b.depth);
    } else {
      allStrokes.sort((a, b) => LAYERS.indexOf(a.kind) - LAYERS.indexOf(b.kind));
    }
    for (const stroke of allStrokes) this.stroke(stroke, camera, look);
  }

  paths() {
    const [row] = this.motion.where(this.t), { dimension, shapes } = this.about;
    return shapes.filter((shape) => shape.kind === "trace").map((shape) => {
      const first = this.motion.places.drawn + shape.first;
      const point = (k) => [0, 1, 2].map((axis) => (axis < dimension ? this.motion.at(k, first + axis) : 0));
      const points = Array.from({ length: row + 1 }, (_, k) => point(k));
      const now = this.motion.drawn(this.t).slice(shape.first, shape.first + dimension);
      return { kind: "path", points: [...points, [now[0], now[1], now[2] ?? 0]] };
    });
  }

  stroke({ kind, points, radius }, camera, look) {
    const brush = this.brush, places = points.map(camera.screen);
    if (!places.every((place) => place.every(Number.isFinite))) return;
    brush.lineCap = brush.lineJoin = "round";
    brush.beginPath();
    if (kind === "ball") brush.arc(...places[0], Math.max(1, camera.scale * Math.abs(radius)), 0, 2 * Math.PI);
    else places.forEach((place, k) => (k ? brush.lineTo(...place) : brush.moveTo(...place)));
    if (FILLED.has(kind)) {
      brush.closePath();
      brush.globalAlpha = kind === "wheel" && this.space ? 0.55 : 1;
      brush.fillStyle = kind === "face" && this.space ? this.shaded(points, camera, look) : look[kind];
      brush.fill();
      brush.globalAlpha = 1;
    }
    brush.strokeStyle = look[`${kind}Edge`] ?? look[kind];
    brush.lineWidth = WIDTHS[kind];
    brush.stroke();
  }

  shaded(points, camera, look) {
    const normal = unit(cross(minus(points[1], points[0]), minus(points[2], points[0])));
    return `color-mix(in srgb, ${look.face} ${Math.round(45 + 55 * camera.light(normal))}%, ${look.faceEdge})`;
  }
}

const faceByFace = (stroke) => (stroke.kind !== "solid" ? [stroke]
  : stroke.faces.map((face) => ({ kind: "face", points: face.map((k) => stroke.points[k]) })));

const LAYERS = ["floor", "face", "path", "wheel", "line", "bar", "ball"];
const FILLED = new Set(["floor", "face", "wheel", "ball"]);
const WIDTHS = { floor: 1, face: 1, path: 1.5, wheel: 1.5, line: 1.5, bar: 5, ball: 1.5 };

// Set the resolution of the canvas to that of the screen, and clear it.
function sharpen(canvas, brush) {
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  brush.setTransform(ratio, 0, 0, ratio, 0, 0);
  brush.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
}
