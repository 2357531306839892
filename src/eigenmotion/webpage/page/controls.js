// controls.js: a slider and a number field for each parameter, input and initial value.

class Control {
  constructor(parent, { name, label, unit, value, low, high }, changed) {
    this.start = value;
    const row = document.createElement("label");
    row.className = about.measured ? "control measured" : "control";
    row.innerHTML = `<span class="name">${label}</span><input type="range" step="any"><input type="number" step="any">${about.measured ? `<span class="unit">${plain(unit)}</span>` : ""}`;
    [this.slider, this.field] = row.querySelectorAll("input");
    for (const input of [this.slider, this.field]) {
      input.setAttribute("aria-label", name);
      input.dataset.name = name;
    }
    this.slider.min = low;
    this.slider.max = high;
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

  set(value) {
    this.value = value;
    if (value < +this.slider.min) this.slider.min = value;
    if (value > +this.slider.max) this.slider.max = value;
    this.slider.value = value;
    this.print();
  }

  print() { this.field.value = +this.value.toPrecision(6); }
}

const around = (value, least) => { const reach = Math.max(least, Math.abs(value)); return { low: value - reach, high: value + reach }; };

function rangeOf(value, positive) {
  if (positive) return { low: 0.1 * value, high: 3 * value };
  return around(value, 1);
}
