// controls.js: a slider with editable limits and a number field for each parameter, input and initial value.

class Control {
  constructor(parent, { name, label, unit, value, low, high }, changed) {
    Object.assign(this, { start: value, limits: [low, high], changed });
    const row = document.createElement("div");
    row.className = about.measured ? "control measured" : "control";
    row.innerHTML = `<span class="name" title="${plain(name)}">${label}</span><span class="range"><input type="range" step="any"><input
      class="limit" type="number" step="any"><input class="limit" type="number" step="any"></span><input type="number"
      class="value" step="any">${about.measured ? `<span class="unit" title="${plain(unit)}">${plain(inPrint(unit))}</span>` : ""}`;
    [this.slider, this.low, this.high, this.field] = row.querySelectorAll("input");
    for (const input of [this.slider, this.field]) {
      input.setAttribute("aria-label", name);
      input.dataset.name = name;
    }
    [[this.low, "least"], [this.high, "greatest"]].forEach(([input, which], end) => {
      input.setAttribute("aria-label", `${which} ${name}`);
      input.title = `${which} value of the slider`;
      input.dataset.limit = name;
      input.addEventListener("change", () => this.setLimit(end, input.valueAsNumber));
    });
    this.setLimits(low, high);
    parent.append(row);
    this.set(value);
    this.slider.addEventListener("input", () => { this.value = +this.slider.value; this.print(); changed(this); });
    this.slider.addEventListener("change", () => changed(this, true));
    this.field.addEventListener("change", () => {
      if (!Number.isFinite(this.field.valueAsNumber)) { this.print(); return; }
      this.set(this.field.valueAsNumber);
      changed(this, true);
    });
  }

  setLimits(low, high) {
    Object.assign(this.slider, { min: low, max: high });
    this.low.value = short(low);
    this.high.value = short(high);
  }

  // A limit that the user typed moves the value with it; one that is no number, or beyond the other limit, is undone.
  setLimit(end, limit) {
    const limits = [+this.slider.min, +this.slider.max];
    const before = limits[end];
    limits[end] = limit;
    if (!(limits[0] < limits[1])) limits[end] = before;
    this.setLimits(...limits);
    const value = Math.min(limits[1], Math.max(limits[0], this.value));
    if (value === this.value) { this.set(value); return; }
    this.set(value);
    this.changed(this, true);
  }

  set(value) {
    this.value = value;
    if (value < +this.slider.min || value > +this.slider.max) {
      this.setLimits(Math.min(value, +this.slider.min), Math.max(value, +this.slider.max));
    }
    this.slider.value = value;
    this.print();
  }

  reset() {
    this.setLimits(...this.limits);
    this.set(this.start);
  }

  print() { this.field.value = fitting(this.value, 6); }
}

// The column of names is as wide as the longest of them. Those of a folded list have no width before it is opened.
function fitNames() {
  const widths = [...document.querySelectorAll(".control .name")].map((name) => name.scrollWidth);
  document.documentElement.style.setProperty("--names", `${Math.max(0, ...widths)}px`);
}

// A number with as many digits as a field has room for; its own value is kept elsewhere.
function fitting(value, digits) {
  for (let count = digits; count > 2; count--) {
    const text = String(+value.toPrecision(count));
    if (text.length <= FIELD) return text;
  }
  return String(+value.toPrecision(3)).includes("e") ? String(+value.toPrecision(2)) : (+value.toPrecision(3)).toExponential();
}
const FIELD = 9; // letters

const short = (value) => fitting(value, 4);

const around = (value, least) => { const reach = Math.max(least, Math.abs(value)); return { low: value - reach, high: value + reach }; };

function rangeOf(value, positive) {
  if (positive) return { low: 0.1 * value, high: 3 * value };
  return around(value, 1);
}
