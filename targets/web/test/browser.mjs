// A browser without a window, driven by the DevTools protocol through two pipes.
import { spawn } from "node:child_process";

const PATIENCE_MS = 60_000;

export class Browser {
  #child;
  #waiting = new Map();
  #last = 0;
  #listeners = [];
  #session;

  /// Starts it with an empty page.
  static async start(program) {
    const browser = new Browser();
    const options = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--hide-scrollbars", "--remote-debugging-pipe"];
    browser.#child = spawn(program, [...options, "about:blank"], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    const [, , , to, from] = browser.#child.stdio;
    let text = "";
    from.setEncoding("utf8");
    from.on("data", (part) => {
      const messages = (text + part).split("\0");
      text = messages.pop();
      for (const message of messages) browser.#take(JSON.parse(message));
    });
    to.on("error", () => {});
    browser.#child.on("exit", (code) => browser.#fail(`the browser ended with ${code}`));
    browser.#child.on("error", (error) => browser.#fail(String(error)));
    const { targetInfos } = await browser.send("Target.getTargets");
    const { targetId } = targetInfos.find((target) => target.type === "page");
    browser.#session = (await browser.send("Target.attachToTarget", { targetId, flatten: true })).sessionId;
    return browser;
  }

  #take(message) {
    if (message.id === undefined) {
      for (const listener of this.#listeners) listener(message.method, message.params);
      return;
    }
    const { done, failed } = this.#waiting.get(message.id) ?? {};
    this.#waiting.delete(message.id);
    if (message.error) failed?.(new Error(message.error.message));
    else done?.(message.result);
  }

  #fail(why) {
    for (const { failed } of this.#waiting.values()) failed(new Error(why));
    this.#waiting.clear();
  }

  listen(listener) {
    this.#listeners.push(listener);
  }

  send(method, params = {}) {
    const id = ++this.#last;
    const message = { id, method, params, ...(this.#session && { sessionId: this.#session }) };
    const late = new Error(`${method} took more than ${PATIENCE_MS} ms`);
    return new Promise((done, failed) => {
      const timer = setTimeout(() => failed(late), PATIENCE_MS);
      const end = (how) => (value) => { clearTimeout(timer); how(value); };
      this.#waiting.set(id, { done: end(done), failed: end(failed) });
      this.#child.stdio[3].write(`${JSON.stringify(message)}\0`);
    });
  }

  /// What an expression gives in the page; promises are waited for.
  async evaluate(expression) {
    const options = { expression, awaitPromise: true, returnByValue: true };
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", options);
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /// Waits until an expression is true in the page.
  async until(expression) {
    const end = Date.now() + PATIENCE_MS;
    while (!(await this.evaluate(expression))) {
      if (Date.now() > end) throw new Error(`waited in vain for ${expression}`);
      await new Promise((done) => { setTimeout(done, 30); });
    }
  }

  async screen(width, height, dots, { dark = false, touch = false } = {}) {
    await this.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: dots, mobile: touch });
    await this.send("Emulation.setTouchEmulationEnabled", { enabled: touch });
    const features = [{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }];
    await this.send("Emulation.setEmulatedMedia", { features });
  }

  /// The page as PNG; all of it, or what the screen shows.
  async screenshot(whole = false) {
    const { data } = await this.send("Page.captureScreenshot", { captureBeyondViewport: whole });
    return Buffer.from(data, "base64");
  }

  end() {
    this.#child.removeAllListeners("exit");
    this.#child.kill();
    for (const pipe of this.#child.stdio) pipe?.destroy();
    this.#child.unref();
  }
}
