// node drive.mjs BROWSER PAGE.html TASK.json
//
// Uses the page as a person does and holds what it shows against what the command line made
// (TASK.json names the files). Prints a line of JSON for each check: { check, wrong }, with
// `wrong` null if all is well. Screenshots go to the task's folder.
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

const [program, page, taskFile] = process.argv.slice(2);
const task = JSON.parse(readFileSync(taskFile));
const browser = await Browser.start(program);
const troubles = [];
browser.listen((method, params) => {
  if (method === "Runtime.exceptionThrown") troubles.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
  if (method === "Log.entryAdded" && params.entry.level === "error") troubles.push(params.entry.text);
  if (method === "Network.requestWillBeSent" && !/^(file|data|blob):/.test(params.request.url)) troubles.push(`asks for ${params.request.url}`);
});
for (const domain of ["Page", "Runtime", "Log", "Network", "DOM"]) await browser.send(`${domain}.enable`);
const downloads = mkdtempSync(join(task.folder, "downloads-"));
await browser.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: downloads, eventsEnabled: true });

async function check(name, work) {
  let wrong = null;
  try {
    wrong = (await work()) ?? null;
  } catch (error) {
    wrong = error.message;
  }
  console.log(JSON.stringify({ check: name, wrong }));
}

// --- What the page shows ------------------------------------------------------

const GLASS = `document.getElementById("glass")`;
const element = (id) => `document.getElementById(${JSON.stringify(id)})`;
const text = (id) => browser.evaluate(`${element(id)}.textContent`);
const click = (id) => browser.evaluate(`${element(id)}.click()`);
const choose = (id, value) => browser.evaluate(
  `{ const e = ${element(id)}; e.value = ${JSON.stringify(value)}; e.dispatchEvent(new Event("change", { bubbles: true })); }`);

/// The panel's pixels: red, green and blue by rows.
async function pixels() {
  const base64 = await browser.evaluate(`(() => {
    const { data } = ${GLASS}.getContext("2d").getImageData(0, 0, ${GLASS}.width, ${GLASS}.height);
    let letters = "";
    for (let at = 0; at < data.length; at += 4) letters += String.fromCharCode(data[at], data[at + 1], data[at + 2]);
    return btoa(letters);
  })()`);
  return Buffer.from(base64, "base64");
}

/// The two colours of a grey panel's glass, as the page has them.
const LOOKS = {
  "ssd1306-128x64": [[0x04, 0x07, 0x0c], [0x7f, 0xd8, 0xff]],
  "ssd1327-128x128": [[0x06, 0x06, 0x06], [0xfb, 0xf6, 0xe8]],
  "sharp-400x240": [[0x1c, 0x21, 0x24], [0xc3, 0xc9, 0xbd]],
  "ssd1681-200x200": [[0x2a, 0x29, 0x27], [0xe9, 0xe6, 0xdc]],
};

async function sameAs(made) {
  const expected = readFileSync(made.pixels);
  const look = LOOKS[made.panel];
  if (look) {
    const [dark, light] = look;
    expected.forEach((value, at) => { expected[at] = Math.round(dark[at % 3] + (light[at % 3] - dark[at % 3]) * value / 255); });
  }
  const found = await pixels();
  if (found.length !== expected.length) return `${found.length} bytes of pixels instead of ${expected.length}`;
  let differ = 0;
  for (let at = 0; at < found.length; at += 3) {
    if (found.compare(expected, at, at + 3, at, at + 3) !== 0) differ += 1;
  }
  return differ > 0 ? `${differ} pixels differ from those of fixel render` : null;
}

const shows = (panel, more = "true") => browser.until(
  `${GLASS}.dataset.panel === ${JSON.stringify(panel)} && ${element("busy")}.hidden && ${more}`);

async function visit(words) {
  await browser.send("Page.navigate", { url: "about:blank" });
  await browser.send("Page.navigate", { url: `${pathToFileURL(page)}#${new URLSearchParams(words)}` });
  await browser.until(`document.readyState === "complete" && ${GLASS} !== null`);
  await shows(words.panel);
}

async function download(id, name) {
  const path = join(downloads, name);
  await click(id);
  const end = Date.now() + 20_000;
  while (!existsSync(path)) {
    if (Date.now() > end) throw new Error(`${name} was not downloaded`);
    await new Promise((done) => { setTimeout(done, 30); });
  }
  const bytes = readFileSync(path);
  rmSync(path);
  return bytes;
}

/// Drops files on the page, without their folders.
async function drop(files) {
  const list = files.map(([name, bytes]) => ({ name, base64: bytes.toString("base64") }));
  await browser.evaluate(`(() => {
    const transfer = new DataTransfer();
    for (const { name, base64 } of ${JSON.stringify(list)}) {
      transfer.items.add(new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], name));
    }
    const target = ${element("desk")};
    for (const kind of ["dragenter", "dragover", "drop"]) {
      target.dispatchEvent(new DragEvent(kind, { bubbles: true, cancelable: true, dataTransfer: transfer }));
    }
  })()`);
}

const middle = async () => browser.evaluate(
  `(({ x, y, width, height }) => [x + width / 2, y + height / 2])(${GLASS}.getBoundingClientRect())`);

async function mouse(type, x, y, more = {}) {
  await browser.send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons: 1, clickCount: 1, ...more });
}

async function changed(before, what) {
  const end = Date.now() + 10_000;
  for (;;) {
    const now = await pixels();
    if (!now.equals(before)) return now;
    if (Date.now() > end) throw new Error(`${what} changed nothing`);
    await new Promise((done) => { setTimeout(done, 50); });
  }
}

async function becomes(wanted, what) {
  const end = Date.now() + 10_000;
  while (!(await pixels()).equals(wanted)) {
    if (Date.now() > end) throw new Error(`${what} did not bring the picture back`);
    await new Promise((done) => { setTimeout(done, 50); });
  }
}

// --- The checks ---------------------------------------------------------------

const [first] = task.panels;
await browser.screen(1280, 860, 1);

await check("the page opens from a file and shows a sample as fixel render does", async () => {
  await visit({ panel: first.panel, paused: "" });
  return sameAs(first);
});

for (const made of task.panels.slice(1)) {
  await check(`${made.panel} shows what fixel render does`, async () => {
    await choose("panel", made.panel);
    await shows(made.panel);
    if (made.dithering !== "none") {
      await choose("dithering", made.dithering);
      await shows(made.panel, `${GLASS}.dataset.dithering === ${JSON.stringify(made.dithering)}`);
    }
    return sameAs(made);
  });
  await check(`${made.panel}: the download is what fixel bake makes`, async () => {
    const name = basename(made.scene, ".toml");
    const bytes = await download("download", `${name}.fxl`);
    return bytes.equals(readFileSync(made.blob)) ? null : "the bytes differ";
  });
}

await check("rays show what fixel render --renderer ray does", async () => {
  await visit({ panel: task.rays.panel, paused: "" });
  await browser.evaluate(`document.querySelector('input[value="ray"]').click()`);
  await shows(task.rays.panel, `${GLASS}.dataset.rays === "true"`);
  return sameAs(task.rays);
});

for (const made of task.dropped) {
  const names = made.files.map((file) => basename(file));
  await check(`${names.join(", ")} dropped on the page`, async () => {
    await visit({ panel: made.panel, paused: "" });
    await drop(made.files.map((file) => [basename(file), readFileSync(file)]));
    await shows(made.panel, `${GLASS}.dataset.path === ${JSON.stringify(names[0])}`);
    const wrong = await sameAs(made);
    if (wrong) return wrong;
    const stem = names[0].replace(/\.[^.]*$/, "");
    const bytes = await download("download", `${stem}.fxl`);
    if (!bytes.equals(readFileSync(made.blob))) return "what is downloaded differs from what fixel bake makes";
    // A model alone turns.
    const before = await pixels();
    await click("step");
    await changed(before, "a step");
    // What was baked can be dropped again.
    await drop([["again.fxl", bytes]]);
    await shows(made.panel, `${GLASS}.dataset.path === "again.fxl"`);
    return sameAs(made);
  });
}

await check("files chosen by the button", async () => {
  const [made] = task.dropped;
  await visit({ panel: made.panel, paused: "" });
  const { root } = await browser.send("DOM.getDocument");
  const { nodeId } = await browser.send("DOM.querySelector", { nodeId: root.nodeId, selector: "#files" });
  await browser.send("DOM.setFileInputFiles", { nodeId, files: made.files });
  await shows(made.panel, `${GLASS}.dataset.path === ${JSON.stringify(basename(made.files[0]))}`);
  return sameAs(made);
});

await check("a broken file is refused with its line, and the picture stays", async () => {
  await visit({ panel: first.panel, paused: "" });
  for (const [name, bytes, message] of [
    ["broken.obj", "v 0 0 0\nv 1 zero 0\n", "broken.obj:2: v: \"zero\" is not a number"],
    ["photo.gif", "GIF89a", "photo.gif: is no kind of model"],
    ["scene.toml", "[[actor]]\nmesh = \"absent.obj\"\n", "scene.toml:2: actor.mesh: \"absent.obj\" is not among the files"],
    ["cut.fxl", "FXL", "cut.fxl: "],
  ]) {
    await drop([[name, Buffer.from(bytes)]]);
    await browser.until(`!${element("error")}.hidden && ${element("error-title")}.textContent.includes(${JSON.stringify(name)})`);
    const said = await text("error-text");
    if (!said.startsWith(message)) return `${name}: ${said}`;
    const { height, top } = await browser.evaluate(`${element("error")}.getBoundingClientRect().toJSON()`);
    if (height < 20 || top < 0) return "the message is not to be seen";
    await click("error-close");
  }
  return sameAs(first);
});

await check("a mouse turns, moves and enlarges, and the view goes back", async () => {
  await visit({ panel: first.panel, paused: "" });
  const own = await pixels();
  const [x, y] = await middle();
  let before = own;
  const drag = async (modifiers) => {
    await mouse("mousePressed", x, y, { modifiers });
    for (const part of [10, 25, 45]) await mouse("mouseMoved", x + part, y + part / 2, { modifiers });
    await mouse("mouseReleased", x + 45, y + 22, { modifiers, buttons: 0 });
  };
  await drag(0);
  before = await changed(before, "dragging");
  await drag(8);
  before = await changed(before, "dragging with Shift");
  await mouse("mouseWheel", x, y, { deltaX: 0, deltaY: -200, button: "none", buttons: 0 });
  before = await changed(before, "the wheel");
  await browser.evaluate(`${GLASS}.focus()`);
  await browser.send("Input.dispatchKeyEvent", { type: "keyDown", key: "ArrowLeft", code: "ArrowLeft" });
  await changed(before, "an arrow key");
  await click("reset");
  await becomes(own, "resetting the view");
  return null;
});

await check("fingers turn and pinch", async () => {
  await browser.screen(390, 844, 3, { touch: true });
  await visit({ panel: first.panel, paused: "" });
  await browser.evaluate(`${GLASS}.scrollIntoView({ block: "center" })`);
  const own = await pixels();
  const [x, y] = await middle();
  const touch = (type, ...points) => browser.send("Input.dispatchTouchEvent", {
    type, touchPoints: points.map(([dx, dy], id) => ({ x: x + dx, y: y + dy, id })),
  });
  await touch("touchStart", [0, 0]);
  await touch("touchMove", [15, 5]);
  await touch("touchMove", [40, 10]);
  await touch("touchEnd");
  const turned = await changed(own, "a finger");
  await touch("touchStart", [-20, 0], [20, 0]);
  await touch("touchMove", [-40, 0], [40, 0]);
  await touch("touchMove", [-60, 0], [60, 0]);
  await touch("touchEnd");
  await changed(turned, "two fingers");
  return null;
});

await check("it plays, and pauses", async () => {
  await visit({ panel: first.panel });
  await browser.until(`Number(${GLASS}.dataset.frame) > 5`);
  await click("pause");
  await new Promise((done) => { setTimeout(done, 300); });
  const before = await browser.evaluate(`${GLASS}.dataset.frame`);
  await new Promise((done) => { setTimeout(done, 300); });
  const after = await browser.evaluate(`${GLASS}.dataset.frame`);
  return before === after ? null : "it did not pause";
});

await check("the page says what the scene takes, and writes a program", async () => {
  await visit({ panel: first.panel, paused: "" });
  await browser.evaluate(`${element("rust")}.open = true`);
  await browser.until(`${element("code")}.textContent.includes("include_scene!(\\"teapot.fxl\\")")`);
  const wanted = { fps: /^≈ \d/, ram: / KB$/, flash: / KB$/, triangles: /^\d/ };
  for (const [id, form] of Object.entries(wanted)) {
    if (!form.test(await text(id))) return `${id}: ${await text(id)}`;
  }
  const colours = await browser.evaluate(`${element("palette")}.children.length`);
  return colours > 1 ? null : "no palette is shown";
});

// --- How it looks ---------------------------------------------------------------

const SCREENS = {
  desktop: [1280, 860, 1, {}],
  "desktop-dark": [1280, 860, 1, { dark: true }],
  phone: [390, 844, 2, { touch: true }],
  "phone-dark": [390, 844, 2, { touch: true, dark: true }],
};
for (const [name, [width, height, dots, more]] of Object.entries(SCREENS)) {
  await check(`nothing sticks out on a ${name} screen`, async () => {
    await browser.screen(width, height, dots, more);
    await visit({ panel: more.dark ? "ssd1306-128x64" : "st7789-320x240", paused: "", sample: more.dark ? "bunny" : "teapot" });
    writeFileSync(join(task.folder, `${name}.png`), await browser.screenshot(more.touch));
    await browser.evaluate(`${element("rust")}.open = true`);
    await browser.until(`${element("code")}.textContent !== ""`);
    const [inner, outer, unnamed] = await browser.evaluate(`[
      document.documentElement.scrollWidth, document.documentElement.clientWidth,
      [...document.querySelectorAll("button, select, input, canvas, meter")].filter((e) =>
        !e.textContent.trim() && !e.getAttribute("aria-label") && !(e.labels?.length > 0)).map((e) => e.outerHTML),
    ]`);
    if (unnamed.length > 0) return `without a name for those who cannot see: ${unnamed.join(" ")}`;
    return inner > outer ? `${inner} pixels wide on a screen of ${outer}` : null;
  });
}

await check("the page asks nobody for anything, and no script fails", async () => troubles.join("; ") || null);

browser.end();
rmSync(downloads, { recursive: true });
