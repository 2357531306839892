// embedded.js: the height of a page in a frame, for the page around it.

// Messages are { eigenmotion: "height", height }, in CSS pixels, at the start and whenever the height changes.
function reportHeight() {
  let told = 0;
  new ResizeObserver(() => {
    const height = Math.ceil(document.body.getBoundingClientRect().height);
    if (height !== told) parent.postMessage({ eigenmotion: "height", height }, "*");
    told = height;
  }).observe(document.body);
}
