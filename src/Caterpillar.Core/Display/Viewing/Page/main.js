// State of the view; what can be shared stands in the address after #.
const state = {
  dark: false, bed: true, head: true, model: true, travel: false, retractions: false, seams: false, above: false,
  row: 0, part: 1, nozzle: null, cut: uncut, background: [1, 1, 1],
};
let head, moves, scene, camera, frames, list, coloring, total, box;
let layersRange, movesRange, withinRange, cutRange, measuredFrom = null, layerRows = [], firstLayer = 0, lastLayer = 0, ranks = [], playing = false;
const hidden = new Set();
const lines = new FileLines();

function redraw() { frames?.redraw(); }

// Layers by height: several objects share a place on the slider where they share a height.
function rankLayers() {
  const heights = [...new Set(head.layers.map((l) => Math.round(l[1] * 1000)))].sort((a, b) => a - b);
  const rank = new Map(heights.map((z, i) => [z, i]));
  ranks = head.layers.map((l) => rank.get(Math.round(l[1] * 1000)));
  return heights;
}

function boundsOf() {
  const least = [Infinity, Infinity, Infinity], greatest = [-Infinity, -Infinity, -Infinity];
  const include = (p) => p.forEach((v, i) => {
    least[i] = Math.min(least[i], v);
    greatest[i] = Math.max(greatest[i], v);
  });
  if (moves) {
    for (let i = 0; i < moves.rows; i++) {
      const blob = moves.kind[i] === kinds.prime && moves.width[i] > 0 && (moves.layer[i] >= 0 || !head.layers.length);
      if ((moves.kind[i] !== kinds.print && !blob) || head.roles[moves.role[i]][0] === "Purge") continue;
      const half = moves.width[i] / 2, high = moves.height[i];
      for (const k of i > 0 && !blob ? [i - 1, i] : [i]) {
        include([moves.x[k] - half, moves.y[k] - half, moves.z[k] - (high || half)]);
        include([moves.x[k] + half, moves.y[k] + half, moves.z[k] + (high ? 0 : half)]);
      }
    }
  }
  if (scene?.modelData) for (let i = 0; i < scene.modelData.x.length; i++) include([scene.modelData.x[i], scene.modelData.y[i], scene.modelData.z[i]]);
  return least[0] <= greatest[0] ? [least, greatest] : [[0, 0, 0], [1, 1, 1]];
}

function inLayers(i) {
  if (ranks.length === 0) return true;
  const layer = moves.layer[i];
  // What belongs to no layer is shown with the whole print.
  if (layer < 0) return firstLayer === 0;
  return ranks[layer] >= firstLayer && ranks[layer] <= lastLayer;
}

function filter() {
  const inside = [], outside = [], travels = [], retractions = [], seams = [], above = [];
  const insideRoles = rolesInside(moves.role, hidden);
  let before = -1;
  for (let i = 0; i < moves.rows; i++) {
    const kind = moves.kind[i];
    const role = kind === kinds.print ? moves.role[i] : -1;
    if (inLayers(i)) {
      if (role >= 0) {
        if (!hidden.has(role)) {
          const rank = ranks[moves.layer[i]];
          (insideRoles.has(role) && rank > firstLayer && rank < lastLayer ? inside : outside).push(i);
        }
        if (before < 0 && (role === 1 || role === 0)) seams.push(i);
      } else if (kind === kinds.prime && moves.width[i] > 0 && !hidden.has(moves.role[i])) outside.push(i);
      else if (kind === kinds.retract) retractions.push(i);
      else if (kind === kinds.travel || kind === kinds.wipe || kind === kinds.movingDeretract) travels.push(i);
    } else if (role === 1 && moves.layer[i] >= 0 && ranks[moves.layer[i]] > lastLayer) above.push(i);
    before = role;
  }
  scene.list("above", Uint32Array.from(above));
  scene.list("inside", Uint32Array.from(inside));
  scene.list("outside", Uint32Array.from(outside));
  scene.list("travels", Uint32Array.from(travels));
  scene.list("retractions", Uint32Array.from(retractions));
  scene.list("seams", Uint32Array.from(seams));
  scene.until(state.row);
}

function showLayers() {
  layersRange.set(firstLayer, lastLayer);
  const z = (rank) => number((heights[rank] ?? 0) / 1000, 3);
  byId("layersText").textContent = heights.length ? `${firstLayer} – ${lastLayer} · Z ${z(firstLayer)} – ${z(lastLayer)} mm` : "none";
}

let heights = [];

function setLayers(first, last) {
  firstLayer = first;
  lastLayer = last;
  showLayers();
  showWithin();
  filter();
  redraw();
}

// First and last row of each layer on the slider.
function findLayerRows() {
  layerRows = heights.map(() => [0, moves.rows - 1]);
  const seen = new Set();
  for (let i = 0; i < moves.rows; i++) {
    if (moves.layer[i] < 0) continue;
    const rank = ranks[moves.layer[i]];
    if (!seen.has(rank)) layerRows[rank] = [i, i];
    seen.add(rank);
    layerRows[rank][1] = i;
  }
}

// The moves of the layer that is being printed, or of the topmost one that is shown.
function showWithin() {
  if (!layerRows.length) return;
  const now = moves.layer[state.row] >= 0 ? ranks[moves.layer[state.row]] : lastLayer;
  const [first, last] = layerRows[Math.min(Math.max(now, firstLayer), lastLayer)];
  withinRange.limits(first, last);
  withinRange.set(Math.min(Math.max(state.row, first), last));
  byId("withinText").textContent = `move ${withinRange.values[0] - first + 1} of ${last - first + 1}`;
}

function layerText(row) {
  const layer = moves.layer[row] >= 0 ? head.layers[moves.layer[row]] : null;
  return layer ? `layer ${layer[0]}, height ${number(layer[1], 3)} mm` : "no layer";
}

function timeText(row) {
  const when = head.timed ? `${duration(moves.time[row])} of ${duration(moves.time[moves.rows - 1])}` : `move ${moves.move[row]}`;
  return `${when}, ${layerText(row)}`;
}

// Pauses and changes of tools and colors, as rows with a text and a color. Tools that change in every layer would hide the slider.
function marks(changes = []) {
  const colored = changes.map((c) => [c.row, `Color change, ${timeText(c.row)}`, c.color]), rows = new Set(changes.map((c) => c.row)), tools = [];
  const pauses = head.events.filter((e) => e[1] === "pause").map((e) => Math.min(e[0], moves.rows - 1)).filter((row) => !rows.has(row))
    .map((row) => [row, `Pause, ${timeText(row)}`]);
  for (let i = 1, tool = moves.tool[0]; i < moves.rows; i++) {
    if (moves.tool[i] === tool) continue;
    tool = moves.tool[i];
    tools.push([i, `Tool T${tool}, ${timeText(i)}`, "var(--tool)"]);
  }
  return [...colored, ...pauses, ...(tools.length > 40 ? [] : tools)].slice(0, 1000);
}

// The comments of a file name the colors of its filaments. They are read when the print is shown.
async function readFilaments() {
  if (byId("codeSection").hidden) return;
  await lines.load();
  const coloring = filamentColoring(moves, head, filamentsIn(lines));
  if (coloring) {
    list.push(coloring);
    byId("color").append(element("option", { value: coloring.id }, coloring.name));
    movesRange.mark(marks(coloring.changes));
    if (address.get("color") === coloring.id) recolor(coloring.id);
  }
}

function setCut() {
  const axis = byId("cutAxis").value;
  byId("cutPlace").hidden = axis === "";
  if (axis === "") state.cut = uncut;
  else {
    const i = Number(axis), normal = [0, 0, 0];
    normal[i] = 1;
    state.cut = [...normal, box[0][i] + (box[1][i] - box[0][i]) * cutRange.values[0] / 1000 - scene.middle[i]];
  }
  redraw();
}

// The moment: a row and the part of it that is done.
function setMoment(row, part = 1) {
  state.row = Math.min(Math.max(row, 0), moves.rows - 1);
  state.part = part;
  const r = state.row;
  const from = r > 0 ? [moves.x[r - 1], moves.y[r - 1], moves.z[r - 1]] : head.start;
  const to = [moves.x[r], moves.y[r], moves.z[r]];
  state.nozzle = [0, 1, 2].map((i) => from[i] + (to[i] - from[i]) * part - scene.middle[i]);
  if (moves.axes && head.printer) {
    const axes = moves.axes.map((values, k) => (1 - part) * (r > 0 ? values[r - 1] : +(k === 2 || k === 3)) + part * values[r]);
    scene.mesh("head", turned(headMesh(head.printer), axes), 6);
    scene.mesh("headBoxes", turned(headBoxLines(head.printer), axes), 3);
  }
  scene.until(r);
  movesRange.set(r);
  showWithin();
  showLines(r);
  const seconds = r > 0 ? moves.time[r - 1] + (moves.time[r] - moves.time[r - 1]) * part : moves.time[r] * part;
  byId("movesText").textContent = head.timed ? `${duration(seconds)} of ${duration(moves.time[moves.rows - 1])}` : `move ${moves.move[r]} of ${head.moves}`;
  tell(r, seconds);
  redraw();
}

// A page that shows this one in a frame learns of the moment.
function tell(row, seconds) {
  if (window.parent === window) return;
  const [index, height] = head.layers[moves.layer[row]] ?? [null, null];
  window.parent.postMessage({ moment: { line: head.source === "line" ? moves.line[row] : null, move: moves.move[row], layer: index, height, seconds } }, "*");
}

// The lines of the file follow the moment, ten times a second at most.
let linesRow = -1, linesWait = 0;
function showLines(row) {
  linesRow = row;
  if (linesWait || byId("codeSection").hidden) return;
  linesWait = setTimeout(() => {
    linesWait = 0;
    lines.show(Math.max(moves.line[linesRow], 0), byId("lines"));
  }, 100);
}

function pickRow(row, measured) {
  showMove(row, moves, head, measured);
  if (row >= 0) showLines(row);
}

// The place on an extrusion that is nearest to a line of sight, in mm.
function placeOn(row, [eye, direction]) {
  const b = [moves.x[row], moves.y[row], moves.z[row]].map((v, i) => v - scene.middle[i]);
  const a = row > 0 ? [moves.x[row - 1], moves.y[row - 1], moves.z[row - 1]].map((v, i) => v - scene.middle[i]) : b;
  const along = add(b, times(a, -1)), from = add(a, times(eye, -1));
  const aa = dot(along, along), ad = dot(along, direction), dd = dot(direction, direction), denominator = aa * dd - ad * ad;
  const part = denominator > 1e-12 ? (ad * dot(from, direction) - dd * dot(from, along)) / denominator : 0;
  return add(add(a, times(along, Math.min(Math.max(part, 0), 1))), scene.middle);
}

// A click shows a move; with Shift, the distance from the click before it, too.
function click(x, y, measures) {
  const row = scene.pick(camera, state, x, y);
  const place = row >= 0 ? placeOn(row, camera.ray(x, y)) : null;
  const rows = [];
  if (measures && place && measuredFrom) {
    const d = add(place, times(measuredFrom, -1));
    rows.push(["Distance", number(Math.hypot(...d), 3) + " mm"], ["Δ X, Y, Z", d.map((v) => number(v, 3)).join(", ") + " mm"]);
  }
  measuredFrom = place ?? measuredFrom;
  pickRow(row, rows);
}

function momentAt(seconds) {
  if (!head.timed) {
    const row = Math.min(Math.floor(seconds), moves.rows - 1);
    return [row, 1];
  }
  let low = 0, high = moves.rows - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (moves.time[middle] < seconds) low = middle + 1;
    else high = middle;
  }
  const begin = low > 0 ? moves.time[low - 1] : 0, size = moves.time[low] - begin;
  return [low, size > 0 ? Math.min(Math.max((seconds - begin) / size, 0), 1) : 1];
}

function play() {
  playing = !playing;
  byId("play").textContent = playing ? "■" : "▶";
  byId("play").setAttribute("aria-label", playing ? "Pause" : "Play");
  if (!playing) return;
  const end = head.timed ? moves.time[moves.rows - 1] : moves.rows - 1;
  let seconds = state.row >= moves.rows - 1 ? 0 : head.timed ? (state.row > 0 ? moves.time[state.row - 1] : 0) : state.row;
  let last = performance.now();
  const step = (now) => {
    if (!playing) return;
    seconds += (now - last) / 1000 * Number(byId("rate").value);
    last = now;
    setMoment(...momentAt(Math.min(seconds, end)));
    if (seconds >= end) play();
    else requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

function recolor(id) {
  coloring = list.find((c) => c.id === id) ?? list[0];
  byId("color").value = coloring.id;
  const range = paint(coloring, moves, head, scene.colorBytes);
  scene.recolor();
  showLegend(coloring, range, head, total, hidden, (role, hide) => {
    if (hide) hidden.add(role);
    else hidden.delete(role);
    filter();
    redraw();
  });
  redraw();
}

function theme(dark) {
  state.dark = dark;
  document.documentElement.classList.toggle("dark", dark);
  state.background = dark ? [0.106, 0.118, 0.133] : [0.957, 0.957, 0.945];
  redraw();
}

function goTo(finding) {
  if (playing) play();
  let row = finding.row ?? -1;
  if (row < 0 && finding.line !== undefined && moves) row = moves.line.findIndex((line) => line >= finding.line);
  if (row < 0 || !moves) return;
  row = Math.min(row, moves.rows - 1);
  const rank = moves.layer[row] >= 0 ? ranks[moves.layer[row]] : firstLayer;
  if (rank < firstLayer || rank > lastLayer) setLayers(Math.min(rank, firstLayer), Math.max(rank, lastLayer));
  setMoment(row, 1);
  pickRow(row);
  camera.approach([moves.x[row], moves.y[row], moves.z[row]].map((v, i) => v - scene.middle[i]), 60);
}

const switches = { travel: "T", retractions: "R", seams: "S", above: "A", bed: "B", nozzle: "N", model: "M" };

function flip(id) {
  state[id === "nozzle" ? "head" : id] = byId(id).checked;
  redraw();
}

const keys = [
  ["Space", "play or pause", () => moves && play()],
  ["↑ ↓", "show one layer more or fewer"],
  ["← →", "one move back or forward (Shift: 100 moves)"],
  ["I J K L", "rotate (Shift: pan)"],
  ["+ −", "zoom"],
  ["Shift+click", "distance from the last click"],
  ["F", "fit view", () => camera.fit(camera.box)],
  ["1", "top view", () => camera.look(-90, 90)],
  ["2", "front view", () => camera.look(-90, 0)],
  ["3", "right view", () => camera.look(0, 0)],
  ["4", "3D view", () => camera.look(-60, 28)],
  ["D", "light or dark theme", () => theme(!state.dark)],
  ["P", "fold or unfold the panel", () => fold(!byId("panel").classList.contains("folded"))],
  ["?", "keyboard shortcuts", () => byId("keys").showModal()],
];

function fold(folded) {
  byId("panel").classList.toggle("folded", folded);
  byId("fold").setAttribute("aria-expanded", String(!folded));
  cover();
  camera.refit();
}

const steps = { j: [-40, 0], l: [40, 0], i: [0, -40], k: [0, 40] };

// Turning, panning and zooming by keyboard.
function drive(e) {
  const step = steps[e.key.toLowerCase()], view = byId("view");
  if (step && e.shiftKey) camera.pan(-step[0], -step[1]);
  else if (step) camera.turn(...step);
  else if ("+=-_".includes(e.key)) {
    camera.zoom("+=".includes(e.key) ? 0.8 : 1.25, (view.clientWidth - camera.covered[0]) / 2, (view.clientHeight - camera.covered[1]) / 2);
  }
  else return false;
  return true;
}

function listen() {
  for (const [id, key] of Object.entries(switches)) {
    byId(id).addEventListener("change", () => flip(id));
    if (byId(id).parentElement.hidden) continue;
    keys.push([key, "show or hide: " + byId(id).parentElement.textContent.trim().toLowerCase(), () => {
      byId(id).checked = !byId(id).checked;
      flip(id);
    }]);
  }
  fillTable(byId("keyTable"), keys.map(([key, what]) => [element("kbd", {}, key), what]));
  const press = { fit: "F", top: "1", front: "2", right: "3", corner: "4", theme: "D", help: "?", fold: "P" };
  for (const [id, key] of Object.entries(press)) byId(id).addEventListener("click", () => keys.find((k) => k[0] === key)[2]());
  document.addEventListener("keydown", (e) => {
    if (e.target.matches("input[type=text], select") || e.ctrlKey || e.metaKey || e.altKey || byId("keys").open) return;
    if (drive(e)) {
      e.preventDefault();
      return;
    }
    if (moves && (e.key === "ArrowLeft" || e.key === "ArrowRight")) {
      setMoment(state.row + (e.key === "ArrowRight" ? 1 : -1) * (e.shiftKey ? 100 : 1));
      pickRow(state.row);
    } else if (moves && (e.key === "ArrowUp" || e.key === "ArrowDown")) {
      setLayers(Math.min(firstLayer, lastLayer), Math.min(Math.max(lastLayer + (e.key === "ArrowUp" ? 1 : -1), firstLayer), Math.max(heights.length - 1, 0)));
    } else {
      const entry = keys.find((k) => k[2] && (k[0] === "Space" ? e.key === " " : k[0].toLowerCase() === e.key.toLowerCase()));
      if (!entry || (e.key === " " && e.target.matches("button, input, a"))) return;
      entry[2]();
    }
    e.preventDefault();
  });
  window.addEventListener("resize", () => {
    cover();
    camera.refit();
  });
  if (!moves) return;
  byId("play").addEventListener("click", play);
  byId("color").addEventListener("change", (e) => recolor(e.target.value));
  const view = byId("view");
  let down = null, waiting = 0;
  view.addEventListener("pointerdown", (e) => { down = [e.clientX, e.clientY]; });
  view.addEventListener("pointerup", (e) => {
    if (down && Math.hypot(e.clientX - down[0], e.clientY - down[1]) < 4) click(e.clientX, e.clientY, e.shiftKey);
    down = null;
  });
  // What lies under a resting pointer is shown; a click keeps it.
  view.addEventListener("pointermove", (e) => {
    clearTimeout(waiting);
    if (e.buttons || frames.areSlow) return;
    waiting = setTimeout(() => {
      const row = scene.pick(camera, state, e.clientX, e.clientY);
      view.title = row < 0 ? "" : describe(row);
    }, 250);
  });
}

function describe(row) {
  const role = head.roles[moves.role[row]][0], place = moves.line[row] >= 0 ? `${head.source} ${moves.line[row]}` : `move ${moves.move[row]}`;
  return `${role}, ${place}, ${number(moves.speed[row])} mm/s, ${number(moves.width[row], 3)} mm wide`;
}

// #color=speed&layers=0-10&at=0.5&view=-60,28&show=travel,seams&dark. Only what differs from the address before is done.
let address = new URLSearchParams();
function fromAddress() {
  const before = address, values = address = new URLSearchParams(location.hash.slice(1));
  const isNew = (key) => values.has(key) && values.get(key) !== before.get(key);
  if (isNew("light")) theme(false);
  if (isNew("dark")) theme(true);
  for (const [key, on] of [["show", true], ["hide", false]]) {
    const [now, then] = [values, before].map((from) => (from.get(key) ?? "").split(",").filter((id) => id in switches));
    for (const id of new Set([...now, ...then])) {
      byId(id).checked = now.includes(id) === on;
      flip(id);
    }
  }
  if (moves) {
    if (isNew("color")) recolor(values.get("color"));
    if (isNew("layers")) {
      const [first, last] = values.get("layers").split("-").map(Number);
      const top = Math.max(heights.length - 1, 0);
      setLayers(Math.min(Math.max(first || 0, 0), top), Math.min(Math.max(last ?? first ?? top, first || 0), top));
    }
    if (isNew("at")) {
      const part = Math.min(Math.max(Number(values.get("at")) || 0, 0), 1);
      setMoment(...momentAt(part * (head.timed ? moves.time[moves.rows - 1] : moves.rows - 1)));
    }
    if (isNew("line")) goTo({ line: Number(values.get("line")) });
    if (isNew("cut")) {
      const [axis, place] = values.get("cut").split(",");
      byId("cutAxis").value = { x: "0", y: "1" }[axis.toLowerCase()] ?? "";
      const part = parseFloat(place);
      cutRange.set(Number.isNaN(part) ? 500 : Math.min(Math.max(Math.round(part * 1000), 0), 1000));
      setCut();
    }
  }
  if (isNew("view")) {
    const [azimuth, elevation] = values.get("view").split(",").map(Number);
    camera.look(azimuth || 0, elevation || 0);
  }
}

async function start() {
  head = JSON.parse(byId("head").textContent);
  byId("title").textContent = head.title;
  const bytes = await unpacked("moveData"), model = await unpacked("modelData");
  if (bytes) moves = readMoves(bytes, head);
  const modelData = model ? readModel(model) : null;
  scene = { modelData };
  box = boundsOf();
  const middle = times(add(box[0], box[1]), 0.5);
  scene = new Scene(byId("view"), middle);
  camera = new Camera(byId("view"), redraw);
  theme(window.matchMedia("(prefers-color-scheme: dark)").matches);
  if (head.printer) {
    const bed = bedLines(head.printer, middle);
    scene.mesh("bedThin", bed.thin, 3);
    scene.mesh("bedBold", bed.bold, 3);
    scene.mesh("head", headMesh(head.printer), 6);
    scene.mesh("headBoxes", headBoxLines(head.printer), 3);
  }
  if (modelData) {
    scene.mesh("model", modelTriangles(modelData, middle), 6);
    byId("modelSwitch").hidden = !moves;
  }
  for (const id of ["coloring", "pickedSection"]) byId(id).hidden = !moves;
  byId("codeSection").hidden = !moves || head.source !== "line" || !byId("gcodeData").textContent.trim();
  for (const id of ["travel", "retractions", "seams", "above", "nozzle"]) byId(id).parentElement.hidden = !moves;
  if (!moves) byId("printTitle").textContent = "Model";
  if (moves) {
    total = sums(moves, head.start);
    scene.load(moves, head.start);
    list = colorings(moves, head);
    byId("color").append(...list.map((c) => element("option", { value: c.id }, c.name)));
    heights = rankLayers();
    findLayerRows();
    lastLayer = Math.max(heights.length - 1, 0);
    layersRange = new Range(byId("layers"), ["First layer", "Last layer"], ([a, b]) => setLayers(a, b),
      (rank) => `layer ${rank}, height ${number((heights[rank] ?? 0) / 1000, 3)} mm`);
    layersRange.limits(0, lastLayer);
    const toRow = ([row]) => {
      setMoment(row);
      pickRow(row);
    };
    movesRange = new Range(byId("moves"), ["Position in the print"], toRow, timeText);
    movesRange.limits(0, moves.rows - 1);
    movesRange.mark(marks());
    withinRange = new Range(byId("within"), ["Move within the last layer"], toRow, timeText);
    state.row = moves.rows - 1;
    recolor("role");
    setLayers(0, lastLayer);
    setMoment(moves.rows - 1);
    state.nozzle = null;
    showMove(-1, moves, head);
  }
  byId("layersRow").hidden = byId("withinRow").hidden = heights.length < 2;
  cutRange = new Range(byId("cutPlace"), ["Place of the cut"], setCut, (v) => `${number(v / 10, 1)} % of the size`);
  cutRange.limits(0, 1000);
  cutRange.set(500);
  byId("cutPlace").hidden = true;
  byId("cutAxis").addEventListener("change", setCut);
  showStatistics(moves, head, total, box, heights.length);
  showFindings(head, goTo);
  listen();
  byId("panel").hidden = false;
  byId("bar").hidden = !moves;
  if (window.matchMedia("(max-width: 700px)").matches) fold(true);
  cover();
  camera.fit([0, 1, 2].reduce((b, i) => {
    b[0][i] = box[0][i] - middle[i];
    b[1][i] = box[1][i] - middle[i];
    return b;
  }, [[], []]));
  camera.look(-60, 28);
  fromAddress();
  window.addEventListener("hashchange", fromAddress);
  frames = new Frames(scene, camera, state);
  redraw();
  byId("message").hidden = true;
  document.documentElement.dataset.state = "ready";
  console.info("ready");
  document.documentElement.dataset.beads = String((scene.lists.outside?.count ?? 0) + (scene.lists.inside?.count ?? 0));
  await readFilaments();
}

function cover() {
  const view = byId("view"), bar = byId("bar").getBoundingClientRect();
  document.documentElement.style.setProperty("--bar", bar.height + "px");
  const panel = byId("panel").getBoundingClientRect();
  const beside = panel.width < view.clientWidth / 2;
  const bottom = view.clientHeight - Math.min(bar.height ? bar.top : view.clientHeight, beside ? view.clientHeight : panel.top);
  camera.covered = [beside ? view.clientWidth - panel.left : 0, bottom];
}

function failed(error) {
  byId("message").textContent = error.message;
  byId("message").className = "error";
  document.documentElement.dataset.state = "failed";
}

window.addEventListener("error", (e) => failed(e.error ?? new Error(e.message)));
start().catch(failed);
