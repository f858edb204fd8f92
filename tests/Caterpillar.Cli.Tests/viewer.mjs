// What a user meets on a page of the viewer, in a real browser: what is drawn and said for each choice, a phone and a desktop, light and dark, by keyboard
// alone, and for screen readers. The page shows four beads in two layers, 0.2 and 0.4 mm high, with an outer wall.
// The other page has the same print as an element, by the words of the manual.
//   node --experimental-websocket viewer.mjs CHROMIUM PAGE.html HOST.html
// Prints a line for each fault; no line is good. With PICTURES=FOLDER, it keeps a picture of each view.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { open, wait } from "../../tools/browser.mjs";

const [program, file, host] = process.argv.slice(2);
let name = "";
const fault = (text) => console.log(`${name}: ${text}`);
const page = await open(program, ["--window-size=720,480"], (method, { exceptionDetails, type }) => {
  if (method === "Runtime.exceptionThrown") fault("exception " + exceptionDetails.text);
  if (method === "Runtime.consoleAPICalled" && type === "error") fault("the page reports an error");
});
const { send, value } = page;
const press = async (key, shift = false) => {
  await send("Input.dispatchKeyEvent", { type: "keyDown", key, modifiers: shift ? 8 : 0, text: key.length === 1 ? key : undefined });
  await send("Input.dispatchKeyEvent", { type: "keyUp", key });
};
const drawn = () => page.until("document.documentElement.dataset.image === 'whole'");
const picture = async () => {
  await drawn();
  return page.picture({ optimizeForSpeed: true });
};
const focused = () => value("(() => { const a = document.activeElement; return a.getAttribute('aria-label') ?? a.textContent.trim() ?? a.id; })()");

async function show(hash) {
  await page.show(`${pathToFileURL(file)}#${hash}`);
  await page.until("document.documentElement.dataset.state === 'ready'");
}

// Another address of the page that is shown.
const go = (hash) => value(`new Promise((done) => {
  window.addEventListener("hashchange", () => done(), { once: true });
  location.hash = "${hash}";
})`);

// Beads and layers are those of the file, and each choice of colors explains itself.
async function colors() {
  name = "colors";
  await show("light");
  if (await value("document.documentElement.dataset.beads") !== "4") fault("other than four beads");
  const text = await value("document.body.textContent");
  for (const part of ["Outer wall", "0 – 1 · Z 0.2 – 0.4 mm"]) if (!text.includes(part)) fault("the page does not say " + part);
  const choices = await value("[...document.querySelectorAll('option')].map((o) => o.value).filter((v) => /^[a-z]+$/.test(v))");
  if (choices.length < 5) fault("choices of colors are missing");
  for (const choice of choices) {
    await value(`document.getElementById("legend").replaceChildren(), document.getElementById("color").value = "${choice}"`);
    await value("document.getElementById('color').dispatchEvent(new Event('change'))");
    if (!await value("document.querySelector('#legend span') && document.querySelector('#legend [class]') && true")) fault("no legend for " + choice);
  }
}

// What walls and surfaces hide is drawn after them: inner walls, infill, gap fill, and solid infill if top surfaces have a role of their own.
function inside() {
  const source = readFileSync(new URL("../../src/Caterpillar.Core/Display/Viewing/Page/scene.js", import.meta.url), "utf8");
  const rolesInside = new Function(source + "; return rolesInside;")();
  for (const [roles, hidden, expected] of [[[1, 2, 6], [], "2,4,5,9"], [[1, 2, 5], [4], "2,4,9"], [[1, 6], [1], ""], [[0, 2, 6], [], ""]]) {
    name = `roles ${roles} without ${hidden}`;
    const found = [...rolesInside(Uint8Array.from(roles), new Set(hidden))].join();
    if (found !== expected) fault(`${found} are inside`);
  }
}

// A model alone has no extrusions, and is drawn quickly all the same.
function model() {
  name = "model";
  const source = readFileSync(new URL("../../src/Caterpillar.Core/Display/Viewing/Page/scene.js", import.meta.url), "utf8");
  const [Scene, cut] = new Function(source + "; return [Scene, uncut];")();
  const drawn = [], scene = { lists: {}, resize() {}, drawBackground() {}, drawBeads() {}, drawForeground() { drawn.push("model"); } };
  Scene.prototype.drawQuickly.call(scene, null, { cut }, 1);
  if (drawn.join() !== "model") fault("drawn is " + drawn);
}

// The colors of filaments come from the comments of the file, and a change is marked.
async function filaments() {
  name = "filaments";
  await show("light&color=filament");
  await page.until("document.querySelector('option[value=filament]') !== null");
  const legend = await value("document.getElementById('legend').textContent");
  if (!legend.includes("T0 from Z 0.4 mm")) fault("the legend is " + legend);
  const seen = await value("[...document.querySelectorAll('.swatch')].map((s) => s.style.background).join()");
  if (seen !== "rgb(18, 52, 86),rgb(171, 205, 239)") fault("the colors are " + seen);
  const marks = await value("[...document.querySelectorAll('#moves .mark')].map((m) => m.title).join('; ')");
  if (!/^Color change, .*layer 1, height 0.4 mm$/.test(marks)) fault("the marks are " + marks);
}

// The eight corners of the camera's box are seen between the panels, reach their edges and lie in the middle.
function isWhole({ canvas, covered, box }, matrix) {
  const places = [];
  for (let i = 0; i < 8; i++) {
    const p = [0, 1, 2].map((k) => box[i >> k & 1][k]), at = (row) => matrix[row] * p[0] + matrix[4 + row] * p[1] + matrix[8 + row] * p[2] + matrix[12 + row];
    places.push([(1 + at(0) / at(3)) / 2 * canvas.width, (1 - at(1) / at(3)) / 2 * canvas.height]);
  }
  let fullest = 0;
  [canvas.width, canvas.height].forEach((whole, axis) => {
    const free = whole - covered[axis], least = Math.min(...places.map((p) => p[axis])), most = Math.max(...places.map((p) => p[axis]));
    if (least < 0 || most > free) fault(`${least} to ${most} of ${free} on axis ${axis}`);
    if (Math.abs(least + most - free) > 0.01 * free) fault(`not in the middle: ${least} to ${most} of ${free} on axis ${axis}`);
    fullest = Math.max(fullest, (most - least) / free);
  });
  if (Math.abs(fullest - 0.94) > 0.001) fault(`fills ${fullest} of the picture`);
}

// A tall box and a flat one, from all sides. In a window of another size they fit again, unless somebody has zoomed.
function fits() {
  const source = readFileSync(new URL("../../src/Caterpillar.Core/Display/Viewing/Page/camera.js", import.meta.url), "utf8");
  const Camera = new Function(source + "; return Camera;")();
  for (const [width, height, covered] of [[520, 350, [0, 0]], [1440, 900, [330, 90]], [390, 844, [0, 160]]]) {
    const canvas = { addEventListener() {} }, camera = new Camera(canvas, () => {});
    const size = (w, h) => Object.assign(canvas, { width: w, height: h, clientWidth: w, clientHeight: h });
    size(width, height);
    camera.covered = covered;
    for (const sides of [[60, 40, 80], [120, 90, 0.4]]) for (const view of [[-50, 22], [-90, 90], [0, 0], [-60, -30]]) {
      name = `fit of ${sides} from ${view} in ${width} × ${height}`;
      camera.box = [sides.map((s) => -s / 2), sides.map((s) => s / 2)];
      camera.look(...view);
      isWhole(camera, camera.matrix());
    }
    name = `a window of ${width} × ${height} that grows`;
    size(width + 300, height + 100);
    camera.refit();
    isWhole(camera, camera.matrix());
    camera.zoom(0.5, 10, 10);
    const { distance } = camera;
    size(width, height);
    camera.refit();
    if (camera.distance !== distance) fault("forgets that somebody has zoomed");
  }
}

// Attributes of the element choose what its frame shows, without loading it again, and it tells the moment.
async function element() {
  name = "element";
  await page.show(pathToFileURL(host));
  await page.until("document.querySelector('caterpillar-viewer')?.shadowRoot != null");
  await value("(window.moments = [], document.querySelector('caterpillar-viewer').addEventListener('moment', (e) => moments.push(e.detail)))");
  const set = (key, to) => value(`document.querySelector('caterpillar-viewer').setAttribute("${key}", "${to}")`);
  await set("line", 9);
  await page.until("document.getElementById('now').textContent === 'Line 9, layer 0'");
  await page.until("moments.some((m) => m.line === 9 && m.layer === 0 && m.height === 0.2)");
  await wait(400);
  const before = await page.picture();
  await set("color", "layer");
  await set("at", 1);
  await page.until("moments.some((m) => m.layer === 1 && m.seconds > 0)");
  // The frame draws in a process of its own.
  for (let i = 0; before.equals(await page.picture()); i++) {
    if (i === 300) return fault("draws the same with other attributes");
    await wait(50);
  }
  const small = await value("document.querySelector('caterpillar-viewer').shadowRoot.querySelector('iframe').getBoundingClientRect().height");
  if (small !== 500) fault(`is ${small} high`);
}

// A cut hides travels, too.
async function cuts() {
  name = "cuts";
  await show("light&show=travel&hide=bed,nozzle");
  const blue = async () => {
    await drawn();
    return value(`(() => {
      const view = document.getElementById("view"), copy = new OffscreenCanvas(view.width, view.height).getContext("2d");
      copy.drawImage(view, 0, 0);
      const { data } = copy.getImageData(0, 0, view.width, view.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) if (data[i + 2] > data[i] + 60 && data[i + 2] > 180) count++;
      return count;
    })()`);
  };
  const whole = await blue();
  await go("light&show=travel&hide=bed,nozzle&cut=x,0.5");
  const half = await blue();
  if (!(half > 0 && half < whole)) fault(`${half} of ${whole} pixels of travels are left`);
}

// Layers, moments, colors, views and themes each change what is drawn. A page that is opened with all of them shows what one shows that came to them in turn.
async function moments() {
  await show("light");
  const drawn = new Map([[(await picture()).toString("base64"), "light"]]);
  let hash = "light", image;
  for (const part of ["layers=0-0", "at=0.5", "color=speed", "view=-90,90", "dark", "hide=bed"]) {
    name = part;
    await go(hash += "&" + part);
    image = (await picture()).toString("base64");
    if (drawn.has(image)) fault("draws the same as " + drawn.get(image));
    drawn.set(image, part);
  }
  name = hash;
  await show(hash);
  if ((await picture()).toString("base64") !== image) fault("opened with all at once, it draws something else");
}

async function looks(width, height) {
  await send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: width < 700 });
  for (const theme of ["light", "dark"]) {
    name = `${width} × ${height}, ${theme}`;
    await (theme === "light" ? show : go)(`at=0.5&${theme}`);
    if (process.env.PICTURES) writeFileSync(join(process.env.PICTURES, `viewer_${width}_${theme}.png`), await picture());
    await look(width);
    if (theme === "light") await keyboard();
    await names();
  }
}

async function look(width) {
  const sliders = await value("[...document.querySelectorAll('#bar .range')].map((r) => r.getBoundingClientRect()).map((b) => [b.width, b.height, b.right])");
  for (const [w, h, right] of sliders) if (w < 280 || h < 24 || right > width) fault(`a slider of ${w} × ${h} that ends at ${right}`);
  const small = await value("[...document.querySelectorAll('button, select, label')].filter((b) => b.offsetParent && !b.closest('dialog'))"
    + ".map((b) => [b.textContent, b.getBoundingClientRect()]).filter(([, b]) => b.width < 24 || b.height < 24).map(([t, b]) => `${t} ${b.width} × ${b.height}`)");
  for (const target of small) fault("a target is small: " + target);
  const wide = await value("document.documentElement.scrollWidth");
  if (wide > width) fault(`the page is ${wide} wide`);
}

// Tab reaches everything, and keys move the camera, the layers and the time.
async function keyboard() {
  const seen = [];
  for (let i = 0; i < 80; i++) {
    await press("Tab");
    seen.push(await focused());
    if (seen.length > 3 && seen[seen.length - 1] === seen[0]) break;
  }
  for (const control of ["Fold or unfold the panel", "Last layer", "Position in the print", "Play"]) if (!seen.includes(control)) fault("Tab does not reach " + control);
  await value("document.getElementById('view').focus()");
  let before = await picture();
  for (const [key, shift, what] of [["l", false, "rotate"], ["L", true, "pan"], ["+", false, "zoom"], ["ArrowDown", false, "layers"], ["ArrowLeft", true, "moves"]]) {
    await press(key, shift);
    const after = await picture();
    if (before.equals(after)) fault(`${key} changes nothing (${what})`);
    before = after;
  }
}

// Each control has a name, and sliders say what their number means.
async function names() {
  if (await value("document.getElementById('panel').classList.contains('folded')")) await press("p");
  const { nodes } = await send("Accessibility.getFullAXTree");
  for (const node of nodes.filter((n) => !n.ignored && ["button", "slider", "checkbox", "combobox", "application"].includes(n.role?.value)))
    if (!(node.name?.value ?? "").trim()) fault(`a ${node.role.value} without a name`);
  const texts = await value("[...document.querySelectorAll('[role=slider]')].filter((s) => s.offsetParent).map((s) => s.getAttribute('aria-valuetext'))");
  if (texts.length < 3) fault("sliders are missing");
  if (!texts.some((t) => /layer \d+, height [\d.]+ mm/.test(t)) || !texts.some((t) => / of .*layer/.test(t))) fault("values of sliders are not spoken: " + texts.join("; "));
}

for (const domain of ["Runtime", "Accessibility"]) await send(domain + ".enable");
fits();
await colors();
inside();
model();
await filaments();
await cuts();
await moments();
await element();
for (const [width, height] of [[390, 844], [1440, 900]]) await looks(width, height);
await page.close();
process.exit(0);
