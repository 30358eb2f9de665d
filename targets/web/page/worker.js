// The core, in a thread of its own so that the page stays alive while it bakes and draws.
//
// In: { id, what, input }, `what` as Session::call has it, `input` text or bytes; the first
// message is the module's bytes, compressed. Out: { id, done, text, bytes }.
"use strict";

let module;
let core;
let failure = "";

const within = (address, length) => new Uint8Array(core.memory.buffer, address, length);
const decoded = (address, length) => new TextDecoder().decode(within(address, length));

async function start() {
  const page = { failed: (address, length) => { failure = decoded(address, length); } };
  core = (await WebAssembly.instantiate(module, { page })).exports;
  core.start();
}

function call(what, input) {
  const given = typeof input === "string" ? new TextEncoder().encode(input) : input;
  const room = core.room(given.length);
  within(room, given.length).set(given);
  const done = core.call(what) === 1;
  const text = decoded(core.text(), core.text_length());
  const bytes = within(core.bytes(), core.bytes_length()).slice();
  return { done, text, bytes };
}

async function ready(compressed) {
  const stream = new Blob([compressed]).stream().pipeThrough(new DecompressionStream("gzip"));
  module = await WebAssembly.compile(await new Response(stream).arrayBuffer());
  await start();
}

onmessage = async ({ data: { id, what, input } }) => {
  try {
    if (what === "core") {
      await ready(input);
      postMessage({ id, done: true });
      return;
    }
    const answer = call(what, input);
    postMessage({ id, ...answer }, [answer.bytes.buffer]);
  } catch (error) {
    // What has failed is of no use any more; the next one knows nothing of the files.
    const text = failure || String(error);
    failure = "";
    if (module) await start();
    postMessage({ id, done: false, failed: true, text });
  }
};
