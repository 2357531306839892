// plots.js: plots over time, with a line at the current time; dragging seeks.

const DASHES = [[], [6, 3], [2, 3], [8, 3, 2, 3]];

class Plot {
  constructor(parent, { title, series, log }, seek) {
    this.series = series;
    this.log = log;
    this.figure = document.createElement("figure");
    this.figure.innerHTML = `<figcaption>${title}<span class="legend">${series.map((one, k) =>
      `<span class="key"><svg width="22" height="8" aria-hidden="true"><line x1="0" x2="22" y1="4" y2="4"
        stroke="var(--series${(k % 6) + 1})" stroke-width="2" stroke-dasharray="${DASHES[k % 4].join(" ")}"/></svg><span>${one.label}</span></span>`).join("")}</span></figcaption>`;
    this.canvas = document.createElement("canvas");
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", `${this.figure.textContent.trim()} over time`);
    this.figure.append(this.canvas);
    parent.append(this.figure);
    this.brush = this.canvas.getContext("2d");
    const point = (event) => {
      const box = this.canvas.getBoundingClientRect();
      seek(((event.clientX - box.left - LEFT) / (box.width - LEFT - RIGHT)) * this.motion.last);
    };
    this.canvas.addEventListener("pointerdown", (event) => { this.canvas.setPointerCapture(event.pointerId); point(event); });
    this.canvas.addEventListener("pointermove", (event) => { if (event.buttons) point(event); });
  }

  setMotion(motion) {
    this.motion = motion;
    this.columns = this.series.map((one) => one.values(motion));
    const seen = this.columns.flatMap((column) => [...column]).filter(Number.isFinite);
    let low = Math.min(...seen), high = Math.max(...seen);
    if (!seen.length) [low, high] = [0, 1];
    if (this.log) [low, high] = [-17, Math.max(-12, Math.ceil(high))];
    const room = 0.08 * (high - low) || Math.max(1e-12, 0.1 * Math.abs(high));
    this.range = this.log ? [low, high] : [low - room, high + room];
    this.background = null;
  }

  show(t) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !this.motion) return;
    if (!this.background || this.background.width !== Math.round(width * devicePixelRatio) || this.background.look !== theme()) this.paint();
    sharpen(this.canvas, this.brush);
    this.brush.drawImage(this.background, 0, 0, width, height);
    const x = LEFT + (t / (this.motion.last || 1)) * (width - LEFT - RIGHT);
    this.brush.strokeStyle = theme().ink;
    this.brush.lineWidth = 1;
    this.brush.beginPath();
    this.brush.moveTo(x, ABOVE);
    this.brush.lineTo(x, height - BELOW);
    this.brush.stroke();
    this.series.forEach((one, k) => {
      const value = this.at(k, t);
      if (!Number.isFinite(value)) return;
      this.brush.fillStyle = theme()[`series${(k % 6) + 1}`];
      this.brush.beginPath();
      this.brush.arc(x, this.y(value, height), 3, 0, 2 * Math.PI);
      this.brush.fill();
    });
  }

  at(k, t) {
    const [row, part] = this.motion.where(t), column = this.columns[k], next = Math.min(row + 1, column.length - 1);
    return column[row] + part * (column[next] - column[row]);
  }

  y(value, height) {
    const [low, high] = this.range;
    return ABOVE + ((high - value) / (high - low)) * (height - BELOW - ABOVE);
  }

  // Paint everything that does not depend on the current time, once.
  paint() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.background = Object.assign(document.createElement("canvas"), {
      width: Math.round(width * devicePixelRatio), height: Math.round(height * devicePixelRatio), look: theme(),
    });
    const brush = this.background.getContext("2d");
    brush.scale(devicePixelRatio, devicePixelRatio);
    this.grid(brush, width, height);
    const x = (row) => LEFT + (this.motion.at(row, 0) / (this.motion.last || 1)) * (width - LEFT - RIGHT);
    this.columns.forEach((column, k) => {
      brush.strokeStyle = theme()[`series${(k % 6) + 1}`];
      brush.setLineDash(DASHES[k % 4]);
      brush.lineWidth = 1.6;
      brush.beginPath();
      let pen = false;
      column.forEach((value, row) => {
        if (!Number.isFinite(value)) { pen = false; return; }
        if (pen) brush.lineTo(x(row), this.y(value, height)); else brush.moveTo(x(row), this.y(value, height));
        pen = true;
      });
      brush.stroke();
    });
  }

  grid(brush, width, height) {
    const look = theme();
    brush.font = "11px system-ui, sans-serif";
    brush.fillStyle = look.ink;
    brush.strokeStyle = look.grid;
    brush.textBaseline = "middle";
    brush.textAlign = "right";
    for (const value of ticks(...this.range, 5, this.log)) {
      const y = this.y(value, height);
      brush.beginPath();
      brush.moveTo(LEFT, y);
      brush.lineTo(width - RIGHT, y);
      brush.stroke();
      brush.fillText(this.log ? `1e${value}` : brief(value), LEFT - 6, y);
    }
    brush.textBaseline = "alphabetic";
    brush.textAlign = "center";
    for (const value of ticks(0, this.motion.last || 1, 5)) {
      brush.fillText(brief(value), LEFT + (value / (this.motion.last || 1)) * (width - LEFT - RIGHT), height - 4);
    }
  }
}

const LEFT = 58, RIGHT = 10, BELOW = 18, ABOVE = 9;

const brief = (value) => (value === 0 ? "0" : Math.abs(value) >= 1e4 || Math.abs(value) < 1e-3 ? value.toExponential(0) : String(+value.toPrecision(4)));

function ticks(low, high, count, whole = false) {
  const span = high - low, power = 10 ** Math.floor(Math.log10(span / count));
  let step = [1, 2, 5, 10].map((part) => part * power).find((part) => span / part <= count) ?? 10 * power;
  if (whole) step = Math.max(1, Math.round(step));
  const first = Math.ceil(low / step) * step;
  return Array.from({ length: Math.floor((high - first) / step + 1e-9) + 1 }, (_, k) => +(first + k * step).toPrecision(12));
}

const inUnit = (unit) => (unit ? ` [${plain(unit)}]` : "");

const plain = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");

function plotsOf(about) {
  const column = (place, label) => ({ label, values: (motion) => motion.column(motion.places[place[0]] + place[1]) });
  const digits = (value) => Math.log10(Math.max(Math.abs(value), 1e-17));
  const series = about.coordinates.map((one, k) => ({ ...column([one.state ? "v" : "x", k], one.label + inUnit(one.unit)), state: one.state }));
  const found = [{ title: "coordinates", series: series.filter((one) => !one.state) }];
  if (series.some((one) => one.state)) found.push({ title: "states", series: series.filter((one) => one.state) });
  if (about.conservesEnergy) {
    const drift = (motion) => {
      const energy = motion.column(motion.places.energy);
      return energy.map((value) => digits(value - energy[0]));
    };
    found.push({ title: "energy drift", log: true, series: [{ label: `|E − E<sub>0</sub>|${inUnit(about.energy)}`, values: drift }] });
  }
  const residual = (place, label) => ({ label, values: (motion) => motion.column(motion.places[place]).map(digits) });
  if (about.m) {
    const series = [residual("rates", "max |A ẋ + b|")];
    if (about.h) series.push(residual("positions", "max |φ|"));
    found.push({ title: "constraint residual", log: true, series });
    const names = Array.from({ length: about.m }, (_, k) => column(["lambda", k], `λ<sub>${k}</sub>`));
    found.push({ title: "multipliers", series: names });
  }
  return found;
}
