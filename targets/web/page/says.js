// What the page says of what is chosen and shown.

const bytesText = (bytes) => bytes < 1024 ? `${bytes} B`
  : bytes < 1024 * 1024 ? `${(bytes / 1024).toFixed(bytes < 102400 ? 1 : 0)} KB`
  : `${(bytes / 1048576).toFixed(1)} MB`;

const time = (seconds) => seconds >= 0.01 ? `${Math.round(seconds * 1000)} ms` : `${(seconds * 1000).toFixed(1)} ms`;

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

function showFacts() {
  const panel = panelOf(shown.panel), board = boardOf(panel.board ?? shown.board), { estimate } = shown;
  showChoices();
  const bus = Math.min(panel.bus_hz || Infinity, board.bus_hz || Infinity);
  const sending = panel.bus_hz ? panel.frame_bits / bus + panel.settle_ms / 1000 : panel.frame_seconds;
  shown.frame_seconds = estimate ? 1 / estimate.frames_a_second : sending;
  const rate = 1 / shown.frame_seconds;
  $("fps").textContent = (estimate ? "≈ " : "") + rateText(rate);
  $("fps-note").textContent = [
    estimate ? `${time(estimate.drawing_s)} to draw (${(estimate.instructions / 1e6).toFixed(2)} million instructions)` : "",
    panel.bus_hz ? `${time(panel.frame_bits / bus)} to send ${bytesText(panel.frame_bits / 8)} at ${bus / 1e6} MHz` : "the panel reads its memory by itself",
    panel.settle_ms ? `${panel.settle_ms} ms to settle` : "",
    shown.rays ? "how long rays take to draw is not estimated" : "",
    rate > MOST_FRAMES ? `shown are ${MOST_FRAMES}` : "",
  ].filter(Boolean).join("; ");
  const [ram, flash] = [board.ram_bytes, board.flash_bytes].map(bytesText);
  fillMeter("ram", estimate?.ram_bytes ?? shown.ram_bytes, board.ram_bytes, estimate
    ? `of ${ram}: band of ${shown.band_rows} rows ${bytesText(estimate.band_bytes)}, bus ${bytesText(estimate.bus_bytes)}, lists ${bytesText(estimate.scratch_bytes)}, stack ${bytesText(estimate.stack_bytes)}`
    : `of ${ram}: band of ${shown.band_rows} rows, and lists`);
  fillMeter("flash", estimate?.flash_bytes ?? shown.blob_bytes, board.flash_bytes, estimate
    ? `of ${flash}: program ${bytesText(estimate.code_bytes)}, scene ${bytesText(shown.blob_bytes)}`
    : `of ${flash}: the scene`);
  $("triangles").textContent = shown.triangles.toLocaleString("en");
  $("notes").replaceChildren(...shown.notes.map((note) => element("li", note)));
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
  $(`${id}-note`).textContent = used > most ? `too much, ${note}` : note;
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
