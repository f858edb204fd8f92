// A page in headless Chromium, driven by the DevTools protocol. Needs Node 22, or Node 20 with --experimental-websocket.
import { spawn } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";

// How long something may take, ms: a million extrusions are drawn in half a minute.
const patience = 120_000;

export const wait = (time) => new Promise((done) => setTimeout(done, time));

// The page, once the browser runs. Events of the protocol go to `event`.
export async function open(chromium, options = [], event = () => {}) {
  const profile = mkdtempSync(join(tmpdir(), "browser-"));
  const browser = spawn(chromium, ["--headless", "--no-sandbox", "--no-first-run", "--disable-background-networking", "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader", "--remote-debugging-port=0", `--user-data-dir=${profile}`, ...options, "about:blank"], { stdio: ["ignore", "ignore", "pipe"] });
  process.on("exit", () => browser.kill());
  const address = await new Promise((found) => browser.stderr.on("data", (text) => {
    const match = /ws:\/\/\S+/.exec(text);
    if (match) found(match[0]);
  }));
  const targets = await (await fetch(`http://${address.split("/")[2]}/json/list`)).json();
  const socket = new WebSocket(targets.find((t) => t.type === "page").webSocketDebuggerUrl), answers = new Map();
  await new Promise((opened) => { socket.onopen = opened; });
  let calls = 0;
  socket.onmessage = ({ data }) => {
    const { id, result, method, params } = JSON.parse(data);
    if (id) answers.get(id)?.(result);
    else event(method, params);
  };
  const send = (method, params = {}) => new Promise((answer) => {
    answers.set(++calls, answer);
    socket.send(JSON.stringify({ id: calls, method, params }));
  });
  const value = async (expression) => (await send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true })).result?.value;
  await send("Page.enable");
  return {
    send,
    value,
    async until(expression) {
      const end = Date.now() + patience;
      while (!await value(expression)) {
        if (Date.now() > end) throw new Error("This does not become true: " + expression);
        await wait(50);
      }
    },
    async show(url) {
      await send("Page.navigate", { url: "about:blank" });
      await send("Page.navigate", { url });
    },
    async picture(options = {}) {
      return Buffer.from((await send("Page.captureScreenshot", options)).data, "base64");
    },
    async close() {
      const ended = new Promise((exit) => browser.on("exit", exit));
      send("Browser.close");
      await ended;
      await rm(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
    },
  };
}
