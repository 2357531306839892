// shapes.js: conversion of a drawing to strokes { kind, points } in space; kind is one of
// bar, line, face, floor, wheel, ball (with a radius), solid (with corners, faces and a frame). The stage decides how
// strokes look.

const COILS = 8;
const AROUND = Array.from({ length: 49 }, (_, k) => (2 * Math.PI * k) / 48);

function strokes(about, numbers, size) {
  const d = about.dimension;
  const point = (first) => [numbers[first], numbers[first + 1], d === 3 ? numbers[first + 2] : 0];
  return about.shapes.flatMap((shape) => STROKES[shape.kind](shape, point, numbers, d, size));
}

const pointsOf = (shape, point, d) => Array.from({ length: shape.count / d }, (_, k) => point(shape.first + d * k));

const STROKES = {
  line: (shape, point, _numbers, d) => [{ kind: "bar", points: pointsOf(shape, point, d) }],
  spring: (shape, point, _numbers, d, size) => [{ kind: "line", points: coil(...pointsOf(shape, point, d), d, size) }],
  disk: (shape, point, numbers, d) => disk(point(shape.first), numbers, shape, d),
  body(shape, point, _numbers, d) {
    const corners = pointsOf(shape, point, d);
    return (shape.faces ?? [corners.keys()]).map((face) => ({ kind: "face", points: [...face].map((k) => corners[k]) }));
  },
  solid: (shape, _point, numbers) => [solid(shape, numbers.slice(shape.first, shape.first + shape.count))],
  ground(shape, point, _numbers, d, size) {
    const points = pointsOf(shape, point, d);
    if (points.length > 2) return [{ kind: "floor", points }];
    if (d === 2) return hatched(points, 0.04 * size);
    return points.length > 1 ? [{ kind: "bar", points }] : [{ kind: "floor", points: plate(points[0], 0.03 * size) }];
  },
  trace: () => [],
};

function coil(p, q, d, size) {
  const [first, second] = d === 3 ? across(minus(q, p)) : [unit([p[1] - q[1], q[0] - p[0], 0]), [0, 0, 0]];
  return Array.from({ length: 16 * COILS + 1 }, (_, k) => {
    const part = k / (16 * COILS);
    const swing = part > 0.08 && part < 0.92 ? 0.018 * size : 0;
    const phase = (2 * Math.PI * COILS * (part - 0.08)) / 0.84;
    return plus(plus(mix(p, q, part), first, swing * Math.sin(phase)), second, swing * Math.cos(phase));
  });
}

function disk(center, numbers, shape, d) {
  const radius = numbers[shape.first + d], more = shape.count - d - 1;
  if (d === 3 && more === 0) return [{ kind: "ball", points: [center], radius }];
  const axis = d === 3 ? Array.from(numbers.slice(shape.first + 4, shape.first + 7)) : [0, 0, 1];
  const [first, second] = d === 3 ? nodes(axis) : [[1, 0, 0], [0, 1, 0]];
  const rim = (angle) => plus(plus(center, first, radius * Math.cos(angle)), second, radius * Math.sin(angle));
  const result = [{ kind: "wheel", points: AROUND.map(rim) }];
  const marked = d === 3 ? more === 4 : more === 1;
  if (marked) result.push({ kind: "line", points: [center, rim(numbers[shape.first + shape.count - 1])] });
  return result;
}

// A solid whose corners move with a frame: position, and rotation row by row.
function solid({ corners, faces }, frame) {
  const place = (corner) => [0, 1, 2].map((axis) => frame[axis] + dot(frame.slice(3 + 3 * axis, 6 + 3 * axis), corner));
  return { kind: "solid", points: corners.map(place), corners, faces, frame };
}

const plate = (p, side) => [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([x, y]) => plus(p, [x, y, 0], side));

// A wall from p to q with hatches on its right, or a support (one point) on a short wall.
function hatched(points, length) {
  const result = [];
  let [p, q] = points;
  if (points.length === 1) {
    const left = plus(p, [-length / 2, -length, 0]), right = plus(p, [length / 2, -length, 0]);
    result.push({ kind: "line", points: [p, left, right, p] });
    [p, q] = [plus(left, [-length / 3, 0, 0]), plus(right, [length / 3, 0, 0])];
  }
  const along = unit(minus(q, p)), count = Math.max(3, Math.round((Math.hypot(...minus(q, p)) / length) * 3));
  const slant = [along[1] - along[0], -along[0] - along[1], 0];
  result.push({ kind: "line", points: [p, q] });
  for (let k = 0; k < count; ++k) {
    const foot = mix(p, q, k / (count - 1));
    result.push({ kind: "line", points: [foot, plus(foot, slant, length / 3)] });
  }
  return result;
}
