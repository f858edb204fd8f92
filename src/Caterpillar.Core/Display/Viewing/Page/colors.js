const kinds = { print: 0, travel: 1, wipe: 2, retract: 3, deretract: 4, movingDeretract: 5, prime: 6, dwell: 7 };

const rgb = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));

function scaleColor(scale, part) {
  const place = Math.min(Math.max(part, 0), 1) * (scale.length - 1);
  const band = Math.min(Math.floor(place), scale.length - 2);
  return [0, 1, 2].map((i) => scale[band][i] + (scale[band + 1][i] - scale[band][i]) * (place - band));
}

// For every row the value that an event set last: nozzle or bed temperature, fan.
function eventValues(moves, head, name) {
  const values = new Float32Array(moves.rows);
  let row = 0, value = 0;
  for (const [at, what, next] of head.events) {
    if (what !== name) continue;
    values.fill(value, row, at);
    row = at;
    value = next;
  }
  values.fill(value, row);
  return values;
}

const toolColors = ["#e07b39", "#3b7dd8", "#4ca64c", "#b04fb0", "#c9a227", "#2aa6a6", "#c0392b", "#7f8c8d"];

const toolsOf = (moves) => [...new Set(moves.tool)].sort((a, b) => a - b);

// What colors can show. A category has names and colors of its own, all others run over a scale.
function colorings(moves, head) {
  const map = (f) => {
    const values = new Float32Array(moves.rows);
    for (let i = 0; i < moves.rows; i++) values[i] = f(i);
    return values;
  };
  const tools = toolsOf(moves);
  const list = [
    { id: "role", name: "Role", of: (i) => moves.role[i], category: head.roles },
    { id: "speed", name: "Speed", unit: "mm/s", of: (i) => moves.speed[i] },
    { id: "flow", name: "Volumetric flow", unit: "mm³/s", of: (i) => moves.area[i] * moves.speed[i] },
    { id: "width", name: "Line width", unit: "mm", of: (i) => moves.width[i] },
    { id: "height", name: "Layer height", unit: "mm", of: (i) => (moves.layer[i] >= 0 ? head.layers[moves.layer[i]][2] : 0) },
    { id: "layer", name: "Layer", unit: "", of: (i) => moves.layer[i] },
    head.timed ? { id: "time", name: "Time", unit: "s", of: (i) => moves.time[i] } : { id: "time", name: "Order", unit: "", of: (i) => i },
    { id: "layertime", name: "Layer time", unit: "s", lazy: () => layerTimes(moves, head) },
    { id: "layertimelog", name: "Layer time (logarithmic)", unit: "s", log: true, lazy: () => layerTimes(moves, head) },
    { id: "tool", name: "Tool", of: (i) => Math.max(tools.indexOf(moves.tool[i]), 0), category: tools.map((t, i) => [`T${t}`, toolColors[i % toolColors.length]]) },
    { id: "temperature", name: "Nozzle temperature", unit: "°C", lazy: () => eventValues(moves, head, "nozzle") },
    { id: "acceleration", name: "Acceleration", unit: "mm/s²", lazy: () => eventValues(moves, head, "acceleration") },
    { id: "fan", name: "Fan speed", unit: "%", lazy: () => eventValues(moves, head, "fan").map((v) => v * 100) },
  ];
  const lacks = (c) => (!head.timed && c.id.startsWith("layertime")) || (c.id === "acceleration" && !head.events.some((e) => e[1] === "acceleration"));
  for (const coloring of list) {
    let values = null;
    coloring.values = () => (values ??= coloring.lazy ? coloring.lazy() : map(coloring.of));
  }
  return list.filter((c) => !lacks(c));
}

// Colors of filaments by tool, and where others are loaded, from the comments of slicers and from M600.
function filamentsIn(lines) {
  const colors = { filament: [], extruder: [] }, changes = [];
  const semicolon = 59, letterM = 77;
  let announced = {};
  for (let line = 1; line <= lines.count; line++) {
    const first = lines.byte(line);
    if (first !== semicolon && first !== letterM) continue;
    const text = lines.text(line), named = /^;\s*(filament|extruder)_colou?r\s*=(.*)/i.exec(text);
    const change = /^;\s*COLOR_CHANGE\b(?:,T(\d+))?(?:,(#[0-9a-f]{6}))?/i.exec(text);
    if (named) colors[named[1].toLowerCase()] = named[2].split(";").map((color) => /#[0-9a-f]{6}/i.exec(color)?.[0]);
    else if (change) announced = { tool: change[1] && Number(change[1]), color: change[2] };
    else if (/^M600\b/.test(text)) {
      changes.push({ ...announced, line });
      announced = {};
    }
  }
  return { colors: colors.filament.map((color, i) => colors.extruder[i] ?? color), changes };
}

// The colors that are really seen, if the file names any: of each tool, and after each change.
function filamentColoring(moves, head, { colors, changes }) {
  if (!changes.length && !colors.some(Boolean)) return null;
  const tools = toolsOf(moves), values = new Float32Array(moves.rows), loaded = new Map(tools.map((tool, i) => [tool, i]));
  const category = tools.map((tool, i) => [`T${tool}`, colors[tool] ?? toolColors[i % toolColors.length]]), found = [];
  for (let i = 0; i < moves.rows; i++) {
    while (found.length < changes.length && moves.line[i] > changes[found.length].line) {
      const { tool = moves.tool[i], color = toolColors[category.length % toolColors.length] } = changes[found.length];
      loaded.set(tool, category.length);
      category.push([`T${tool} from Z ${number(moves.z[i], 3)} mm`, color]);
      found.push({ row: i, color });
    }
    values[i] = loaded.get(moves.tool[i]);
  }
  return { id: "filament", name: "Filament", category, values: () => values, changes: found };
}

function layerTimes(moves, head) {
  const sums = new Float64Array(head.layers.length + 1);
  for (let i = 0; i < moves.rows; i++) sums[moves.layer[i] + 1] += moves.time[i] - (i > 0 ? moves.time[i - 1] : 0);
  return Float32Array.from({ length: moves.rows }, (_, i) => sums[moves.layer[i] + 1]);
}

// The scale leaves out what start code prints, and the rarest values at both ends, so that one odd extrusion does not hide all differences.
function rangeOf(values, moves, head) {
  const sample = [];
  const step = Math.max(1, Math.floor(moves.rows / 20000));
  let least = Infinity, greatest = -Infinity;
  for (let i = 0; i < moves.rows; i++) {
    if (moves.kind[i] !== kinds.print || !(moves.area[i] > 0) || head.roles[moves.role[i]][0] === "Purge") continue;
    least = Math.min(least, values[i]);
    greatest = Math.max(greatest, values[i]);
    if (i % step === 0) sample.push(values[i]);
  }
  if (!(greatest >= least)) return { low: 0, high: 0, clippedLow: false, clippedHigh: false };
  sample.sort((a, b) => a - b);
  const low = sample.length > 100 ? sample[Math.floor(sample.length * 0.005)] : least;
  const high = sample.length > 100 ? sample[Math.ceil(sample.length * 0.995) - 1] : greatest;
  return high > low ? { low, high, clippedLow: least < low, clippedHigh: greatest > high } : { low: least, high: greatest };
}

// A color for each row, four bytes each.
function paint(coloring, moves, head, into) {
  const values = coloring.values();
  const scale = head.scale.map(rgb);
  if (coloring.category) {
    const colors = coloring.category.map((entry) => rgb(entry[1]));
    for (let i = 0; i < moves.rows; i++) {
      const color = colors[values[i]] ?? colors[0];
      into[4 * i] = color[0];
      into[4 * i + 1] = color[1];
      into[4 * i + 2] = color[2];
    }
    return null;
  }
  const range = rangeOf(values, moves, head);
  if (coloring.log) range.low = Math.max(range.low, range.high / 1e4, 1e-3);
  const place = coloring.log ? (v) => Math.log(Math.max(v, 1e-9)) : (v) => v;
  const low = place(range.low), size = Math.max(place(range.high) - low, 1e-9);
  const table = Array.from({ length: 256 }, (_, i) => scaleColor(scale, i / 255));
  for (let i = 0; i < moves.rows; i++) {
    const color = table[Math.min(Math.max(Math.round((place(values[i]) - low) / size * 255), 0), 255)];
    into[4 * i] = color[0];
    into[4 * i + 1] = color[1];
    into[4 * i + 2] = color[2];
  }
  return range;
}
