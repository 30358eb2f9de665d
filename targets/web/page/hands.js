// What hands do: mouse, fingers, keys, and files that are dropped.

function move(change) {
  for (const [key, value] of Object.entries(change)) {
    moves[key] = key === "zoom" ? (moves.zoom || 1) * value : (moves[key] || 0) + value;
  }
}

function listenToPointers() {
  const glass = $("glass");
  const fingers = new Map();
  const middle = () => {
    const all = [...fingers.values()];
    return [0, 1].map((axis) => all.reduce((sum, finger) => sum + finger[axis], 0) / all.length);
  };
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  };
  glass.addEventListener("pointerdown", (event) => {
    glass.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  glass.addEventListener("pointermove", (event) => {
    if (!fingers.has(event.pointerId)) return;
    const several = fingers.size > 1;
    const [x, y] = middle(), before = several ? spread() : 0;
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    const [nextX, nextY] = middle();
    const size = glass.getBoundingClientRect();
    const [right, down] = [(nextX - x) / size.height, (nextY - y) / size.height];
    if (several) {
      move({ right, up: -down, zoom: before > 0 ? spread() / before : 1 });
    } else if (event.shiftKey || event.buttons === 4) {
      move({ right, up: -down });
    } else {
      move({ azimuth: -right * 180, elevation: down * 180 });
    }
  });
  for (const end of ["pointerup", "pointercancel"]) {
    glass.addEventListener(end, (event) => fingers.delete(event.pointerId));
  }
  glass.addEventListener("wheel", (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    move({ zoom: Math.exp(-event.deltaY * lines / 500) });
  }, { passive: false });
  glass.addEventListener("dblclick", () => $("reset").click());
  const keys = {
    ArrowLeft: { azimuth: -10 }, ArrowRight: { azimuth: 10 }, ArrowUp: { elevation: 10 }, ArrowDown: { elevation: -10 },
    "+": { zoom: 1.15 }, "=": { zoom: 1.15 }, "-": { zoom: 1 / 1.15 },
  };
  glass.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key in keys) move(keys[event.key]);
    else if (event.key === " ") $("pause").click();
    else if (event.key === "r") $("reset").click();
    else return;
    event.preventDefault();
  });
}

/// All files of what was dropped, folders gone through, by path.
async function droppedFiles(transfer) {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  if (entries.length === 0) return [...transfer.files].map((file) => [file.name, file]);
  const files = [];
  const visit = async (entry) => {
    if (entry.isFile) {
      const file = await new Promise((done, failed) => { entry.file(done, failed); });
      files.push([entry.fullPath.replace(/^\//, ""), file]);
      return;
    }
    const reader = entry.createReader();
    for (;;) {
      const some = await new Promise((done, failed) => { reader.readEntries(done, failed); });
      if (some.length === 0) return;
      for (const inner of some) await visit(inner);
    }
  };
  for (const entry of entries) await visit(entry);
  return files;
}

function listenToDrops() {
  const body = document.body;
  let inside = 0;
  const mark = (change) => {
    inside = Math.max(0, inside + change);
    $("desk").classList.toggle("dropping", inside > 0);
  };
  body.addEventListener("dragenter", (event) => { event.preventDefault(); mark(1); });
  body.addEventListener("dragleave", () => mark(-1));
  body.addEventListener("dragover", (event) => event.preventDefault());
  body.addEventListener("drop", async (event) => {
    event.preventDefault();
    mark(-inside);
    try {
      await openFiles(await droppedFiles(event.dataTransfer));
    } catch (error) {
      complain("what was dropped", { text: String(error) });
    }
  });
}
