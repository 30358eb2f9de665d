// The panels that firmware talks to: each takes commands and data, byte by byte, as its
// controller does, and hands over its picture when the last pixel of a frame is there.
//
// A panel has `width`, `height` and `picture()`: the bytes of what is seen, for colour
// RGB565 with the high byte first, else a byte a pixel, 0 or 1. What a real panel would not
// do right is an error.

/** Big-endian numbers of 16 bits. */
const words = (bytes) => [(bytes[0] << 8) | bytes[1], (bytes[2] << 8) | bytes[3]];

/** ST7789 with glass of 240 columns and up to 320 rows. */
export class St7789 {
  constructor(width, height, shown) {
    Object.assign(this, { width, height, shown });
    this.memory = new Uint8Array(width * height * 2);
    this.columns = [0, 239];
    this.rows = [0, 319];
    this.onItsSide = false;
    this.awake = false;
    this.on = false;
    this.format = 0x66;
    this.inverted = false;
    this.command = null;
  }

  take(byte, isData) {
    if (!isData) {
      this.command = byte;
      this.data = [];
      if (byte === 0x11) this.awake = true;
      if (byte === 0x21) this.inverted = true;
      if (byte === 0x29) this.on = true;
      if (byte === 0x2c) {
        this.place = [this.columns[0], this.rows[0]];
        if (!this.awake || this.format !== 0x55) throw Error("pixels before the panel is set up");
      }
      return;
    }
    if (this.command === 0x2c || this.command === 0x3c) return this.pixel(byte);
    this.data.push(byte);
    if (this.command === 0x3a) this.format = byte;
    if (this.command === 0x36) this.onItsSide = (byte & 0x20) !== 0;
    if (this.data.length !== 4) return;
    const [limit_x, limit_y] = this.onItsSide ? [320, 240] : [240, 320];
    const [first, last] = words(this.data);
    const limit = { 0x2a: limit_x, 0x2b: limit_y }[this.command];
    if (limit === undefined) return;
    if (first > last || last >= limit) throw Error(`window ${first}..=${last} of ${limit}`);
    if (this.command === 0x2a) this.columns = [first, last];
    else this.rows = [first, last];
  }

  pixel(byte) {
    this.data.push(byte);
    if (this.data.length < 2) return;
    const [x, y] = this.place;
    if (x < this.width && y < this.height) this.memory.set(this.data, (y * this.width + x) * 2);
    this.data = [];
    this.place = [x + 1, y];
    if (x === this.columns[1]) this.place = [this.columns[0], y === this.rows[1] ? this.rows[0] : y + 1];
    if (x === this.width - 1 && y === this.height - 1) this.shown(this);
  }

  picture() {
    if (!this.on || !this.inverted) throw Error("the panel is not on");
    return this.memory;
  }
}

/** How many bytes follow a command of the SSD1306. */
const SSD1306_LENGTHS = {
  0x20: 1, 0x21: 2, 0x22: 2, 0x81: 1, 0x8d: 1, 0xa8: 1, 0xd3: 1, 0xd5: 1, 0xd9: 1, 0xda: 1, 0xdb: 1,
};

/** SSD1306 with glass of 128x64. */
export class Ssd1306 {
  constructor(shown) {
    Object.assign(this, { width: 128, height: 64, shown });
    this.memory = new Uint8Array(128 * 8);
    this.settings = new Map();
    this.pending = [];
    this.columns = [0, 127];
    this.pages = [0, 7];
    this.place = [0, 0];
    this.on = false;
    this.turned = [false, false];
  }

  take(byte, isData) {
    if (isData) return this.pixels(byte);
    this.pending.push(byte);
    const [command, ...values] = this.pending;
    if (values.length < (SSD1306_LENGTHS[command] ?? 0)) return;
    this.pending = [];
    this.settings.set(command, values);
    if (command === 0x21) this.columns = values;
    if (command === 0x22) this.pages = values;
    if (command === 0x21 || command === 0x22) this.place = [this.columns[0], this.pages[0]];
    if (command === 0xaf || command === 0xae) this.on = command === 0xaf;
    if ((command & 0xfe) === 0xa0) this.turned[0] = (command & 1) !== 0;
    if ((command & 0xf0) === 0xc0) this.turned[1] = (command & 8) !== 0;
  }

  pixels(byte) {
    if (this.settings.get(0x20)?.[0] !== 0) throw Error("not addressed along pages");
    const [x, page] = this.place;
    this.memory[page * 128 + x] = byte;
    this.place = [x + 1, page];
    if (x === this.columns[1]) this.place = [this.columns[0], page === this.pages[1] ? this.pages[0] : page + 1];
    if (x === 127 && page === 7) this.shown(this);
  }

  picture() {
    if (!this.on || this.settings.get(0x8d)?.[0] !== 0x14) throw Error("the panel is not on");
    // As modules are made, both ways turned is upright.
    const [across, down] = this.turned;
    const at = (x, y) => {
      const [column, row] = [across ? x : 127 - x, down ? y : 63 - y];
      return (this.memory[(row >> 3) * 128 + column] >> (row & 7)) & 1;
    };
    return Uint8Array.from({ length: 128 * 64 }, (_, i) => at(i % 128, i >> 7));
  }
}

/** SSD1680 with e-paper of 128 sources and 296 gates, seen lying on its side. */
export class Ssd1680 {
  /** `busy` is called with whether it is, and how long it will be. */
  constructor(shown, busy) {
    Object.assign(this, { width: 296, height: 128, shown, busy });
    // By gates, the first source in the highest bit.
    this.fresh = new Uint8Array(296 * 16);
    this.old = new Uint8Array(296 * 16);
    this.paper = new Uint8Array(296 * 16);
    this.x = [0, 15];
    this.y = [0, 295];
    this.place = [0, 0];
    this.isBusy = false;
    this.whole = 0;
    this.partial = 0;
    this.command = null;
  }

  take(byte, isData) {
    if (this.isBusy) throw Error("spoken to while busy");
    if (!isData) {
      this.command = byte;
      this.data = [];
      if (byte === 0x12) this.rest(1e6);
      if (byte === 0x20) this.update();
      return;
    }
    if (this.command === 0x24) return this.pixels(this.fresh, byte);
    if (this.command === 0x26) return this.pixels(this.old, byte);
    this.data.push(byte);
    const [a, b, c, d] = this.data;
    const length = this.data.length;
    if (this.command === 0x01 && length === 3) this.gates = (a | (b << 8)) + 1;
    if (this.command === 0x11) this.entry = a;
    if (this.command === 0x22) this.steps = a;
    if (this.command === 0x44 && length === 2) this.x = [a, b];
    if (this.command === 0x45 && length === 4) this.y = [a | (b << 8), c | (d << 8)];
    if (this.command === 0x4e) this.place[0] = a;
    if (this.command === 0x4f && length === 2) this.place[1] = a | (b << 8);
  }

  pixels(memory, byte) {
    const [x, y] = this.place;
    if (x > 15 || y > 295) throw Error(`address ${x}, ${y}`);
    memory[y * 16 + x] = byte;
    // Along y if so chosen, up or down, then a step along x.
    const step = [this.entry & 1 ? 1 : -1, this.entry & 2 ? 1 : -1];
    const order = this.entry & 4 ? [1, 0] : [0, 1];
    for (const axis of order) {
      const [first, last] = axis === 0 ? this.x : this.y;
      if (this.place[axis] !== last) {
        this.place[axis] += step[axis];
        return;
      }
      this.place[axis] = first;
    }
  }

  update() {
    if (this.gates !== 296) throw Error(`${this.gates} gates`);
    if (this.steps === 0xf7) {
      this.paper.set(this.fresh);
      this.whole += 1;
    } else if (this.steps === 0xff) {
      // Only pixels that differ from the old picture move, and it has to be the one on paper.
      this.paper.forEach((byte, i) => {
        if (byte !== this.old[i]) throw Error("the old picture is not what is on the paper");
      });
      this.paper.set(this.fresh);
      this.partial += 1;
    } else {
      throw Error(`update by ${this.steps}`);
    }
    this.shown(this);
    this.rest(5e6);
  }

  /** Busy for so many nanoseconds: shorter than paper is, to spare the emulator's time. */
  rest(nanoseconds) {
    this.isBusy = true;
    this.busy(true);
    this.wake(nanoseconds, () => {
      this.isBusy = false;
      this.busy(false);
    });
  }

  picture() {
    // The gates go to the right, the sources up.
    const at = (column, row) => {
      const source = 127 - row;
      return (this.paper[column * 16 + (source >> 3)] >> (7 - (source & 7))) & 1;
    };
    return Uint8Array.from({ length: 296 * 128 }, (_, i) => at(i % 296, Math.floor(i / 296)));
  }
}
