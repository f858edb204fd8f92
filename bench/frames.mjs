// How long the viewer takes for a frame, in headless Chromium with software rendering:
//   node --experimental-websocket bench/frames.mjs PAGE.html [PICTURE.png]
// Prints how soon the page is ready, the quick frame that is shown while something moves (of every n-th extrusion), and the whole image, which comes in pieces.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { open } from "../tools/browser.mjs";

const folder = mkdtempSync(join(tmpdir(), "frames-")), file = join(folder, "page.html");
writeFileSync(file, readFileSync(process.argv[2], "utf8").replace("frames = new Frames(", `const drawWhole = scene.drawWhole;
  globalThis.ends = [];
  const show = scene.show;
  globalThis.shown = [];
  scene.show = function (...values) {
    show.apply(this, values);
    shown.push(performance.now());
  };
  scene.drawWhole = function* (...values) {
    yield* drawWhole.apply(this, values);
    ends.push(performance.now());
  };
  frames = globalThis.measured = new Frames(`));
const page = await open("chromium", ["--window-size=1280,860"]), { send, value, until } = page;
const start = Date.now();
await send("Page.navigate", { url: `file://${file}` });
await until("document.documentElement.dataset.state === 'ready'");
console.log(`ready after ${Date.now() - start} ms, ${await value("document.documentElement.dataset.beads")} extrusions`);
await until("ends.length > 0 && !measured.isFirst && !measured.isQueued && !measured.whole");
console.log(`images of what is seen from outside, of all, and smooth: ${(await value("shown")).map((t) => t.toFixed(0)).join(", ")} ms after the page was opened`);
console.log(`images of all extrusions, the last smooth: ${(await value("ends")).map((t) => t.toFixed(0)).join(", ")} ms after the page was opened`);
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
if (process.argv[3]) writeFileSync(process.argv[3], await page.picture());
await page.close();
rmSync(folder, { recursive: true, force: true });
process.exit(0);
