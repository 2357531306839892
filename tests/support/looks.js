// What a reader of the page would complain about, each as a sentence: text that overlaps, is cut off or is faint, and
// what is wider than the window. The text on canvases is what looks_before.js kept.
(() => {
  const ROOM = 2; // [pixel] of an overlap that nobody sees
  const LEAST_CONTRAST = 4.5;
  const found = new Set();
  const brief = (text) => JSON.stringify(text.trim().replace(/\s+/g, " ").slice(0, 60));
  const say = (kind, text, more = "") => found.add([`${kind}:`, brief(text), more].join(" ").trim());
  const width = document.documentElement.clientWidth;
  for (const part of document.querySelectorAll("details")) part.open = true;

  // What is asked of each element, once.
  const known = new Map();
  function facts(element) {
    if (!known.has(element)) {
      const style = getComputedStyle(element);
      known.set(element, {
        box: element.getBoundingClientRect(), colour: element instanceof SVGElement ? style.fill : style.color, opacity: +style.opacity,
        ground: style.backgroundColor, picture: style.backgroundImage !== "none", position: style.position,
        overflow: style.display === "inline" ? ["visible", "visible"] : [style.overflowX, style.overflowY],
      });
    }
    return known.get(element);
  }
  const chain = (element) => { const all = []; for (let one = element; one; one = one.parentElement) all.push(one); return all; };
  const cuts = (overflow) => ["hidden", "clip"].includes(overflow);
  const scrolls = (overflow) => ["auto", "scroll"].includes(overflow);
  const isParked = (element) => chain(element).some((one) => ["fixed", "absolute"].includes(facts(one).position));
  const isRead = (element) => element.checkVisibility({ contentVisibilityAuto: true, opacityProperty: true, visibilityProperty: true })
    && !chain(element).some((one) => cuts(facts(one).overflow[0]) && facts(one).box.width <= 1 && facts(one).box.height <= 1); // for screen readers

  // A colour in any notation as [r, g, b, alpha].
  const probe = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true });
  const colours = new Map();
  function rgba(text) {
    if (!colours.has(text)) {
      probe.clearRect(0, 0, 1, 1);
      probe.fillStyle = text;
      probe.fillRect(0, 0, 1, 1);
      const [r, g, b, alpha] = probe.getImageData(0, 0, 1, 1).data;
      colours.set(text, [r, g, b, alpha / 255]);
    }
    return [...colours.get(text)];
  }
  const over = ([r, g, b, alpha], below) => [r, g, b].map((one, k) => alpha * one + (1 - alpha) * below[k]);
  const light = (colour) => colour.map((one) => one / 255).map((one) => (one <= 0.04045 ? one / 12.92 : ((one + 0.055) / 1.055) ** 2.4))
    .reduce((sum, one, k) => sum + [0.2126, 0.7152, 0.0722][k] * one, 0);
  function contrast(one, two) {
    const [low, high] = [light(one), light(two)].sort((a, b) => a - b);
    return (high + 0.05) / (low + 0.05);
  }

  // The colour behind an element; null over a picture.
  function ground(element) {
    const layers = [];
    for (const one of chain(element)) {
      if (facts(one).picture) return null;
      layers.push(rgba(facts(one).ground));
      if (layers.at(-1)[3] === 1) break;
    }
    const dark = matchMedia("(prefers-color-scheme: dark)").matches && getComputedStyle(document.documentElement).colorScheme.includes("dark");
    return layers.reverse().reduce((below, layer) => over(layer, below), dark ? [18, 18, 18] : [255, 255, 255]);
  }

  function checkContrast(text, element, colour = facts(element).colour) {
    const below = ground(element), own = rgba(colour);
    if (!below) return;
    own[3] *= chain(element).reduce((part, one) => part * facts(one).opacity, 1);
    const ratio = contrast(over(own, below), below);
    if (ratio < LEAST_CONTRAST) say("faint", text, `(${ratio.toFixed(1)} to 1)`);
  }

  // What is left of a box within the parts that scroll; null where that is nothing. What is cut off for good is a fault.
  function inSight(box, element, text) {
    let left = box;
    for (const one of chain(element)) {
      const { box: around, overflow, position } = facts(one);
      if (one === document.body || one === document.documentElement) break;
      const beyond = [left[0] < around.left - 1 || left[2] > around.right + 1, left[1] < around.top - 1 || left[3] > around.bottom + 1];
      if (!(one instanceof SVGElement) && beyond.some((yes, k) => yes && cuts(overflow[k]))) { say("cut off", text); return null; }
      if (overflow.some(scrolls)) {
        left = [Math.max(left[0], around.left), Math.max(left[1], around.top), Math.min(left[2], around.right), Math.min(left[3], around.bottom)];
        if (left[2] - left[0] < 1 || left[3] - left[1] < 1) return null;
      }
      if (position === "fixed") break;
    }
    return left;
  }

  const boxOf = ({ left, top, right, bottom }) => [left, top, right, bottom];

  // Each line of text, and each formula, as { text, box, element }.
  function* pieces() {
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), formulas = new Set();
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const element = node.parentElement, text = node.nodeValue;
      if (!text.trim() || ["SCRIPT", "STYLE", "NOSCRIPT", "OPTION"].includes(element.tagName) || !isRead(element)) continue;
      const formula = element.closest("math"), range = document.createRange();
      if (formulas.has(formula)) continue;
      if (formula) formulas.add(formula);
      range.selectNodeContents(node);
      const boxes = (formula ? [formula.getBoundingClientRect()] : [...range.getClientRects()]).filter((box) => box.width > 1 && box.height > 1);
      if (isParked(element) && boxes.every((box) => box.right <= 0 || box.left >= width)) continue; // a drawer that is shut
      for (const box of boxes) yield { text: formula ? formula.textContent : text, box: boxOf(box), element };
    }
  }

  function lines() {
    const all = [];
    for (const { text, box, element } of pieces()) {
      checkContrast(text, element);
      const left = inSight(box, element, text);
      if (!left) continue;
      if (left[0] < -1 || left[2] > width + 1) say("outside the window", text);
      all.push({ text, box: left, element });
    }
    return all;
  }

  function isCrossing(a, b) {
    const across = Math.min(a[2], b[2]) - Math.max(a[0], b[0]), down = Math.min(a[3], b[3]) - Math.max(a[1], b[1]);
    return across > ROOM && down > ROOM + 0.15 * Math.min(a[3] - a[1], b[3] - b[1]);
  }
  function checkOverlaps(all) {
    const sorted = [...all].sort((a, b) => a.box[1] - b.box[1]);
    sorted.forEach((one, k) => {
      for (let j = k + 1; j < sorted.length && sorted[j].box[1] < one.box[3]; j++) {
        if (isCrossing(one.box, sorted[j].box)) say("overlap", one.text, `and ${brief(sorted[j].text)}`);
      }
    });
  }

  function checkFields() {
    for (const field of document.querySelectorAll("input:not([type=range], [type=checkbox], [type=radio], [type=hidden]), select")) {
      if (!isRead(field) || isParked(field)) continue;
      checkContrast(field.value, field);
      if (field.tagName === "INPUT" && field.scrollWidth > field.clientWidth + 1) say("cut off", field.value, `in the field "${field.ariaLabel ?? field.name}"`);
    }
  }

  function checkBoxes() {
    for (const one of document.querySelectorAll("img, canvas, svg, iframe, table, pre, button, input, select")) {
      if (one.tagName === "IMG" && one.complete && !one.naturalWidth) say("no picture", one.src);
      const { box } = facts(one), isInDrawing = one.parentElement.closest("svg");
      if (!box.width || isInDrawing || isParked(one) || chain(one).slice(1).some((outer) => scrolls(facts(outer).overflow[0]))) continue;
      if (box.left < -1 || box.right > width + 1) say("outside the window", `<${one.tagName.toLowerCase()}> ${one.alt ?? one.title ?? ""}`);
    }
  }

  function checkCanvases() {
    for (const canvas of document.querySelectorAll("canvas")) {
      checkOverlaps(canvas.written ?? []);
      for (const { text, box, colour } of canvas.written ?? []) {
        checkContrast(text, canvas, colour);
        if (box[0] < -0.5 || box[1] < -0.5 || box[2] > canvas.width + 0.5 || box[3] > canvas.height + 0.5) say("cut off", text, "in a plot");
      }
    }
  }

  const wider = document.documentElement.scrollWidth - width;
  if (wider > 0) say("wider than the window", document.title, `by ${wider} pixels`);
  checkOverlaps(lines());
  checkFields();
  checkBoxes();
  checkCanvases();
  return [...found];
})()
