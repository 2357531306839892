// plots.js: plots over the abscissa (the time or a quantity), with a mark at the current time; dragging seeks.

const DASHES = [[], [6, 3], [2, 3], [8, 3, 2, 3]];
const LEFT = 64, RIGHT = 18, BELOW = 36, ABOVE = 9;

class Plot {
  // look: { title, series, log, timed }; a timed plot is over time whatever the abscissa.
  constructor(parent, { title, series, log, timed }, seek) {
    Object.assign(this, { series, log, timed });
    this.figure = document.createElement("figure");
    this.figure.innerHTML = `<figcaption>${title}<span class="legend">${series.map((one, k) =>
      `<span class="key"><svg width="22" height="8" aria-hidden="true"><line x1="0" x2="22" y1="4" y2="4"
        stroke="var(--series${(k % 6) + 1})" stroke-width="2" stroke-dasharray="${DASHES[k % 4].join(" ")}"/></svg><span>${one.label}</span></span>`).join("")}</span></figcaption>`;
    this.canvas = document.createElement("canvas");
    this.canvas.setAttribute("role", "img");
    this.figure.append(this.canvas);
    parent.append(this.figure);
    this.brush = this.canvas.getContext("2d");
    const point = (event) => {
      const box = this.canvas.getBoundingClientRect(), [low, high] = this.across;
      seek(this.timeAt(low + ((event.clientX - box.left - LEFT) / (box.width - LEFT - RIGHT)) * (high - low)));
    };
    this.canvas.addEventListener("pointerdown", (event) => { this.canvas.setPointerCapture(event.pointerId); point(event); });
    this.canvas.addEventListener("pointermove", (event) => { if (event.buttons) point(event); });
  }

  // abscissa: { text, values }, or null for the time.
  setMotion(motion, abscissa) {
    this.motion = motion;
    this.abscissa = (this.timed ? null : abscissa) ?? OVER_TIME;
    this.places = this.abscissa.values(motion);
    this.across = this.abscissa === OVER_TIME ? [0, motion.last || 1] : roomy(this.places, 0.03);
    this.columns = this.series.map((one) => one.values(motion));
    this.range = roomy(this.columns.flatMap((column) => [...column]), 0.08);
    if (this.log) this.range = [-17, Math.max(-12, Math.ceil(this.range[1]))];
    this.background = null;
    this.canvas.setAttribute("aria-label", `${this.figure.textContent.trim()} over ${this.abscissa.text}`);
  }

  // The time at a place of the abscissa: of a quantity that turns back, that nearest to the time shown.
  timeAt(place) {
    if (this.abscissa === OVER_TIME) return place;
    const { motion } = this, reach = 0.01 * (this.across[1] - this.across[0]);
    let best = 0, least = Infinity;
    this.places.forEach((value, row) => {
      const away = Math.max(0, Math.abs(value - place) - reach) * 1e6 + Math.abs(motion.at(row, 0) - this.t);
      if (away < least) [best, least] = [row, away];
    });
    return motion.at(best, 0);
  }

  show(t) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.t = t;
    if (!width || !this.motion) return;
    if (!this.background || this.background.width !== Math.round(width * devicePixelRatio) || this.background.look !== theme()) this.paint();
    sharpen(this.canvas, this.brush);
    this.brush.drawImage(this.background, 0, 0, width, height);
    const x = this.x(this.at(this.places, t), width);
    if (!Number.isFinite(x)) return;
    this.brush.strokeStyle = theme().ink;
    this.brush.lineWidth = 1;
    this.brush.beginPath();
    this.brush.moveTo(x, ABOVE);
    this.brush.lineTo(x, height - BELOW);
    this.brush.stroke();
    this.columns.forEach((column, k) => {
      const value = this.at(column, t);
      if (!Number.isFinite(value)) return;
      this.brush.fillStyle = theme()[`series${(k % 6) + 1}`];
      this.brush.beginPath();
      this.brush.arc(x, this.y(value, height), 3, 0, 2 * Math.PI);
      this.brush.fill();
    });
  }

  at(column, t) {
    const [row, part] = this.motion.where(t), next = Math.min(row + 1, column.length - 1);
    return column[row] + part * (column[next] - column[row]);
  }

  x(value, width) {
    const [low, high] = this.across;
    return LEFT + ((value - low) / (high - low)) * (width - LEFT - RIGHT);
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
    this.columns.forEach((column, k) => {
      brush.strokeStyle = theme()[`series${(k % 6) + 1}`];
      brush.setLineDash(DASHES[k % 4]);
      brush.lineWidth = 1.6;
      brush.beginPath();
      let pen = false;
      column.forEach((value, row) => {
        const x = this.x(this.places[row], width);
        if (!Number.isFinite(value) || !Number.isFinite(x)) { pen = false; return; }
        if (pen) brush.lineTo(x, this.y(value, height)); else brush.moveTo(x, this.y(value, height));
        pen = true;
      });
      brush.stroke();
    });
  }

  grid(brush, width, height) {
    const look = theme();
    brush.font = "12px system-ui, sans-serif";
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
    for (const value of ticks(...this.across, 5)) brush.fillText(brief(value), this.x(value, width), height - BELOW + 15);
    brush.fillStyle = look.faint;
    brush.fillText(this.abscissa.text, (LEFT + width - RIGHT) / 2, height - 4);
  }
}

// The range of finite values, with some room at both ends.
function roomy(values, part) {
  let low = Infinity, high = -Infinity;
  for (const value of values) if (Number.isFinite(value)) { low = Math.min(low, value); high = Math.max(high, value); }
  if (!(low <= high)) return [0, 1];
  const room = part * (high - low) || 0.1 * Math.abs(high) || 1;
  return [low - room, high + room];
}

function brief(value) {
  const size = Math.abs(value), plainly = size === 0 || (size >= 1e-3 && size < 1e5);
  const text = plainly ? String(+value.toPrecision(4)) : (+value.toPrecision(3)).toExponential().replace("+", "");
  return text.replace("-", "\u2212");
}

function ticks(low, high, count, whole = false) {
  const span = high - low, power = 10 ** Math.floor(Math.log10(span / count));
  let step = [1, 2, 5, 10].map((part) => part * power).find((part) => span / part <= count) ?? 10 * power;
  if (whole) step = Math.max(1, Math.round(step));
  const first = Math.ceil(low / step) * step;
  return Array.from({ length: Math.floor((high - first) / step + 1e-9) + 1 }, (_, k) => +(first + k * step).toPrecision(12));
}
