// Asking the core, which is in a worker.

function startCore() {
  const worker = new Worker(URL.createObjectURL(new Blob([$("worker").textContent])));
  const waiting = new Map();
  let last = 0;
  worker.onmessage = ({ data }) => {
    waiting.get(data.id)(data);
    waiting.delete(data.id);
  };
  const ask = (what, input = "") => new Promise((done) => {
    last += 1;
    waiting.set(last, done);
    worker.postMessage({ id: last, what, input });
  });
  return ask;
}

function moduleBytes() {
  const text = atob($("core").textContent.trim());
  return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
}
