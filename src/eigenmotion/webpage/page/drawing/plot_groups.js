// plot_groups.js: groups of quantities that share a plot: those of one unit and of similar size.

const MOST_LINES = 6;
const SIMILAR = 12; // ratio of spans up to which lines share an axis
const STILL = 1e-9; // part of the largest span below which a line stands still

const plain = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
const POWERS = { "-": "\u207b", 0: "\u2070", 1: "\u00b9", 2: "\u00b2", 3: "\u00b3", 4: "\u2074", 5: "\u2075", 6: "\u2076", 7: "\u2077", 8: "\u2078", 9: "\u2079" };

// A unit with raised powers and products, as "kg·m²".
const inPrint = (unit) => unit.replace(/(?:\^|\*\*)(-?\d+)/g, (_, power) => [...power].map((digit) => POWERS[digit]).join(""))
  .replace(/(\S) (?=\S)/g, "$1\u00b7").replaceAll("*", "\u00b7");
const withUnit = (text, unit) => (unit ? `${text} [${inPrint(unit)}]` : text);

// The text of a formula, for a canvas.
const textOf = (label) => Object.assign(document.createElement("template"), { innerHTML: label }).content.textContent;

const column = (place, k) => (motion) => motion.column(motion.places[place] + k);
const OVER_TIME = { get text() { return withUnit("t", about.time); }, values: column("t", 0) };

// The coordinates, states and outputs of a model, each { label, text, unit, values }.
function quantitiesOf({ coordinates, outputs }) {
  const quantity = (one, values) => ({ label: one.label, text: withUnit(textOf(one.label), one.unit), unit: one.unit, values });
  const all = coordinates.map((one, k) => ({ ...quantity(one, column(one.state ? "v" : "x", k)), state: one.state }));
  return {
    coordinates: all.filter((one) => !one.state), states: all.filter((one) => one.state),
    outputs: outputs.map((one, k) => quantity(one, column("outputs", k))),
  };
}

const spanOf = (one, motion) => {
  const values = one.values(motion).filter(Number.isFinite);
  return values.reduce((most, value) => Math.max(most, value), -Infinity) - values.reduce((least, value) => Math.min(least, value), Infinity);
};

// Lists of series whose spans differ by less than SIMILAR from one to the next; their order is kept.
function bySize(series, motion) {
  const spans = new Map(series.map((one) => [one, spanOf(one, motion)]));
  const largest = Math.max(...spans.values());
  const moving = series.filter((one) => spans.get(one) > STILL * largest).sort((a, b) => spans.get(b) - spans.get(a));
  const level = new Map();
  moving.forEach((one, k) => {
    const before = moving[k - 1];
    level.set(one, k === 0 ? 0 : level.get(before) + (spans.get(before) > SIMILAR * spans.get(one) ? 1 : 0));
  });
  return grouped(series, (one) => level.get(one) ?? 0);
}

function grouped(series, key) {
  const groups = new Map();
  for (const one of series) groups.set(key(one), [...(groups.get(key(one)) ?? []), one]);
  return [...groups.values()];
}

// Pieces of at most MOST_LINES, of nearly equal length.
function pieces(series) {
  const count = Math.ceil(series.length / MOST_LINES), size = Math.ceil(series.length / count);
  return Array.from({ length: count }, (_, k) => series.slice(k * size, (k + 1) * size));
}

function plotsByUnit(title, series, motion) {
  const groups = grouped(series, (one) => one.unit).flatMap((group) => bySize(group, motion));
  return groups.flatMap(pieces).map((group) => ({ title: withUnit(title, plain(group[0].unit)), series: group }));
}

// Rows of one name share a plot, if there are too many for one.
function plotsOfMultipliers({ multipliers }) {
  const series = multipliers.map((one, k) => ({ label: one.label, name: one.name.replace(/\[\d+\]$/, ""), values: column("lambda", k) }));
  const groups = series.length > MOST_LINES ? grouped(series, (one) => one.name) : [series];
  return groups.flatMap(pieces).map((group) => ({
    title: groups.length > 1 && group[0].name ? `multipliers of ${plain(group[0].name)}` : "multipliers", series: group,
  }));
}

// Plots of a motion; the units, and the spans of this motion, say which lines share axes.
function plotsOf(about, motion) {
  const { coordinates, states, outputs } = quantitiesOf(about);
  return [
    ...plotsByUnit("coordinates", coordinates, motion),
    ...(states.length ? plotsByUnit("states", states, motion) : []),
    ...(outputs.length ? plotsByUnit("outputs", outputs, motion) : []),
    ...(about.m ? plotsOfMultipliers(about) : []),
  ];
}

// Plots of what an exact motion would have at zero.
function checksOf(about) {
  const digits = (value) => Math.log10(Math.max(Math.abs(value), 1e-17));
  const drift = (motion) => {
    const energy = motion.column(motion.places.energy);
    return energy.map((value) => digits(value - energy[0]));
  };
  const residual = (place, label) => ({ label, values: (motion) => motion.column(motion.places[place]).map(digits) });
  const rows = about.m ? [residual("rates", "max |A ẋ + b|"), ...(about.h ? [residual("positions", "max |φ|")] : [])] : [];
  const found = [];
  if (about.conservesEnergy) found.push({ title: withUnit("energy drift", plain(about.energy)), series: [{ label: "|E − E<sub>0</sub>|", values: drift }] });
  if (about.m) found.push({ title: "constraint residual", series: rows });
  return found.map((one) => ({ ...one, log: true, timed: true }));
}
