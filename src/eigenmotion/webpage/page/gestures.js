// gestures.js: pointer gestures: one finger or the mouse drags, two fingers or the wheel zoom.

function gestures(element, { drag, zoom }) {
  const pointers = new Map();
  const place = (event) => { const box = element.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
  const spread = () => { const [[ax, ay], [bx, by]] = [...pointers.values()]; return [Math.hypot(ax - bx, ay - by), (ax + bx) / 2, (ay + by) / 2]; };
  element.addEventListener("pointerdown", (event) => {
    pointers.set(event.pointerId, place(event));
    element.setPointerCapture(event.pointerId);
  });
  element.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const now = place(event);
    if (pointers.size === 1) {
      pointers.set(event.pointerId, now);
      drag(now[0] - before[0], now[1] - before[1], event.shiftKey || event.buttons === 2);
    } else if (pointers.size === 2) {
      const [length] = spread();
      pointers.set(event.pointerId, now);
      const [longer, x, y] = spread();
      if (length > 0) zoom(longer / length, x, y);
    }
  });
  for (const end of ["pointerup", "pointercancel"]) element.addEventListener(end, (event) => pointers.delete(event.pointerId));
  element.addEventListener("contextmenu", (event) => event.preventDefault());
  element.addEventListener("wheel", (event) => {
    if (embedded && !event.ctrlKey) return; // the page around the frame scrolls
    event.preventDefault();
    zoom(Math.exp(-event.deltaY * 0.0015), ...place(event));
  }, { passive: false });
}
