// Parts of the page: base 64, gzip, columns of differences (see PackedColumn in the library).
async function unpacked(id) {
  const text = document.getElementById(id).textContent.trim();
  if (!text) return null;
  const stream = new Blob([fromBase64(text)]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function fromBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

function partsOf(bytes) {
  const parts = [];
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let at = 0; at < bytes.length;) {
    const length = view.getUint32(at, true);
    parts.push(bytes.subarray(at + 4, at + 4 + length));
    at += 4 + length;
  }
  return parts;
}

const inRuns = new Set(["what", "layer", "tool", "speed"]);

// A column of numbers, scaled, into an array; returns how many there were.
function readColumn(bytes, into, runs, scale) {
  let at = 0, row = 0, value = 0;
  const number = () => {
    let result = 0, factor = 1, byte;
    do {
      byte = bytes[at++];
      result += (byte & 127) * factor;
      factor *= 128;
    } while (byte & 128);
    return result;
  };
  while (at < bytes.length) {
    const coded = number();
    value += coded % 2 ? -(coded + 1) / 2 : coded / 2;
    const count = runs ? number() : 1;
    for (let i = 0; i < count; i++) into[row++] = value * scale;
  }
  return row;
}

// The moves as columns by row. Positions are of the end of a row, relative to the middle of all; points has the start in front.
function readMoves(bytes, head) {
  const rows = head.rows;
  const parts = partsOf(bytes);
  const column = (name, type, scale = 1) => {
    const values = new type(rows);
    readColumn(parts[head.columns.indexOf(name)], values, inRuns.has(name), scale);
    return values;
  };
  const x = column("x", Float64Array, 1e-3), y = column("y", Float64Array, 1e-3), z = column("z", Float64Array, 1e-3);
  const what = column("what", Uint8Array);
  const moves = {
    rows, x, y, z,
    kind: new Uint8Array(rows), role: new Uint8Array(rows),
    layer: column("layer", Int32Array), tool: column("tool", Int16Array), line: column("line", Int32Array), move: column("move", Int32Array),
    speed: column("speed", Float32Array, 1e-2), area: column("area", Float32Array, 1e-4), time: column("time", Float64Array, 1e-3),
    width: new Float32Array(rows), height: new Float32Array(rows),
  };
  // Axes Z and X of a head that turns over the part.
  if (head.columns.includes("zx")) moves.axes = ["zx", "zy", "zz", "xx", "xy", "xz"].map((name) => column(name, Float32Array, 1e-4));
  for (let i = 0; i < rows; i++) {
    moves.kind[i] = what[i] >> 5;
    moves.role[i] = what[i] & 31;
  }
  beadSizes(moves, head);
  return moves;
}

// Width and height of each extrusion in mm, also in place; a height of 0 where it is not known and the extrusion is round.
function beadSizes(moves, head) {
  for (let i = 0; i < moves.rows; i++) {
    const area = moves.area[i];
    if (!(area > 0)) continue;
    if (moves.kind[i] === kinds.prime) {
      // A ball of its volume, or a disc where the nozzle is nearer to the bed.
      const ball = Math.cbrt(6 * area / Math.PI), z = moves.z[i];
      moves.height[i] = z > 0 && z < ball ? z : ball;
      moves.width[i] = z > 0 && z < ball ? 2 * Math.sqrt(area / (Math.PI * z)) : ball;
      continue;
    }
    const thickness = moves.layer[i] >= 0 ? head.layers[moves.layer[i]][2] : 0;
    const round = 2 * Math.sqrt(area / Math.PI);
    let width = round, height = 0;
    if (thickness > 0 && head.shape !== "Circle") {
      const full = area / thickness + (head.shape === "Stadium" ? thickness * (1 - Math.PI / 4) : 0);
      if (head.shape !== "Stadium" || full >= thickness) {
        width = full;
        height = thickness;
      }
    }
    moves.width[i] = width;
    moves.height[i] = height;
  }
}

function readModel(bytes) {
  const parts = partsOf(bytes);
  const values = parts.map((part) => {
    const numbers = new Float64Array(part.length);
    return numbers.subarray(0, readColumn(part, numbers, false, 1));
  });
  return { x: values[0].map((v) => v / 1000), y: values[1].map((v) => v / 1000), z: values[2].map((v) => v / 1000), corners: Uint32Array.from(values[3]) };
}
