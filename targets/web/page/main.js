// The page: what is chosen, what is shown. The core draws in a worker.

const $ = (id) => document.getElementById(id);
const CATALOGUE = 0, FORGET = 1, FILE = 2, OPEN = 3, FRAME = 4, BLOB = 5, PROGRAM = 6, ESTIMATE = 7;
/// Kinds of files that can be shown, the first that there is being the one that names others.
const KINDS = ["toml", "fxl", "gltf", "glb", "obj", "stl", "ply"];
/// A screen shows no more.
const MOST_FRAMES = 60;

// --- What is chosen ---------------------------------------------------------

const ask = startCore();
let catalogue;
/// What is asked for; `files` is a map of bytes by path, or null for a sample.
let wanted = { files: null, path: "", panel: "", board: "", dithering: "", rays: null };
/// What is on the panel: as `wanted`, and the facts about it.
let shown = null;
/// The files that the core has.
let given = null;
let number = 0;
let playing = true;
/// What a hand has done since the last frame.
let moves = {};
let drawing = false;
let opening = 0;
let drawn = null;

const panelOf = (name) => catalogue.panels.find((panel) => panel.name === name);
const boardOf = (name) => catalogue.boards.find((board) => board.name === name);
const extension = (path) => path.split(".").pop().toLowerCase();
const fileName = (path) => path.split("/").pop();

function named(files) {
  const paths = [...files.keys()].sort();
  for (const kind of KINDS) {
    const found = paths.filter((path) => extension(path) === kind);
    if (found.length > 0) return found;
  }
  return [];
}

// --- Opening ----------------------------------------------------------------

async function hand(files) {
  if (given === files) return null;
  given = null;
  await ask(FORGET);
  for (const [path, bytes] of files ?? []) {
    const name = new TextEncoder().encode(path);
    const input = new Uint8Array(4 + name.length + bytes.length);
    new DataView(input.buffer).setUint32(0, name.length, true);
    input.set(name, 4);
    input.set(bytes, 4 + name.length);
    const answer = await ask(FILE, input);
    if (!answer.done) return answer;
  }
  given = files;
  return null;
}

/// Opens what is wanted with `changes`; if it is refused, all stays as it was.
async function open(changes, after = {}) {
  const ticket = ++opening;
  const before = wanted;
  wanted = { ...wanted, ...changes };
  showChoices();
  const slow = setTimeout(() => { $("busy").hidden = false; }, 120);
  const { files, path, panel, dithering, rays } = wanted;
  const refused = await hand(files);
  const request = { path, panel, dithering: dithering || null, rays };
  const answer = refused ?? await ask(OPEN, JSON.stringify(request));
  clearTimeout(slow);
  if (ticket !== opening) return;
  $("busy").hidden = true;
  if (answer.done) {
    const facts = JSON.parse(answer.text);
    if (!shown || shown.path !== path) number = 0;
    shown = { ...wanted, ...facts, estimate: null, notes: [...(after.notes ?? []), ...facts.notes] };
    wanted.rays = facts.rays;
    $("error").hidden = true;
    await estimate();
    fit();
    await drawSoon({ reset: changes.path !== undefined });
    return;
  }
  complain(path, answer);
  const back = before.path ? before : null;
  wanted = back ?? wanted;
  if (answer.failed) given = null;
  if (back && answer.failed) await open({});
  showChoices();
}

function complain(path, answer) {
  const title = answer.failed ? "This is a mistake in fixel, not in your file" : "This cannot be shown";
  $("error-title").textContent = `${title}: ${fileName(path)}`;
  $("error-text").textContent = answer.text;
  $("error").hidden = false;
}

/// What it takes on the board, as far as there are estimates of it.
async function estimate() {
  const of = shown;
  const board = panelOf(of.panel).board ?? of.board;
  const answer = await ask(ESTIMATE, JSON.stringify({ board, number }));
  if (shown !== of) return;
  shown.estimate = answer.done ? JSON.parse(answer.text) : null;
  showFacts();
}

async function openFiles(list) {
  const files = new Map();
  for (const [path, file] of list) files.set(path, new Uint8Array(await file.arrayBuffer()));
  const found = named(files);
  if (found.length === 0) {
    const path = [...files.keys()][0] ?? "nothing";
    const kinds = KINDS.map((kind) => `.${kind}`).join(", ");
    complain(path, { text: `${path}: is no kind of model; expected one of ${kinds}` });
    return;
  }
  const others = found.slice(1).map(fileName).join(", ");
  const notes = others ? [`Shown is ${fileName(found[0])}; there are also ${others}.`] : [];
  await open({ files, path: found[0], rays: null }, { notes });
}

function openSample(sample) {
  const mono = panelOf(wanted.panel).mono && sample.mono;
  return open({ files: null, path: mono || sample.path, rays: null });
}

const sampleOf = (path) => catalogue.samples.find((s) => s.path === path || s.mono === path);

function choosePanel(name) {
  const panel = panelOf(name);
  const changes = { panel: name };
  const sample = wanted.files === null && sampleOf(wanted.path);
  // A sample has a scene of its own for black and white.
  if (sample) changes.path = (panel.mono && sample.mono) || sample.path;
  if (changes.path === wanted.path) delete changes.path;
  changes.dithering = panel.dithered ? wanted.dithering || "blue_noise" : wanted.dithering;
  return open(changes);
}

// --- Drawing ----------------------------------------------------------------

async function draw(more = {}) {
  if (drawing || !shown) return false;
  drawing = true;
  const request = { number, ...moves, ...more };
  moves = {};
  const answer = await ask(FRAME, JSON.stringify(request));
  drawing = false;
  if (!answer.done) {
    complain(shown.path, answer);
    playing = false;
    given = null;
    showPlaying();
    return false;
  }
  drawn = JSON.parse(answer.text);
  paint(answer.bytes);
  return true;
}

const channels = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));

/// Greys as the panel's glass shows them.
function tint(bytes, look) {
  const [dark, light] = look.map(channels);
  for (let at = 0; at < bytes.length; at += 4) {
    const level = bytes[at] / 255;
    for (let c = 0; c < 3; c += 1) bytes[at + c] = Math.round(dark[c] + (light[c] - dark[c]) * level);
  }
}

function paint(bytes) {
  const glass = $("glass");
  const { look } = panelOf(shown.panel);
  if (glass.width !== drawn.width || glass.height !== drawn.height) {
    glass.width = drawn.width;
    glass.height = drawn.height;
    fit();
  }
  if (look) tint(bytes, look);
  const pixels = new ImageData(new Uint8ClampedArray(bytes.buffer), drawn.width, drawn.height);
  glass.getContext("2d").putImageData(pixels, 0, 0);
  Object.assign(glass.dataset, { frame: number, panel: shown.panel, path: shown.path, rays: shown.rays, dithering: shown.dithering });
  $("triangles-note").textContent = shown.rays
    ? `${drawn.covered_px.toLocaleString("en")} pixels of the model`
    : `${drawn.triangles_drawn.toLocaleString("en")} drawn, ${drawn.covered_px.toLocaleString("en")} pixels`;
  showPalette();
}

/// Draws as soon as the core is free.
async function drawSoon(more) {
  while (drawing) await new Promise(requestAnimationFrame);
  return draw(more);
}

let due = 0;
function tick(now) {
  requestAnimationFrame(tick);
  if (!shown || drawing) return;
  const moved = Object.keys(moves).length > 0;
  const wait = 1000 * Math.max(shown.frame_seconds, 1 / MOST_FRAMES);
  if (playing && now >= due - 4) {
    due = Math.max(due + wait, now);
    number += 1;
    draw();
  } else if (moved && !playing) {
    draw();
  }
}

// --- The address keeps what is chosen ---------------------------------------

function keepInAddress() {
  const sample = shown.files === null && sampleOf(shown.path);
  const words = new URLSearchParams({ panel: shown.panel, board: shown.board });
  if (sample) words.set("sample", sample.title.toLowerCase().replaceAll(" ", "-"));
  if (panelOf(shown.panel).dithered) words.set("dithering", shown.dithering || "none");
  try { history.replaceState(null, "", `#${words}`); } catch { /* Some browsers keep files' addresses as they are. */ }
}

function fromAddress() {
  const words = new URLSearchParams(location.hash.slice(1));
  const known = (list, name) => list.some((entry) => entry.name === name);
  const panel = known(catalogue.panels, words.get("panel")) ? words.get("panel") : "st7789-240x240";
  const board = known(catalogue.boards, words.get("board")) ? words.get("board") : catalogue.boards[0].name;
  const dithering = catalogue.ditherings.includes(words.get("dithering")) ? words.get("dithering") : "blue_noise";
  const title = (sample) => sample.title.toLowerCase().replaceAll(" ", "-");
  const sample = catalogue.samples.find((entry) => title(entry) === words.get("sample")) ?? catalogue.samples[0];
  if (words.has("paused")) playing = false;
  return { panel, board, dithering, sample };
}

// --- Buttons ----------------------------------------------------------------

function saveAs(name, blob) {
  const link = element("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function listenToButtons() {
  $("pause").addEventListener("click", () => {
    playing = !playing;
    due = performance.now();
    showPlaying();
  });
  $("step").addEventListener("click", () => {
    playing = false;
    showPlaying();
    number += 1;
    drawSoon();
  });
  $("reset").addEventListener("click", () => {
    moves = {};
    drawSoon({ reset: true });
  });
  $("save").addEventListener("click", () => $("glass").toBlob((blob) => saveAs(`${shown.name}.png`, blob)));
  $("download").addEventListener("click", async () => {
    const answer = await ask(BLOB);
    if (answer.done) saveAs(`${shown.name}.fxl`, new Blob([answer.bytes], { type: "application/octet-stream" }));
    else complain(shown.path, answer);
  });
  $("copy").addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText($("code").textContent);
      $("copy").textContent = "Copied";
    } catch {
      getSelection().selectAllChildren($("code"));
      $("copy").textContent = "Selected";
    }
    setTimeout(() => { $("copy").textContent = "Copy"; }, 2000);
  });
  $("rust").addEventListener("toggle", () => { if ($("rust").open && shown) showProgram(); });
  $("error-close").addEventListener("click", () => { $("error").hidden = true; });
  $("panel").addEventListener("change", (event) => choosePanel(event.target.value));
  $("dithering").addEventListener("change", (event) => open({ dithering: event.target.value }));
  $("board").addEventListener("change", (event) => {
    wanted.board = event.target.value;
    if (!shown) return;
    shown.board = wanted.board;
    estimate();
  });
  for (const input of document.getElementsByName("renderer")) {
    input.addEventListener("change", () => open({ rays: input.value === "ray" }));
  }
  $("files").addEventListener("change", async (event) => {
    const list = [...event.target.files].map((file) => [file.webkitRelativePath || file.name, file]);
    event.target.value = "";
    if (list.length > 0) await openFiles(list);
  });
  new ResizeObserver(fit).observe($("desk"));
}

// --- Beginning --------------------------------------------------------------

const DITHERINGS = {
  none: "None: the nearest", bayer4: "Bayer 4x4", bayer8: "Bayer 8x8", blue_noise: "Blue noise", floyd_steinberg: "Floyd-Steinberg",
};

function fill(select, entries) {
  select.replaceChildren(...entries.map(([value, text]) => {
    const option = element("option", text);
    option.value = value;
    return option;
  }));
}

async function begin() {
  $("busy-text").textContent = "Starting the core…";
  $("busy").hidden = false;
  const ready = await ask("core", moduleBytes());
  if (!ready.done) throw new Error(ready.text);
  catalogue = JSON.parse((await ask(CATALOGUE)).text);
  fill($("panel"), catalogue.panels.map((panel) => [panel.name, panel.title]));
  fill($("board"), catalogue.boards.map((board) => [board.name, board.title]));
  const own = catalogue.panels.map((panel) => panel.board);
  for (const option of $("board").options) option.hidden = own.includes(option.value);
  fill($("dithering"), catalogue.ditherings.map((name) => [name, DITHERINGS[name] ?? name]));
  $("samples").replaceChildren(...catalogue.samples.map((sample) => {
    const chip = element("button", sample.title);
    chip.type = "button";
    chip.addEventListener("click", () => openSample(sample));
    return chip;
  }));
  listenToPointers();
  listenToDrops();
  listenToButtons();
  const { panel, board, dithering, sample } = fromAddress();
  wanted = { ...wanted, panel, board, dithering };
  $("busy-text").textContent = "Baking…";
  showPlaying();
  await openSample(sample);
  requestAnimationFrame(tick);
}

begin().catch((error) => {
  $("busy").hidden = true;
  complain("this browser", { text: `${error.message}. Expected a browser with WebAssembly and DecompressionStream, of 2023 or later.` });
});
