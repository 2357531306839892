// Charts of a report: the run under the pointer, or that to which arrow keys lead, in the panel below.
"use strict";
for (const section of document.querySelectorAll(".model")) {
  const runs = JSON.parse(section.querySelector(".runs").textContent);
  for (const charts of section.querySelectorAll(".charts")) {
    for (const chart of charts.querySelectorAll("svg.chart")) attend(chart, charts.querySelector(".panel"), runs);
  }
}

function attend(chart, panel, runs) {
  const curves = [...chart.querySelectorAll(".curve")].map((curve) => [...curve.querySelectorAll(".point")].map((point) =>
    ({ curve, run: runs[point.dataset.run], x: point.cx.baseVal.value, y: point.cy.baseVal.value,
       best: point.previousElementSibling?.matches(".best") })));
  const points = curves.flat();
  let at = null;

  function show(point) {
    at = point;
    chart.classList.add("pointed");
    for (const curve of chart.querySelectorAll(".curve")) curve.classList.toggle("near", curve === point.curve);
    const cursor = chart.querySelector(".cursor");
    cursor.setAttribute("cx", point.x);
    cursor.setAttribute("cy", point.y);
    panel.querySelector("strong").textContent = point.run.label + (point.best ? ", recommended" : "");
    for (const place of panel.querySelectorAll("dd")) place.textContent = point.run[place.dataset.name];
  }

  function leave() {
    chart.classList.remove("pointed");
    for (const curve of chart.querySelectorAll(".near")) curve.classList.remove("near");
  }

  function nearest(x, y, among) {
    return among.reduce((best, point) => (Math.hypot(point.x - x, point.y - y) < Math.hypot(best.x - x, best.y - y) ? point : best));
  }

  function pointed(event) {
    const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(chart.getScreenCTM().inverse());
    const label = event.target.closest(".label")?.parentNode;
    if (points.length) show(nearest(place.x, place.y, label ? points.filter((point) => point.curve === label) : points));
  }

  function step(key) {
    const line = curves.findIndex((curve) => curve.includes(at)), k = curves[line].indexOf(at);
    if (key === "ArrowLeft" || key === "ArrowRight") return curves[line][k + (key === "ArrowRight" ? 1 : -1)] ?? at;
    const others = curves.filter((curve) => curve.length);
    const beside = others[(others.indexOf(curves[line]) + (key === "ArrowDown" ? 1 : -1) + others.length) % others.length];
    return beside.reduce((best, point) => (Math.abs(point.x - at.x) < Math.abs(best.x - at.x) ? point : best));
  }

  for (const kind of ["pointermove", "pointerdown"]) chart.addEventListener(kind, pointed);
  chart.addEventListener("pointerleave", leave);
  chart.addEventListener("focus", () => { if (points.length) show(at ?? points.find((point) => point.best) ?? points[0]); });
  chart.addEventListener("blur", leave);
  chart.addEventListener("keydown", (event) => {
    if (!event.key.startsWith("Arrow") || !points.length) return;
    event.preventDefault();
    show(at ? step(event.key) : points[0]);
  });
}
