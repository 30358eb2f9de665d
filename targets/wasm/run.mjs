// node run.mjs MODULE.wasm SCENE.fxl FROM TO BAND_ROWS [FILE]
//
// Renders frames with the WebAssembly module and prints the same lines as the
// measuring firmware; `count` is in nanoseconds. The RGB565 bytes go to FILE.
import { closeSync, openSync, readFileSync, writeSync } from "node:fs";

const [modulePath, scenePath, ...rest] = process.argv.slice(2);
const [from, to, rows] = rest.slice(0, 3).map(Number);
if (![from, to, rows].every(Number.isInteger)) {
  console.error("usage: run.mjs MODULE.wasm SCENE.fxl FROM TO BAND_ROWS [FILE]");
  process.exit(2);
}
const picture = rest[3] === undefined ? null : openSync(rest[3], "w");

let memory;
const bytes = (address, length) => new Uint8Array(memory.buffer, address, length);
const host = {
  print: (address, length) => writeSync(1, bytes(address, length)),
  show: (address, length) => {
    if (picture !== null) writeSync(picture, bytes(address, length));
  },
  now: () => Math.round(performance.now() * 1e6),
};
const { instance } = await WebAssembly.instantiate(readFileSync(modulePath), { host });
memory = instance.exports.memory;

const scene = readFileSync(scenePath);
const place = instance.exports.scene(scene.length);
if (place === 0) {
  console.error("the scene is larger than the memory kept for it");
  process.exit(1);
}
bytes(place, scene.length).set(scene);
const failed = instance.exports.render(scene.length, from, to, rows);
if (picture !== null) closeSync(picture);
process.exit(failed);
