// Makes pictures of the manual: docs/images/viewer.png, a page of the viewer, and two animations: docs/images/canvas_to_print.png, from the canvas to the
// finished part, and docs/images/remix.png, a sliced file that is changed.
//   node --experimental-websocket tools/pictures.mjs viewer|canvas_to_print|remix CATERPILLAR CHROMIUM [FILE.png]
// CATERPILLAR is the published program. The pictures of the canvas are docs/images/first_print, those of the print are the viewer's.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { deflateSync, inflateSync } from "node:zlib";
import { open, wait } from "./browser.mjs";

const stepTime = 1.6, printTime = 0.12, lastTime = 2.5, printFrames = 30, twistFrames = 14, twist = 1.2;
const root = join(dirname(fileURLToPath(import.meta.url)), ".."), folder = mkdtempSync(join(tmpdir(), "animation-"));
const [subject, program, chromium, file = join(root, "docs", "images", `${subject}.png`)] = process.argv.slice(2);
const [width, height] = { remix: [520, 390], viewer: [1280, 860], canvas_to_print: [720, 480] }[subject];

const crcTable = Int32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; k++) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
  return n;
});
const crc = (bytes) => ~bytes.reduce((sum, byte) => crcTable[(sum ^ byte) & 255] ^ (sum >>> 8), -1);

// The colors of a PNG with 8 bits for each of three or four channels, three bytes for each pixel.
function read(png) {
  let at = 8, channels = 3;
  const parts = [];
  while (at < png.length) {
    const length = png.readUInt32BE(at), kind = png.toString("latin1", at + 4, at + 8), data = png.subarray(at + 8, at + 8 + length);
    if (kind === "IHDR") channels = data[9] === 6 ? 4 : 3;
    if (kind === "IDAT") parts.push(data);
    at += 12 + length;
  }
  const raw = inflateSync(Buffer.concat(parts)), stride = width * channels, out = Buffer.alloc(width * height * 3);
  let before = Buffer.alloc(stride);
  for (let y = 0; y < height; y++) {
    const filter = raw[y * (stride + 1)], row = Buffer.from(raw.subarray(y * (stride + 1) + 1, (y + 1) * (stride + 1)));
    for (let i = 0; i < stride && filter; i++) {
      const left = i >= channels ? row[i - channels] : 0, up = before[i], corner = i >= channels ? before[i - channels] : 0, guess = left + up - corner;
      const [a, b, c] = [Math.abs(guess - left), Math.abs(guess - up), Math.abs(guess - corner)];
      row[i] += [0, left, up, (left + up) >> 1, a <= b && a <= c ? left : b <= c ? up : corner][filter];
    }
    for (let x = 0; x < width; x++) for (let k = 0; k < 3; k++) out[(y * width + x) * 3 + k] = row[x * channels + k];
    before = row;
  }
  return out;
}

// The box in which two images differ.
function changed(image, before) {
  let [left, top, right, bottom] = [width, height, -1, -1];
  for (let i = 0; i < image.length; i++) {
    if (image[i] === before[i]) continue;
    const x = Math.floor(i / 3) % width, y = Math.floor(i / 3 / width);
    [left, top, right, bottom] = [Math.min(left, x), Math.min(top, y), Math.max(right, x), Math.max(bottom, y)];
  }
  return right < 0 ? [0, 0, 1, 1] : [left, top, right - left + 1, bottom - top + 1];
}

function pack(image, [x, y, w, h]) {
  const rows = [];
  for (let j = y; j < y + h; j++) rows.push(Buffer.of(0), image.subarray((j * width + x) * 3, (j * width + x + w) * 3));
  return deflateSync(Buffer.concat(rows), { level: 9 });
}

function write(frames) {
  const out = [Buffer.of(0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10)];
  const words = (...values) => Buffer.concat(values.map(([size, value]) => {
    const bytes = Buffer.alloc(size);
    bytes.writeUIntBE(value, 0, size);
    return bytes;
  }));
  const chunk = (kind, data) => {
    const body = Buffer.concat([Buffer.from(kind, "latin1"), data]);
    out.push(words([4, data.length]), body, words([4, crc(body) >>> 0]));
  };
  chunk("IHDR", words([4, width], [4, height], [1, 8], [1, 2], [1, 0], [1, 0], [1, 0]));
  if (frames.length > 1) chunk("acTL", words([4, frames.length], [4, 0]));
  let number = 0, before = null;
  for (const [image, seconds] of frames) {
    const box = before ? changed(image, before) : [0, 0, width, height], data = pack(image, box);
    if (frames.length > 1) chunk("fcTL", words([4, number++], [4, box[2]], [4, box[3]], [4, box[0]], [4, box[1]], [2, Math.round(seconds * 100)], [2, 100], [1, 0], [1, 0]));
    if (before) chunk("fdAT", Buffer.concat([words([4, number++]), data]));
    else chunk("IDAT", data);
    before = image;
  }
  chunk("IEND", Buffer.alloc(0));
  writeFileSync(file, Buffer.concat(out));
}

const page = await open(chromium), frames = [];
await page.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: false });

// The pixels of a page in the browser, once an expression is true there.
async function picture(url, isReady) {
  await page.show(url);
  await page.until(isReady);
  await wait(500);
  return read(await page.picture());
}

const run = (...words) => execFileSync(program, [...words, "-q"]);
const temporary = (name) => join(folder, name);

// The page of a file with only the view on it: the panels are moved out of the picture.
function viewOf(code, caption = "") {
  const html = temporary("view.html");
  run("view", code, "--printer", "generic", "-o", html);
  const outside = "#panel, #bar, #message, #refining { left: 100% !important; top: 100% !important; width: 1px !important; height: 1px !important; overflow: hidden; }"
    + (caption ? " #view { top: 40px; height: calc(100% - 40px); }" : "")
    + " #caption { position: fixed; z-index: 1; left: 16px; top: 12px; margin: 0; font: 15px ui-monospace, monospace; }";
  writeFileSync(html, readFileSync(html, "utf8").replace("</style>", outside + "</style>").replace("<canvas", `<p id="caption">${caption}</p><canvas`));
  return pathToFileURL(html);
}

const isReady = "document.documentElement.dataset.state === 'ready'";

async function canvasToPrint() {
  for (let step = 1; step <= 5; step++) {
    const svg = readFileSync(join(root, "docs", "images", "first_print", `${step}.svg`), "utf8"), html = temporary(`${step}.html`);
    writeFileSync(html, `<body style="margin:0;background:#d4d0c8;display:flex;height:100vh;align-items:center;justify-content:center">
      <img src="data:image/svg+xml;base64,${Buffer.from(svg).toString("base64")}" style="max-width:100%;max-height:100%">`);
    frames.push([await picture(pathToFileURL(html), "document.images[0]?.complete"), stepTime]);
  }
  const code = temporary("vase.gcode");
  run("slice", join(root, "examples", "models", "vase.stl"), "--scale", "0.5", "-o", code);
  const view = viewOf(code);
  for (let k = 1; k <= printFrames; k++) {
    frames.push([await picture(`${view}#light&at=${k / printFrames}&view=-60,24`, isReady), k < printFrames ? printTime : lastTime]);
  }
}

// A bracket as it was sliced, then twisted more and more, then slower in its upper half.
async function remix() {
  const sliced = temporary("bracket.gcode"), twisted = temporary("twisted.gcode"), slow = temporary("slow.gcode"), view = "light&view=-50,22&hide=bed,nozzle";
  run("slice", join(root, "examples", "models", "bracket.stl"), "-o", sliced);
  frames.push([await picture(`${viewOf(sliced, "bracket.gcode, from a slicer")}#${view}`, isReady), stepTime]);
  for (let k = 1; k <= twistFrames; k++) {
    const formula = `r, theta + ${(twist * k / twistFrames).toFixed(2)}*z, z`;
    run("convert", sliced, "-o", twisted, "--deform", formula, "--axis", "center");
    frames.push([await picture(`${viewOf(twisted, `--deform "${formula}"`)}#${view}`, isReady), k < twistFrames ? printTime : stepTime]);
  }
  run("convert", twisted, "-o", slow, "--speed", "50%", "--first-layer", "125");
  frames.push([await picture(`${viewOf(slow, "--speed 50% --first-layer 125")}#${view}&color=speed`, isReady), lastTime]);
}

// The whole page, a third of its time printed.
async function viewer() {
  const code = temporary("bracket.gcode"), html = temporary("bracket.html");
  run("slice", join(root, "examples", "models", "bracket.stl"), "-o", code);
  run("view", code, "--printer", "generic", "-o", html);
  frames.push([await picture(`${pathToFileURL(html)}#light&color=speed&at=0.35&show=travel`, isReady), lastTime]);
}

await { remix, viewer, canvas_to_print: canvasToPrint }[subject]();
await page.close();
write(frames);
rmSync(folder, { recursive: true, force: true });
console.log(`${file}: ${frames.length} images, ${(readFileSync(file).length / 1e6).toFixed(2)} MB`);
process.exit(0);
