// motion.js: motion of a run: rows, and interpolation between them.

class Motion {
  constructor(about, table, width, end) {
    Object.assign(this, { about, table, width, end });
    this.rows = table.length / width;
    const { n, m } = about;
    this.places = { t: 0, x: 1, v: 1 + n, energy: 1 + 2 * n, rates: 2 + 2 * n, positions: 3 + 2 * n };
    this.places.lambda = 4 + 2 * n;
    this.places.outputs = 4 + 2 * n + m;
    this.places.drawn = this.places.outputs + about.outputs.length;
  }

  get last() { return this.rows ? this.table[(this.rows - 1) * this.width] : 0; }

  at(row, place) { return this.table[row * this.width + place]; }

  column(place) {
    return Float64Array.from({ length: this.rows }, (_, row) => this.at(row, place));
  }

  // The row before a time, and the fraction of the way to the next row, 0 ... 1.
  where(t) {
    if (this.rows < 2) return [0, 0];
    let low = 0, high = this.rows - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.at(middle, 0) <= t) low = middle; else high = middle;
    }
    const before = this.at(low, 0), after = this.at(high, 0);
    return [low, after > before ? Math.min(1, Math.max(0, (t - before) / (after - before))) : 0];
  }

  // Numbers of the drawing at a time; rows are so close that linear interpolation is enough.
  drawn(t) {
    const [row, part] = this.where(t);
    const next = Math.min(row + 1, this.rows - 1);
    return Float64Array.from({ length: this.width - this.places.drawn }, (_, k) => {
      const from = this.at(row, this.places.drawn + k);
      return from + part * (this.at(next, this.places.drawn + k) - from);
    });
  }

  value(place, t) {
    const [row, part] = this.where(t);
    const next = Math.min(row + 1, this.rows - 1);
    return this.at(row, place) + part * (this.at(next, place) - this.at(row, place));
  }

  // Coordinates of the points of a shape in a row, point by point.
  extremes(shape, row) {
    const first = this.places.drawn + shape.first, count = shape.kind === "disk" ? this.about.dimension : shape.count;
    const numbers = Array.from({ length: count }, (_, k) => this.at(row, first + k));
    return shape.kind === "solid" ? solid(shape, numbers).points.flat() : numbers;
  }

  // Corners around the points of all shapes at some times, in space: what a view has to show.
  points() {
    const { dimension, shapes } = this.about, found = [];
    if (dimension < 3) return found;
    for (let row = 0; row < this.rows; row += Math.max(1, this.rows >> 5)) {
      for (const shape of shapes) {
        const numbers = this.extremes(shape, row);
        const room = shape.kind === "disk" ? Math.abs(this.at(row, this.places.drawn + shape.first + 3)) : 0;
        for (let k = 0; k + 2 < numbers.length; k += 3) {
          if (numbers.slice(k, k + 3).every(Number.isFinite)) found.push({ at: numbers.slice(k, k + 3), room });
        }
      }
    }
    return found;
  }

  // Bounding box of all shapes at all times.
  box() {
    const { dimension, shapes } = this.about;
    const low = Array(3).fill(Infinity), high = Array(3).fill(-Infinity);
    for (let row = 0; row < this.rows; row += Math.max(1, this.rows >> 8)) {
      for (const shape of shapes) {
        const first = this.places.drawn + shape.first;
        const room = shape.kind === "disk" ? Math.abs(this.at(row, first + dimension)) : 0;
        this.extremes(shape, row).forEach((value, k) => {
          const axis = k % dimension;
          if (!Number.isFinite(value)) return;
          low[axis] = Math.min(low[axis], value - room);
          high[axis] = Math.max(high[axis], value + room);
        });
      }
    }
    for (let axis = 0; axis < 3; ++axis) if (!(low[axis] <= high[axis])) low[axis] = high[axis] = 0;
    const size = Math.max(...high.map((value, axis) => value - low[axis])) || 1;
    for (const { kind, first, count } of shapes) { // a support in the plane stands on hatches
      if (kind === "ground" && dimension === 2 && count === 2) low[1] = Math.min(low[1], this.at(0, this.places.drawn + first + 1) - 0.055 * size);
    }
    return { low, high, points: this.points(), size };
  }
}
