// node run.mjs MODULES FIRMWARE.elf PANEL FRAMES OUT [BUTTON=FROM..TO ...]
//
// Runs a firmware until its panel has shown so many frames, whose pictures go to the file
// OUT one after the other. MODULES is a folder with node_modules. PANEL is st7789, square,
// ssd1306 or epaper. A button (left, right, stop) is pressed from before frame FROM until
// before frame TO, counted from 0.
//
// Prints what the firmware says over its serial line, and for each frame a line with the
// bytes that the panel got and the processor's cycles that the bus took for them.
import { closeSync, openSync, readFileSync, writeSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { Ssd1306, Ssd1680, St7789 } from "./panels.mjs";

const [modules, elfPath, panelName, frameCount, outPath, ...presses] = process.argv.slice(2);
const require = createRequire(resolve(modules, "package.json"));
const { ConsoleLogger, GPIOPinState, LogLevel, RP2040 } = require("rp2040js");

// The pins, as the firmware's README has them.
const PINS = { data: 16, select: 17, reset: 21, busy: 22, left: 12, right: 13, stop: 14 };
const RAM_END = 0x20042000;
// Emulated seconds after which a firmware hangs.
const LIMIT = 20;

const fail = (message) => {
  console.log(JSON.stringify({ error: message }));
  process.exit(1);
};

const chip = new RP2040();
const { clock } = chip;
let warnings = 0;
const logger = new ConsoleLogger(LogLevel.Warn, false);
for (const level of ["warn", "error"]) {
  const log = logger[level].bind(logger);
  logger[level] = (...what) => {
    warnings += 1;
    if (warnings <= 20) log(...what);
  };
}
chip.logger = logger;

/** Copies what an ELF file loads into flash. */
function load(elf) {
  if (elf.readUInt32BE(0) !== 0x7f454c46) fail("not an ELF file");
  const [offset, size, count] = [elf.readUInt32LE(28), elf.readUInt16LE(42), elf.readUInt16LE(44)];
  for (let i = 0; i < count; i++) {
    const word = (n) => elf.readUInt32LE(offset + i * size + n * 4);
    const [kind, from, , physical, bytes] = [word(0), word(1), word(2), word(3), word(4)];
    if (kind !== 1 || bytes === 0) continue;
    chip.flash.set(elf.subarray(from, from + bytes), physical - 0x10000000);
  }
}

const out = openSync(outPath, "w");
let frames = 0;
let bytes = 0;
let busCycles = 0;
const shown = (panel) => {
  writeSync(out, panel.picture());
  console.log(JSON.stringify({ shown: frames, bytes, sending: Math.round(busCycles) }));
  frames += 1;
  bytes = 0;
  busCycles = 0;
};

const panel = {
  st7789: () => new St7789(320, 240, shown),
  square: () => new St7789(240, 240, shown),
  ssd1306: () => new Ssd1306(shown),
  epaper: () => new Ssd1680(shown, (isBusy) => chip.gpio[PINS.busy].setInputValue(isBusy)),
}[panelName]?.();
if (panel === undefined) fail(`no panel is called ${panelName}`);
panel.wake = (nanoseconds, then) => clock.createAlarm(then).schedule(nanoseconds);

// A byte takes as long as the bus's clock says, and the panel sees its pins as they are when
// the last bit is there.
const spi = chip.spi[0];
let word = 0;
const isHigh = (pin) => chip.gpio[pin].value === GPIOPinState.High;
const sent = clock.createAlarm(() => {
  if (isHigh(PINS.select)) fail(`byte ${bytes} came when the panel was not selected any more`);
  if (!isHigh(PINS.reset)) fail("a byte during reset");
  bytes += 1;
  try {
    panel.take(word, isHigh(PINS.data));
  } catch (error) {
    fail(`panel: ${error.message}`);
  }
  spi.completeTransmit(0);
});
spi.onTransmit = (value) => {
  word = value;
  const seconds = spi.dataBits / spi.clockFrequency;
  busCycles += seconds * chip.clkSys;
  sent.schedule(seconds * 1e9);
};

const schedule = presses.map((press) => {
  const [, name, from, to] = press.match(/^(left|right|stop)=(\d+)\.\.(\d+)$/) ?? fail(`not a press: ${press}`);
  return { pin: PINS[name], from: Number(from), to: Number(to) };
});
const press = (frame) => {
  for (const name of ["left", "right", "stop"]) {
    const pin = PINS[name];
    // To ground.
    const isPressed = schedule.some((s) => s.pin === pin && s.from <= frame && frame < s.to);
    chip.gpio[pin].setInputValue(!isPressed);
  }
};

// Lines of the firmware: one about each frame that it has drawn, and others.
let line = "";
let reports = 0;
chip.uart[0].onByte = (byte) => {
  if (byte !== 10) {
    line += String.fromCharCode(byte);
    return;
  }
  console.log(line);
  if (line.startsWith('{"error"')) process.exit(1);
  if (line.startsWith('{"frame"')) {
    reports += 1;
    press(reports);
  }
  line = "";
};

load(readFileSync(elfPath));
press(0);
chip.gpio[PINS.busy].setInputValue(false);
// The boot ROM and the second stage are passed over.
const core = chip.core;
core.VTOR = 0x10000100;
core.SP = chip.flashView.getUint32(0x100, true);
core.PC = chip.flashView.getUint32(0x104, true) & ~1;

const wanted = Number(frameCount);
while (frames < wanted || reports < wanted) {
  if (core.waiting) {
    const next = clock.nanosToNextAlarm;
    if (next <= 0) fail("waits for nothing");
    clock.tick(next);
  } else {
    const cycles = core.executeInstruction();
    clock.tick((cycles * 1e9) / chip.clkSys);
  }
  const at = core.PC;
  if (!(at >= 0x10000000 && at < 0x10200000) && !(at >= 0x20000000 && at < RAM_END)) {
    fail(`the program left its memory, for 0x${at.toString(16)}`);
  }
  if (clock.nanos > LIMIT * 1e9) fail(`only ${frames} frames in ${LIMIT} s`);
}
closeSync(out);
console.log(JSON.stringify({ system: chip.clkSys, spi: spi.clockFrequency, warnings }));
process.exit(0);
