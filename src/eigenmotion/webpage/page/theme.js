// theme.js: the colours of the style sheet, for canvases; read again when the colour scheme changes.

const COLOURS = ["ink", "faint", "grid", "bar", "line", "wheel", "wheelEdge", "face", "faceEdge", "floor", "floorEdge",
  "ball", "ballEdge", "path", "series1", "series2", "series3", "series4", "series5", "series6"];
let colours = null;

function theme() {
  if (!colours) {
    const style = getComputedStyle(document.documentElement);
    colours = Object.fromEntries(COLOURS.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  }
  return colours;
}

function onTheme(then) {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { colours = null; then(); });
}
