// What the page says of what is chosen and shown.

const bytesText = (bytes) => bytes < 1024 ? `${bytes} B`
  : bytes < 1024 * 1024 ? `${(bytes / 1024).toFixed(bytes < 102400 ? 1 : 0)} KB`
  : `${(bytes / 1048576).toFixed(1)} MB`;

function rateText(rate) {
  return rate >= 100 ? Math.round(rate).toString() : rate.toFixed(1);
}

function showChoices() {
  $("panel").value = wanted.panel;
  const panel = panelOf(wanted.panel);
  $("board").value = panel.board ?? wanted.board;
  $("board").disabled = Boolean(panel.board);
  $("dithering").disabled = !panel.dithered;
  $("dithering").value = panel.dithered ? wanted.dithering || "none" : "none";
  $("dithering-note").textContent = panel.dithered ? "" : "For panels of few greys; this one has colours enough.";
  for (const input of document.getElementsByName("renderer")) input.checked = (input.value === "ray") === Boolean(wanted.rays);
  const sample = wanted.files === null && sampleOf(wanted.path);
  for (const chip of $("samples").children) chip.setAttribute("aria-pressed", String(chip.textContent === sample?.title));
}

function showFacts(notes) {
  const panel = panelOf(shown.panel), board = boardOf(panel.board ?? shown.board);
  showChoices();
  const bus = Math.min(panel.bus_hz || Infinity, board.bus_hz || Infinity);
  shown.frame_seconds = panel.bus_hz ? panel.frame_bits / bus + panel.settle_ms / 1000 : panel.frame_seconds;
  const rate = 1 / shown.frame_seconds;
  $("fps").textContent = rateText(rate);
  $("fps-note").textContent = panel.bus_hz
    ? `as the bus brings them: ${bytesText(panel.frame_bits / 8)} at ${bus / 1e6} MHz`
      + (panel.settle_ms ? `, then ${panel.settle_ms} ms to settle` : "")
      + (rate > MOST_FRAMES ? `; shown are ${MOST_FRAMES}` : "")
    : "the panel reads its memory by itself";
  fillMeter("ram", shown.ram_bytes, board.ram_bytes, `band of ${shown.band_rows} rows and lists, of ${bytesText(board.ram_bytes)}`);
  fillMeter("flash", shown.blob_bytes, board.flash_bytes, `the scene, of ${bytesText(board.flash_bytes)}`);
  $("triangles").textContent = shown.triangles.toLocaleString("en");
  $("notes").replaceChildren(...[...notes, ...shown.notes].map((note) => element("li", note)));
  $("download-name").textContent = `${shown.name}.fxl (${bytesText(shown.blob_bytes)})`;
  $("caption").textContent = `${panel.title}, ${panel.colours}`;
  $("board-note").textContent = board.chip;
  const device = $("device");
  device.className = `device ${panel.case ?? ""}`;
  $("glass").setAttribute("aria-label", `${shown.name} on ${panel.title}, ${panel.colours}`);
  if ($("rust").open) showProgram();
  keepInAddress();
}

function fillMeter(id, used, most, note) {
  $(id).textContent = bytesText(used);
  $(id).classList.toggle("over", used > most);
  $(`${id}-note`).textContent = used > most ? `more than this board's ${bytesText(most)}` : note;
  const meter = $(`${id}-meter`);
  meter.max = most;
  meter.value = Math.min(used, most);
}

let swatches = "";
function showPalette() {
  const colours = shown.has_palette ? drawn.palette : [];
  const all = colours.join();
  if (all === swatches) return;
  swatches = all;
  $("palette-count").textContent = colours.length ? `${colours.length} colours, a byte a pixel` : "none: 16-bit colours as they are lit";
  $("palette").replaceChildren(...colours.map((colour) => {
    const swatch = element("i");
    swatch.style.background = colour;
    swatch.title = colour;
    return swatch;
  }));
}

async function showProgram() {
  const answer = await ask(PROGRAM);
  $("code").textContent = answer.text;
}

function showPlaying() {
  $("pause").setAttribute("aria-pressed", String(!playing));
  $("pause").querySelector(".icon").textContent = playing ? "❚❚" : "▶";
  $("pause").querySelector(".word").textContent = playing ? "Pause" : "Play";
}

function element(name, text = "") {
  const made = document.createElement(name);
  made.textContent = text;
  return made;
}

/// As many screen pixels to a panel's pixel as there is room for, a whole number of them.
function fit() {
  const { desk, device, glass } = { desk: $("desk"), device: $("device"), glass: $("glass") };
  const style = getComputedStyle(desk), frame = getComputedStyle(device);
  const sum = (of, ...keys) => keys.reduce((total, key) => total + parseFloat(of[key]), 0);
  const width = desk.clientWidth - sum(style, "paddingLeft", "paddingRight") - sum(frame, "paddingLeft", "paddingRight");
  const height = desk.clientHeight - $("below").offsetHeight - sum(style, "paddingTop", "paddingBottom") - sum(frame, "paddingTop", "paddingBottom");
  const dots = window.devicePixelRatio || 1;
  const scale = Math.max(1, Math.floor(Math.min(width / glass.width, height / glass.height) * dots));
  glass.style.width = `${glass.width * scale / dots}px`;
  glass.style.height = `${glass.height * scale / dots}px`;
}
