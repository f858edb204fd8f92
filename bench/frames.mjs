// How long the viewer takes for a frame, in headless Chromium with software rendering:
//   node --experimental-websocket bench/frames.mjs PAGE.html [PICTURE.png]
// Prints how soon the page is ready, the quick frame that is shown while something moves (of every n-th extrusion), and the whole image, which comes in pieces.
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const folder = mkdtempSync(join(tmpdir(), "frames-")), page = join(folder, "page.html");
writeFileSync(page, readFileSync(process.argv[2], "utf8").replace("frames = new Frames(", "frames = globalThis.measured = new Frames("));
const options = ["--headless", "--no-sandbox", "--no-first-run", "--disable-background-networking", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
  "--window-size=1280,860", "--remote-debugging-port=0", `--user-data-dir=${join(folder, "profile")}`, "about:blank"];
const browser = spawn("chromium", options, { stdio: ["ignore", "ignore", "pipe"] });
const address = await new Promise((found) => browser.stderr.on("data", (text) => {
  const match = /ws:\/\/\S+/.exec(text);
  if (match) found(match[0]);
}));
const targets = await (await fetch(`http://${address.split("/")[2]}/json/list`)).json();
const socket = new WebSocket(targets.find((t) => t.type === "page").webSocketDebuggerUrl);
await new Promise((opened) => { socket.onopen = opened; });
const answers = new Map();
let calls = 0;
socket.onmessage = ({ data }) => {
  const { id, result } = JSON.parse(data);
  answers.get(id)?.(result);
};
const send = (method, params = {}) => new Promise((answer) => {
  answers.set(++calls, answer);
  socket.send(JSON.stringify({ id: calls, method, params }));
});
const value = async (expression) => (await send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true })).result?.value;
const until = async (expression) => {
  while (!await value(expression)) await new Promise((again) => setTimeout(again, 100));
};

await send("Page.enable");
const start = Date.now();
await send("Page.navigate", { url: `file://${page}` });
await until("document.documentElement.dataset.state === 'ready'");
console.log(`ready after ${Date.now() - start} ms, ${await value("measured.scene.lists.beads.count")} extrusions`);
await until("!measured.isFirst && !measured.isQueued && !measured.whole");
const pixel = "const g = f.scene.gl; g.readPixels(0, 0, 1, 1, g.RGBA, g.UNSIGNED_BYTE, new Uint8Array(4));";
for (const skip of new Set([1, 10, 100, await value("measured.skip")])) {
  const time = await value(`(() => { const f = measured, t = performance.now(); f.scene.drawQuickly(f.camera, f.state, ${skip}); ${pixel} return performance.now() - t; })()`);
  console.log(`quick, every ${skip}: ${time.toFixed(0)} ms`);
}
const whole = Date.now();
await value("clearTimeout(measured.resting), measured.whole = measured.scene.drawWhole(measured.camera, measured.state, 16384), measured.next(measured.whole)");
await until("!measured.whole");
await value(`(() => { const f = measured; ${pixel} })()`);
console.log(`whole, in pieces: ${Date.now() - whole} ms`);
if (process.argv[3]) writeFileSync(process.argv[3], Buffer.from((await send("Page.captureScreenshot")).data, "base64"));
browser.kill();
process.exit(0);
