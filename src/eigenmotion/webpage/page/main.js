// main.js: the page object, which is `eigenmotion` in the console.

const element = (id) => document.getElementById(id);
const about = JSON.parse(element("about").textContent);
const embedded = document.documentElement.classList.contains("embed");
const inTime = (t) => `${+t.toPrecision(6)} ${about.time}`.trim();

class Page {
  constructor(engine, stage) {
    Object.assign(this, { engine, stage });
    this.abscissa = null;
    if (!stage) element("stage").hidden = true;
    const parts = Object.fromEntries(["play", "scrub", "speed", "clock"].map((id) => [id, element(id)]));
    this.player = new Player(parts, (t) => this.show(t));
    this.scheduled = false;
    this.controls();
    this.keys();
    this.offerAbscissas();
    element("span").value = about.tEnd;
    element("span").addEventListener("change", () => this.changed());
    element("reset").addEventListener("click", () => this.reset());
    element("view").addEventListener("click", () => this.stage?.reset());
    new ResizeObserver(() => this.show(this.player.t)).observe(document.body);
    onTheme(() => this.show(this.player.t));
    this.run();
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) this.player.play();
  }

  controls() {
    const make = (parent, entries, write, coordinate) => entries.map((entry, k) => entry.mode ? null :
      new Control(element(parent), entry, (control, done) => { write(k, control.value); this.changed(coordinate && done); }));
    const { parameters, inputs, coordinates, v } = about;
    const rate = (one, k) => ({ name: one.state ? one.name : `${one.name}'`, label: one.rate, unit: one.rateUnit, value: v[k], ...around(v[k], 2) });
    this.fields = {
      parameters: make("parameters", parameters.map((one) => ({ ...one, ...rangeOf(one.value, one.positive) })),
        (k, value) => { this.engine.parameters[k] = value; }),
      inputs: make("parameters", inputs.map((one) => ({ ...one, ...around(one.value, 1) })),
        (k, value) => { this.engine.inputs[k] = value; }),
      x: make("initial", coordinates.map((one) => ({ ...one, mode: one.state, ...around(one.value, 1) })),
        (k, value) => { this.engine.x.set(this.start.x); this.engine.x[k] = this.start.x[k] = value; }, true),
      v: make("initial", coordinates.map(rate),
        (k, value) => { this.engine.v.set(this.start.v); this.engine.v[k] = this.start.v[k] = value; }, true),
    };
    this.start = { x: Array.from(this.engine.x), v: Array.from(this.engine.v) };
    fitNames();
    for (const id of ["initial", "parameters"]) element(id).parentElement.addEventListener("toggle", fitNames);
  }

  // At most one run per frame, however fast a slider moves.
  changed(settled = true) {
    this.settled = settled;
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => { this.scheduled = false; this.run(); });
  }

  run() {
    const { engine } = this, tEnd = Math.min(1000, Math.max(0.1, element("span").valueAsNumber || about.tEnd));
    const status = engine.settle();
    if (status) { this.showStatus(status, 0, engine.calls.fault_first()); return; }
    const moved = about.coordinates.some((_, k) => Math.abs(engine.x[k] - this.start.x[k]) > 1e-9);
    this.start = { x: Array.from(engine.x), v: Array.from(engine.v) };
    for (const [kind, values] of [["x", engine.x], ["v", engine.v]]) {
      this.fields[kind].forEach((field, k) => { if (field && (document.activeElement !== field.slider || this.settled)) field.set(values[k]); });
    }
    const motion = engine.run(tEnd), { end } = motion;
    this.showStatus(end.status, end.reached, end.coordinate, moved);
    if (!motion.rows) return;
    this.motion = motion;
    element("cost").textContent = `${end.steps} steps, ${end.rhs} right-hand sides, ${end.milliseconds.toFixed(1)} ms`;
    this.plots ??= this.makePlots();
    for (const plot of this.plots) plot.setMotion(motion, this.abscissa);
    this.player.setEnd(this.motion.last);
  }

  makePlots() {
    const checks = checksOf(about), seek = (t) => { this.player.pause(); this.player.seek(t); };
    element("checks").hidden = !checks.length;
    for (const id of ["curves", "checks"]) element(id).addEventListener("toggle", () => this.show(this.player.t));
    return [
      ...plotsOf(about, this.motion).map((plot) => new Plot(element("plots"), plot, seek)),
      ...checks.map((plot) => new Plot(element("checks").querySelector(".plots"), plot, seek)),
    ];
  }

  // The time, and every quantity over which plots can be drawn.
  offerAbscissas() {
    const { coordinates, states, outputs } = quantitiesOf(about), offered = [OVER_TIME, ...coordinates, ...states, ...outputs];
    const select = element("abscissa");
    select.append(...offered.map((one, k) => new Option(k ? one.text : `time ${one.text}`, k)));
    select.addEventListener("change", () => {
      this.abscissa = +select.value ? offered[+select.value] : null;
      for (const plot of this.plots ?? []) plot.setMotion(this.motion, this.abscissa);
      this.show(this.player.t);
    });
  }

  showStatus(status, t, coordinate, moved = false) {
    const words = [], { name, text, placed, failure } = about.endings[status];
    if (failure) {
      const where = about.coordinates[coordinate]?.name ?? "";
      const more = coordinate < 0 ? text : placed.replaceAll("{coordinate}", where).replaceAll("{row}", coordinate);
      words.push(`At t = ${inTime(t)} the run ended: ${name}. ${more}`);
    } else if (status) {
      words.push(`A terminal event ended the run at t = ${inTime(t)}.`);
    }
    if (moved) words.push("The start was put back on the constraints.");
    if (this.engine.leastNorm) words.push("Constraint rows depend on each other: multipliers of least norm.");
    element("word").textContent = words.join(" ");
    element("word").className = failure ? "failure" : "";
  }

  reset() {
    const { engine } = this;
    engine.parameters.set(about.parameters.map((one) => one.value));
    engine.inputs.set(about.inputs.map((one) => one.value));
    engine.x.set(about.coordinates.map((one) => one.value));
    engine.v.set(about.v);
    for (const kind of ["parameters", "inputs"]) this.fields[kind].forEach((field) => field?.reset());
    this.start = { x: Array.from(engine.x), v: Array.from(engine.v) };
    element("span").value = about.tEnd;
    this.player.seek(0);
    this.run();
  }

  show(t) {
    if (!this.motion) return;
    this.stage?.show(this.motion, t);
    for (const plot of this.plots ?? []) plot.show(t);
    this.frames = (this.frames ?? 0) + 1;
  }

  keys() {
    const { player } = this, step = () => player.last / 100;
    const actions = {
      " ": () => player.toggle(), k: () => player.toggle(),
      ArrowRight: () => { player.pause(); player.seek(player.t + step()); },
      ArrowLeft: () => { player.pause(); player.seek(player.t - step()); },
      Home: () => player.seek(0), End: () => player.seek(player.last),
      "+": () => this.zoom(1.25), "-": () => this.zoom(0.8), 0: () => this.stage?.reset(),
    };
    addEventListener("keydown", (event) => {
      if (event.target.closest("input, select, button, a, summary") || event.ctrlKey || event.metaKey || event.altKey) return;
      const action = actions[event.key];
      if (!action) return;
      event.preventDefault();
      action();
    });
  }

  zoom(factor) {
    const canvas = element("stage");
    this.stage?.zoomed(factor, canvas.clientWidth / 2, canvas.clientHeight / 2);
  }
}

if (embedded && parent !== window) reportHeight();
document.documentElement.classList.toggle("framed", window.top !== window); // a page that frames this one has a title
try {
  about.endings = JSON.parse(await unpackedText("endings"));
  const engine = await Engine.open(element("wasm").textContent, about);
  window.eigenmotion = new Page(engine, about.dimension ? await stageOf(about) : null);
} catch (error) {
  element("word").textContent = `This page needs a browser with WebAssembly and module scripts: ${error.message}`;
  element("word").className = "failure";
  throw error;
}
