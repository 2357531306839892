// space.js: stage for drawings in space by three.js, if the page contains it and the browser has WebGL.

async function openThree() {
  const url = (source) => URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
  const core = url(await unpackedText("three-core"));
  return import(url((await unpackedText("three-module")).replaceAll("./three.core.min.js", core)));
}

class SpaceStage extends Stage {
  constructor(canvas, about, three) {
    super(canvas, about, null);
    this.three = three;
    this.renderer = new three.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.eye = new three.OrthographicCamera();
    this.eye.up.set(0, 0, 1);
  }

  // Create the scene, which is kept from frame to frame until the colours change.
  createScene() {
    const { three } = this;
    this.look = theme();
    this.scene = new three.Scene();
    this.scene.add(new three.HemisphereLight(0xffffff, 0xcccccc, 2.6));
    this.lamp = new three.DirectionalLight(0xffffff, 1.6);
    this.scene.add(this.lamp);
    this.meshes = [];
  }

  draw() {
    const { canvas, motion } = this;
    if (!motion?.rows || !canvas.clientWidth) return;
    if (this.look !== theme()) this.createScene();
    const allStrokes = [...strokes(this.about, motion.drawn(this.t), this.box.size), ...this.paths()];
    allStrokes.forEach((stroke, k) => {
      this.meshes[k] ??= this.createMesh(stroke);
      this.meshes[k].visible = stroke.points.every((p) => p.every(Number.isFinite));
      if (this.meshes[k].visible) this.meshes[k].place(stroke);
    });
    this.aim();
    this.renderer.setPixelRatio(window.devicePixelRatio || 1);
    this.renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
    this.renderer.render(this.scene, this.eye);
  }

  aim() {
    const { clientWidth: width, clientHeight: height } = this.canvas, { eye, box } = this;
    const [right, up, towards] = this.axes(), { scale } = this.camera(), [panX, panY] = this.view.pan;
    Object.assign(eye, { left: (-width / 2 - panX) / scale, right: (width / 2 - panX) / scale,
      top: (height / 2 + panY) / scale, bottom: (-height / 2 + panY) / scale, near: 0, far: 20 * box.size });
    eye.position.set(...plus(this.middle, towards, 10 * box.size));
    eye.lookAt(...this.middle);
    eye.updateProjectionMatrix();
    this.lamp.position.set(...plus(plus(plus(this.middle, towards, 5), up, 6), right, 4));
    this.lamp.target.position.set(...this.middle);
    this.lamp.target.updateMatrixWorld();
  }

  createMesh(stroke) {
    const mesh = MESHES[stroke.kind](this, stroke);
    this.scene.add(mesh);
    return mesh;
  }

  material(name, more = {}) {
    return new this.three.MeshLambertMaterial({ color: this.look[name], side: this.three.DoubleSide, ...more });
  }

  // A rod between two points.
  rod(radius, colour) {
    const { three } = this, rod = new three.Mesh(new three.CylinderGeometry(radius, radius, 1, 16), this.material(colour));
    const from = new three.Vector3(0, 1, 0), to = new three.Vector3();
    rod.place = ({ points: [p, q] }) => {
      const along = minus(q, p), length = Math.hypot(...along);
      rod.position.set(...mix(p, q, 0.5));
      rod.scale.set(1, length || 1e-9, 1);
      if (length) rod.quaternion.setFromUnitVectors(from, to.set(...unit(along)));
    };
    return rod;
  }

  // A wire through many points.
  wire(radius, colour) {
    const { three } = this, wire = new three.Mesh(new three.BufferGeometry(), this.material(colour));
    wire.place = ({ points }) => {
      wire.geometry.dispose();
      const curve = new three.CatmullRomCurve3(points.map((p) => new three.Vector3(...p)));
      wire.geometry = new three.TubeGeometry(curve, points.length, radius, 6);
    };
    return wire;
  }

  curve(colour) {
    const { three } = this, curve = new three.Line(new three.BufferGeometry(), new three.LineBasicMaterial({ color: this.look[colour] }));
    curve.frustumCulled = false;
    curve.place = ({ points }) => {
      curve.geometry.dispose();
      curve.geometry = new three.BufferGeometry().setFromPoints(points.map((p) => new three.Vector3(...p)));
    };
    return curve;
  }

  // A flat polygon with its edge.
  plane(count, colour, edge, more) {
    const { three } = this, group = new three.Group();
    const geometry = new three.BufferGeometry(), places = new Float32Array(3 * count);
    geometry.setAttribute("position", new three.BufferAttribute(places, 3));
    geometry.setIndex(Array.from({ length: count - 2 }, (_, k) => [0, k + 1, k + 2]).flat());
    const material = this.material(colour, { flatShading: true, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1, ...more });
    const ring = new three.LineLoop(geometry, new three.LineBasicMaterial({ color: this.look[edge] }));
    ring.geometry = geometry.clone().setIndex(null);
    ring.geometry.setAttribute("position", geometry.getAttribute("position"));
    group.add(new three.Mesh(geometry, material), ring);
    group.children.forEach((child) => { child.frustumCulled = false; });
    group.place = ({ points }) => { places.set(points.flat()); geometry.getAttribute("position").needsUpdate = true; };
    return group;
  }

  // A solid, created in its frame; edges between faces that meet at a small angle are not drawn.
  solid({ corners, faces }) {
    const { three } = this, group = new three.Group(), geometry = new three.BufferGeometry();
    const triangles = faces.flatMap((face) => face.slice(2).flatMap((_, k) => [face[0], face[k + 1], face[k + 2]]));
    const places = Float32Array.from(triangles.flatMap((k) => corners[k]));
    geometry.setAttribute("position", new three.BufferAttribute(places, 3));
    geometry.computeVertexNormals();
    const material = this.material("face", { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    const edges = new three.EdgesGeometry(geometry, SMOOTH_ANGLE);
    group.add(new three.Mesh(geometry, material), new three.LineSegments(edges, new three.LineBasicMaterial({ color: this.look.faceEdge })));
    group.matrixAutoUpdate = false;
    group.place = ({ frame: [x, y, z, ...R] }) => {
      group.matrix.set(...R.slice(0, 3), x, ...R.slice(3, 6), y, ...R.slice(6), z, 0, 0, 0, 1);
      group.matrixWorldNeedsUpdate = true;
    };
    return group;
  }

  // A thin translucent disk with a rim; created perpendicular to z, then rotated to its axle.
  wheel() {
    const { three } = this, group = new three.Group(), axis = new three.Vector3(0, 0, 1), to = new three.Vector3();
    const disk = new three.Mesh(new three.CircleGeometry(1, 64), this.material("wheel", { transparent: true, opacity: 0.6, depthWrite: false }));
    group.add(disk, new three.Mesh(new three.TorusGeometry(1, 0.03, 12, 96), this.material("wheelEdge")));
    group.place = ({ points }) => {
      const center = mix(points[0], points[24], 0.5), radius = Math.hypot(...minus(points[0], center));
      group.position.set(...center);
      group.scale.setScalar(radius || 1e-9);
      group.quaternion.setFromUnitVectors(axis, to.set(...unit(cross(minus(points[0], center), minus(points[12], center)))));
    };
    return group;
  }

  ball() {
    const { three } = this, ball = new three.Mesh(new three.SphereGeometry(1, 32, 24), this.material("ball"));
    ball.place = ({ points, radius }) => { ball.position.set(...points[0]); ball.scale.setScalar(Math.abs(radius) || 1e-9); };
    return ball;
  }
}

const SMOOTH_ANGLE = 35; // degrees

const MESHES = {
  bar: (stage) => stage.rod(0.01 * stage.box.size, "bar"),
  line: (stage, { points }) => (points.length > 2 ? stage.wire(0.004 * stage.box.size, "line") : stage.rod(0.005 * stage.box.size, "line")),
  path: (stage) => stage.curve("path"),
  face: (stage, { points }) => stage.plane(points.length, "face", "faceEdge"),
  floor: (stage, { points }) => stage.plane(points.length, "floor", "floorEdge", { transparent: true, opacity: 0.7 }),
  wheel: (stage) => stage.wheel(),
  solid: (stage, stroke) => stage.solid(stroke),
  ball: (stage) => stage.ball(),
};

// Return the stage for a drawing: three.js for space if possible, else a plain canvas.
async function stageOf(about) {
  const canvas = element("stage");
  if (about.dimension === 3 && element("three-core")) {
    try {
      return new SpaceStage(canvas, about, await openThree());
    } catch (error) {
      console.info(`no WebGL here (${error.message}): space is drawn on a plain canvas`);
      const fresh = canvas.cloneNode();
      canvas.replaceWith(fresh);
      return new Stage(fresh, about, fresh.getContext("2d"));
    }
  }
  return new Stage(canvas, about, canvas.getContext("2d"));
}
