// player.js: playback of time at a chosen speed, with pause and seek.

class Player {
  constructor(parts, show) {
    Object.assign(this, { parts, show, t: 0, last: 0, playing: false, before: null, rest: 0 });
    parts.play.addEventListener("click", () => this.toggle());
    parts.scrub.addEventListener("input", () => { const t = +parts.scrub.value; this.pause(); this.seek(t); });
    requestAnimationFrame((now) => this.tick(now));
  }

  get speed() { return +this.parts.speed.value; }

  toggle() { if (this.playing) this.pause(); else this.play(); }

  play() {
    if (this.t >= this.last) this.t = 0;
    this.playing = true;
    this.print();
  }

  pause() {
    this.playing = false;
    this.print();
  }

  seek(t) {
    this.t = Math.max(0, Math.min(this.last, t));
    this.rest = 0;
    this.print();
    this.show(this.t);
  }

  setEnd(last) {
    this.last = last;
    this.parts.scrub.max = last;
    this.seek(Math.min(this.t, last));
  }

  tick(now) {
    const passed = this.before === null ? 0 : Math.min(0.1, (now - this.before) / 1000);
    this.before = now;
    if (this.playing) this.advance(passed);
    requestAnimationFrame((next) => this.tick(next));
  }

  // At the end, pause for a moment, then start again.
  advance(seconds) {
    if (this.t < this.last) {
      this.t = Math.min(this.last, this.t + seconds * this.speed);
    } else if ((this.rest += seconds) > 0.8) {
      this.rest = 0;
      this.t = 0;
    }
    this.print();
    this.show(this.t);
  }

  print() {
    this.parts.play.classList.toggle("playing", this.playing);
    this.parts.play.setAttribute("aria-label", this.playing ? "pause" : "play");
    this.parts.scrub.value = this.t;
    this.parts.scrub.setAttribute("aria-valuetext", `${this.t.toFixed(2)} seconds`);
    this.parts.clock.textContent = `${this.t.toFixed(2)} ${about.time}`;
  }
}
