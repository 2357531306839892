// Before the scripts of a page: each canvas keeps what is written on it, { text, box, colour }, in `written`.
(() => {
  const brush = CanvasRenderingContext2D.prototype, { fillText, clearRect, drawImage } = brush;
  brush.fillText = function (text, x, y, ...more) {
    const size = this.measureText(text), by = this.getTransform();
    const corners = [
      [x - size.actualBoundingBoxLeft, y - size.actualBoundingBoxAscent], [x + size.actualBoundingBoxRight, y - size.actualBoundingBoxAscent],
      [x - size.actualBoundingBoxLeft, y + size.actualBoundingBoxDescent], [x + size.actualBoundingBoxRight, y + size.actualBoundingBoxDescent],
    ].map(([a, b]) => by.transformPoint({ x: a, y: b }));
    const [across, down] = [corners.map((one) => one.x), corners.map((one) => one.y)];
    const box = [Math.min(...across), Math.min(...down), Math.max(...across), Math.max(...down)];
    (this.canvas.written ??= []).push({ text: String(text), box, colour: this.fillStyle });
    return fillText.call(this, text, x, y, ...more);
  };
  brush.clearRect = function (...area) { this.canvas.written = []; return clearRect.apply(this, area); };
  brush.drawImage = function (image, ...place) {
    if (image.written) this.canvas.written = [...(this.canvas.written ?? []), ...image.written];
    return drawImage.call(this, image, ...place);
  };
})();
