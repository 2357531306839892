// engine.js: the compiled model: sets its arguments and returns a Motion.

const STATUS_DEPENDENT_ROWS = 6;
const ROWS_A_SECOND = 100;
const MOST_ROWS = 4001;
const SECONDS_A_RUN = 4;

async function unpacked(base64) {
  const packed = Uint8Array.from(atob(base64.trim()), (char) => char.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

const unpackedText = async (id) => new TextDecoder().decode(await unpacked(element(id).textContent));

class Engine {
  static async open(base64, about) {
    let memory = null;
    const clock = (_id, _precision, out) => {
      new DataView(memory.buffer).setBigUint64(out, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    };
    const calls = new Proxy({ clock_time_get: clock }, { get: (known, name) => known[name] ?? (() => 52) });
    const { instance } = await WebAssembly.instantiate(await unpacked(base64), { wasi_snapshot_preview1: calls });
    memory = instance.exports.memory;
    instance.exports._initialize();
    if (instance.exports.open() !== 0) throw new Error("there is no memory for the model");
    return new Engine(instance.exports, about);
  }

  constructor(calls, about) {
    this.calls = calls;
    this.about = about;
    this.leastNorm = 0;
  }

  numbers(place, count) {
    return new Float64Array(this.calls.memory.buffer, place, count);
  }

  get parameters() { return this.numbers(this.calls.parameters(), this.about.parameters.length); }
  get inputs() { return this.numbers(this.calls.inputs(), this.about.inputs.length); }
  get x() { return this.numbers(this.calls.x(), this.about.n); }
  get v() { return this.numbers(this.calls.v(), this.about.n); }

  // Project the start onto the constraints; return a status. Dependent rows get multipliers of least norm. If the
  // projection fails, the start is unchanged.
  settle() {
    const x = Array.from(this.x), v = Array.from(this.v);
    for (this.leastNorm = 0; ; this.leastNorm = 1) {
      const status = this.calls.settle(this.leastNorm);
      if (status === 0) return 0;
      this.x.set(x);
      this.v.set(v);
      if (this.leastNorm || status !== STATUS_DEPENDENT_ROWS) return status;
    }
  }

  run(tEnd) {
    const rows = Math.min(MOST_ROWS, Math.max(2, Math.ceil(tEnd * ROWS_A_SECOND) + 1));
    const began = performance.now();
    const { rtol, atol } = this.about;
    const status = this.calls.run(tEnd, rtol, atol, rows, this.leastNorm, SECONDS_A_RUN);
    const width = this.calls.width();
    const table = this.numbers(this.calls.table(), width * this.calls.rows()).slice();
    return new Motion(this.about, table, width, {
      status,
      coordinate: this.calls.fault_first(),
      reached: this.calls.reached(),
      steps: this.calls.steps(),
      rhs: this.calls.rhs_calls(),
      milliseconds: performance.now() - began,
      leastNorm: this.leastNorm,
    });
  }
}
