// vectors.js: vector algebra for drawing. Points have three numbers; in the plane the third is 0.

const plus = (a, b, factor = 1) => [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]];
const minus = (a, b) => plus(a, b, -1);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => { const length = Math.hypot(...a); return length > 0 ? a.map((value) => value / length) : [1, 0, 0]; };
const mix = (a, b, part) => plus(a, minus(b, a), part);

// Two directions across an axle: the line of nodes, z x axle (x if the axle is vertical), and axle x that.
function nodes(axis) {
  const axle = unit(axis), line = cross([0, 0, 1], axle);
  const first = Math.hypot(...line) > 1e-9 ? unit(line) : [1, 0, 0];
  return [first, cross(axle, first)];
}

// Two directions across a line.
function across(direction) {
  const along = unit(direction), least = along.map(Math.abs);
  const axis = [0, 0, 0];
  axis[least.indexOf(Math.min(...least))] = 1;
  const first = unit(cross(along, axis));
  return [first, cross(along, first)];
}
