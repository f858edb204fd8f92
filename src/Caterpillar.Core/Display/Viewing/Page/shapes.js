// A prism around a segment: its corners as (across, up) on a circle of diameter 1, and triangles of the corners of the start and, after them, of the end,
// closed at both ends.
function prism(sides) {
  // The quickest has a flat bottom: it closes the whole height.
  const around = sides === 3 ? [-0.5, -0.5, 0.5, -0.5, 0, 0.5] : [], triangles = [];
  for (let i = 0; i < sides && sides > 3; i++) {
    const angle = 2 * Math.PI * (i + (sides > 4 ? 0.5 : 0)) / sides;
    const grow = sides > 4 ? 1 / Math.cos(Math.PI / sides) : 1;
    around.push(Math.cos(angle) * grow / 2, Math.sin(angle) * grow / 2);
  }
  for (let i = 0; i < sides; i++) {
    const next = (i + 1) % sides;
    triangles.push(i, next, sides + i, next, sides + next, sides + i);
  }
  for (let i = 2; i < sides; i++) triangles.push(0, i, i - 1, sides, sides + i - 1, sides + i);
  return { around: new Float32Array(around), triangles };
}

// Nozzle and head around their axis as triangles with flat normals: x y z nx ny nz each.
function headMesh(printer) {
  const out = [];
  const face = (...points) => {
    for (let i = 2; i < points.length; i++) {
      const [a, b, c] = [points[0], points[i - 1], points[i]];
      const n = cross(add(b, times(a, -1)), add(c, times(a, -1)));
      const length = Math.hypot(...n) || 1;
      for (const p of [a, b, c]) out.push(...p, ...times(n, 1 / length));
    }
  };
  const around = 32, rings = [];
  for (let i = 0; i < printer.head.length; i += 2) rings.push([printer.head[i], printer.head[i + 1]]);
  if (rings.length && rings[0][0] > 0) rings.unshift([0, rings[0][1]]);
  const last = rings[rings.length - 1];
  if (last) rings.push([last[0], last[1] + 8]);
  const at = (ring, k) => [ring[0] * Math.cos(2 * Math.PI * k / around), ring[0] * Math.sin(2 * Math.PI * k / around), ring[1]];
  for (let r = 1; r < rings.length; r++) {
    for (let k = 0; k < around; k++) face(at(rings[r - 1], k), at(rings[r - 1], k + 1), at(rings[r], k + 1), at(rings[r], k));
  }
  return new Float32Array(out);
}

// Points, or points with normals, of a head whose axes Z and X lie along the given ones.
function turned(numbers, axes) {
  const unit = (v) => times(v, 1 / (Math.hypot(...v) || 1));
  const z = unit(axes.slice(0, 3)), y = unit(cross(z, axes.slice(3))), x = cross(y, z), out = new Float32Array(numbers.length);
  for (let i = 0; i < numbers.length; i += 3) {
    for (let k = 0; k < 3; k++) out[i + k] = x[k] * numbers[i] + y[k] * numbers[i + 1] + z[k] * numbers[i + 2];
  }
  return out;
}

// The edges of the boxes of the head; x y z by point.
function headBoxLines(printer) {
  const out = [];
  for (let b = 0; b < printer.boxes.length; b += 6) {
    const corner = (i) => [0, 1, 2].map((axis) => printer.boxes[b + axis + (i >> axis & 1) * 3]);
    for (let i = 0; i < 8; i++) for (const bit of [1, 2, 4]) if (!(i & bit)) out.push(...corner(i), ...corner(i | bit));
  }
  return new Float32Array(out);
}

// Lines of the bed every 10 mm, its edge, and the edges of the volume; x y z by point, relative to the middle.
function bedLines(printer, middle) {
  const { min, max } = printer;
  const thin = [], bold = [];
  const line = (list, a, b) => list.push(...add(a, times(middle, -1)), ...add(b, times(middle, -1)));
  const half = [(max[0] - min[0]) / 2, (max[1] - min[1]) / 2], mid = [(max[0] + min[0]) / 2, (max[1] + min[1]) / 2];
  const reach = (d, a, b) => printer.round ? b * Math.sqrt(Math.max(0, 1 - (d / a) ** 2)) : b;
  for (let x = Math.ceil(min[0] / 10) * 10; x <= max[0]; x += 10) {
    const r = reach(x - mid[0], half[0], half[1]);
    line(thin, [x, mid[1] - r, 0], [x, mid[1] + r, 0]);
  }
  for (let y = Math.ceil(min[1] / 10) * 10; y <= max[1]; y += 10) {
    const r = reach(y - mid[1], half[1], half[0]);
    line(thin, [mid[0] - r, y, 0], [mid[0] + r, y, 0]);
  }
  const outline = [];
  if (printer.round) {
    for (let k = 0; k <= 72; k++) outline.push([mid[0] + half[0] * Math.cos(k * Math.PI / 36), mid[1] + half[1] * Math.sin(k * Math.PI / 36)]);
  } else outline.push([min[0], min[1]], [max[0], min[1]], [max[0], max[1]], [min[0], max[1]], [min[0], min[1]]);
  for (let i = 1; i < outline.length; i++) {
    line(bold, [...outline[i - 1], 0], [...outline[i], 0]);
    line(thin, [...outline[i - 1], max[2]], [...outline[i], max[2]]);
    if (!printer.round) line(thin, [...outline[i], 0], [...outline[i], max[2]]);
  }
  for (let e = 0; e < printer.excluded.length; e += 6) {
    const [x0, y0, , x1, y1] = printer.excluded.slice(e, e + 6);
    line(bold, [x0, y0, 0], [x1, y1, 0]);
    line(bold, [x0, y1, 0], [x1, y0, 0]);
    for (const [a, b] of [[[x0, y0], [x1, y0]], [[x1, y0], [x1, y1]], [[x1, y1], [x0, y1]], [[x0, y1], [x0, y0]]]) line(bold, [...a, 0], [...b, 0]);
  }
  return { thin: new Float32Array(thin), bold: new Float32Array(bold) };
}

// A mesh as triangles with flat normals.
function modelTriangles(model, middle) {
  const out = new Float32Array(model.corners.length * 6);
  for (let i = 0; i < model.corners.length; i += 3) {
    const p = [0, 1, 2].map((k) => {
      const v = model.corners[i + k];
      return [model.x[v] - middle[0], model.y[v] - middle[1], model.z[v] - middle[2]];
    });
    const n = cross(add(p[1], times(p[0], -1)), add(p[2], times(p[0], -1)));
    const length = Math.hypot(...n) || 1;
    for (let k = 0; k < 3; k++) out.set([...p[k], ...times(n, 1 / length)], (i + k) * 6);
  }
  return out;
}
