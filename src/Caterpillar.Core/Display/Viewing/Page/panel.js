const byId = (id) => document.getElementById(id);

function element(tag, properties = {}, ...children) {
  const node = Object.assign(document.createElement(tag), properties);
  node.append(...children);
  return node;
}

function number(value, decimals = 2) {
  const text = value.toFixed(decimals);
  return decimals > 0 ? text.replace(/\.?0+$/, "") : text;
}

function duration(seconds) {
  const whole = seconds < 3600 ? Math.round(seconds) : Math.round(seconds / 60) * 60;
  const [h, m, s] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  return h > 0 ? `${h} h ${m} min` : m > 0 ? `${m} min ${s} s` : `${number(seconds, seconds < 10 ? 1 : 0)} s`;
}

function fillTable(table, rows) {
  table.replaceChildren(...rows.map(([name, value]) => element("tr", {}, element("td", {}, name), element("td", {}, value))));
}

// Sums over all rows, and by role.
function sums(moves, start) {
  const all = { printed: 0, travel: 0, volume: 0, retractions: 0, roles: new Map() };
  let [x, y, z] = start, before = 0;
  for (let i = 0; i < moves.rows; i++) {
    const length = Math.hypot(moves.x[i] - x, moves.y[i] - y, moves.z[i] - z);
    const seconds = moves.time[i] - before;
    [x, y, z, before] = [moves.x[i], moves.y[i], moves.z[i], moves.time[i]];
    if (moves.kind[i] === kinds.print) {
      all.printed += length;
      all.volume += length * moves.area[i];
      const role = all.roles.get(moves.role[i]) ?? { length: 0, seconds: 0, volume: 0 };
      role.length += length;
      role.seconds += seconds;
      role.volume += length * moves.area[i];
      all.roles.set(moves.role[i], role);
    } else if (moves.kind[i] === kinds.prime) all.volume += moves.area[i];
    else if (moves.kind[i] === kinds.retract) all.retractions++;
    else all.travel += length;
  }
  return all;
}

function showStatistics(moves, head, total, box, layers) {
  const rows = [];
  const size = [0, 1, 2].map((i) => number(box[1][i] - box[0][i], 1)).join(" × ");
  if (moves) {
    if (head.timed) rows.push(["Print time", duration(moves.rows ? moves.time[moves.rows - 1] : 0)]);
    rows.push(["Size", size + " mm"]);
    if (layers) rows.push(["Layers", String(layers)]);
    rows.push(["Print length", number(total.printed / 1000) + " m"]);
    rows.push(["Travel length", number(total.travel / 1000) + " m"]);
    if (total.volume > 0) rows.push(["Material", number(total.volume / 1000) + " cm³" + (head.density ? `, ${number(total.volume / 1000 * head.density)} g` : "")]);
    rows.push(["Retractions", String(total.retractions)], ["Moves", String(head.moves)]);
  } else rows.push(["Size", size + " mm"]);
  if (head.printer) rows.push(["Printer", head.printer.title]);
  if (head.timed && head.limits) rows.push(["Times from", head.limits]);
  fillTable(byId("statistics"), rows);
}

// The legend: names with switches for categories, a scale with ticks for values.
function showLegend(coloring, range, head, total, hidden, toggled) {
  const legend = byId("legend");
  if (!coloring.category) {
    const isDuration = coloring.unit === "s" && range.high >= 100, last = isDuration ? 2 : 4;
    const at = (part) => coloring.log ? range.low * (range.high / range.low) ** part : range.low + (range.high - range.low) * part;
    const ticks = Array.from({ length: last + 1 }, (_, i) => at(i / last));
    const decimals = range.high - range.low > 20 ? 0 : range.high - range.low > 1 ? 1 : 3;
    const show = isDuration ? (v) => duration(v) : (v) => number(v, decimals);
    const edge = (i) => (i === 0 && range.clippedLow ? "≤ " : i === last && range.clippedHigh ? "≥ " : "");
    legend.replaceChildren(
      element("div", { className: "scale", style: `background: linear-gradient(to right, ${head.scale.join(", ")})` }),
      element("div", { className: "ticks" }, ...(range.high > range.low ? ticks : [range.low]).map((v, i) => element("span", {}, edge(i) + show(v)))),
      element("div", { className: "ticks" }, element("span", {}, isDuration ? "" : coloring.unit)));
    return;
  }
  if (coloring.id !== "role") {
    legend.replaceChildren(...coloring.category.map(([name, color]) => element("div", { className: "entry" }, element("span"),
      element("span", { className: "swatch", style: `background: ${color}` }), element("span", {}, name))));
    return;
  }
  const used = [...total.roles.keys()].sort((a, b) => a - b);
  const whole = { seconds: 0, volume: 0 };
  for (const sum of total.roles.values()) {
    whole.seconds += sum.seconds;
    whole.volume += sum.volume;
  }
  const share = (part, of) => of > 0 ? number(100 * part / of, 0) + " %" : "";
  const cell = (text, title) => element("span", { className: "amount", title }, text);
  const header = element("div", { className: "entry header" }, ...[head.timed ? "Time" : "Length", "", "Material"].map((name) => cell(name, "")));
  legend.replaceChildren(header, ...used.map((role) => {
    const box = element("input", { type: "checkbox", checked: !hidden.has(role) });
    box.addEventListener("change", () => toggled(role, !box.checked));
    const sum = total.roles.get(role);
    const amount = head.timed ? duration(sum.seconds) : number(sum.length / 1000) + " m";
    return element("label", { className: "entry" }, box, element("span", { className: "swatch", style: `background: ${head.roles[role][1]}` }),
      element("span", {}, head.roles[role][0]), cell(amount, head.timed ? "Printing time" : "Length"),
      cell(head.timed ? share(sum.seconds, whole.seconds) : "", "Share of the printing time"), cell(share(sum.volume, whole.volume), "Share of the material"));
  }));
}

function showFindings(head, go) {
  const count = head.findings.length;
  byId("findingsSection").hidden = count === 0;
  byId("findingsCount").textContent = count === 0 ? "" : `${count} ${count === 1 ? "finding" : "findings"}`;
  const rank = { Error: 0, Warning: 1 };
  const sorted = [...head.findings].sort((a, b) => (rank[a.severity] ?? 2) - (rank[b.severity] ?? 2));
  byId("findings").replaceChildren(...sorted.map((finding) => {
    const text = `${finding.message}${finding.count > 1 ? ` (${finding.count} times)` : ""}`;
    const button = element("button", { className: finding.severity, title: `${finding.severity} ${finding.code} ${finding.place}` }, text);
    button.addEventListener("click", () => go(finding));
    return element("li", {}, button);
  }));
}

function showMove(row, moves, head, measured = []) {
  if (row < 0 || row >= moves.rows) {
    fillTable(byId("picked"), [["Click an extrusion for details.", ""]]);
    return;
  }
  const layer = moves.layer[row] >= 0 ? head.layers[moves.layer[row]] : null;
  const rows = [];
  if (moves.line[row] >= 0) rows.push([head.source === "line" ? "Line" : "Step", String(moves.line[row])]);
  rows.push(["Move", `${moves.move[row]}, ${head.kinds[moves.kind[row]].toLowerCase()}`]);
  if (moves.kind[row] === kinds.print) rows.push(["Role", head.roles[moves.role[row]][0]]);
  rows.push(["To", `${number(moves.x[row], 3)}, ${number(moves.y[row], 3)}, ${number(moves.z[row], 3)} mm`]);
  rows.push(["Speed", number(moves.speed[row]) + " mm/s"]);
  if (moves.area[row] > 0) {
    rows.push(["Width × height", `${number(moves.width[row], 3)} × ${number(moves.height[row] || moves.width[row], 3)} mm`]);
    rows.push(["Volumetric flow", number(moves.area[row] * moves.speed[row], 2) + " mm³/s"]);
  }
  if (layer) rows.push(["Layer", `${layer[0]}, Z ${number(layer[1], 3)} mm${layer[3] ? ", " + layer[3] : ""}`]);
  if (head.timed) rows.push(["Time", duration(moves.time[row])]);
  fillTable(byId("picked"), [...rows, ...measured]);
}

// The lines of the file around one, unpacked when they are first asked for.
class FileLines {
  constructor() { this.starts = null; }

  async load() {
    if (this.starts) return;
    this.bytes = await unpacked("gcodeData") ?? new Uint8Array(0);
    const starts = [0];
    for (let i = 0; i < this.bytes.length; i++) if (this.bytes[i] === 10 || (this.bytes[i] === 13 && this.bytes[i + 1] !== 10)) starts.push(i + 1);
    this.starts = starts;
  }

  get count() { return this.starts.length; }

  byte(line) { return this.bytes[this.starts[line - 1]]; }

  text(line) {
    const end = this.starts[line] ?? this.bytes.length;
    return new TextDecoder().decode(this.bytes.subarray(this.starts[line - 1], end)).replace(/[\r\n]+$/, "");
  }

  async show(line, out) {
    await this.load();
    if (this.bytes.length === 0 || line < 1) {
      out.replaceChildren();
      return;
    }
    const entries = [];
    const around = 7;
    for (let n = Math.max(1, line - around); n <= Math.min(this.starts.length, line + around); n++) {
      entries.push(element("div", { className: n === line ? "now" : "" }, `${n}  ${this.text(n)}`));
    }
    out.replaceChildren(...entries);
  }
}
