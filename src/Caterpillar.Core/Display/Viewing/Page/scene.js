const textureWidth = 4096;

// Indices of one draw call are of 16 bits.
const mostCorners = 65536;

// All vertices find their place by their number alone: which row of a list, and which corner of it. Instances of so few corners draw slowly.
const fromTextures = `precision highp float; precision highp int; precision highp sampler2D; precision highp usampler2D;
uniform sampler2D points;
uniform usampler2D rows;
uniform mat4 matrix;
uniform int skip;
vec4 point(int i) { return texelFetch(points, ivec2(i % ${textureWidth}, i / ${textureWidth}), 0); }
uint rowAt(int i) { return texelFetch(rows, ivec2(i * skip % ${textureWidth}, i * skip / ${textureWidth}), 0).r; }
`;

// Beads: the ends of a row, and those of its neighbors for mitered joints, come from the texture of points.
const beadVertex = `#version 300 es
${fromTextures}
uniform sampler2D colors;
uniform vec2 around[8];
uniform int sides, first;
uniform float unit, part, thin;
uniform uint last;
uniform bool picking, joined;
out vec3 normal;
flat out vec4 color;
out vec3 place;
vec3 sideOf(vec3 d) { return length(d.xy) > 1e-6 ? normalize(vec3(d.y, -d.x, 0)) : vec3(1, 0, 0); }
void main() {
  int corner = gl_VertexID % (2 * sides);
  uint row = rowAt(first + gl_VertexID / (2 * sides));
  vec2 at = around[corner % sides];
  bool end = corner >= sides;
  int i = int(row), j = i + 1;
  vec4 a = point(i), b = point(j);
  if (skip > 1) {
    // Of rows without a gap that run on nearly straight, one bead shows all up to the next one drawn.
    int far = int(rowAt(first + gl_VertexID / (2 * sides) + 1));
    vec3 on = point(far).xyz - a.xyz;
    if (far - i == skip && uint(far) <= last && dot(normalize(b.xyz - a.xyz), normalize(on)) > 0.9
      && length(on) > 0.5 * float(skip) * length(b.xyz - a.xyz)) {
      j = far;
      b.xyz = a.xyz + on;
    }
  }
  if (row == last) b.xyz = mix(a.xyz, b.xyz, part);
  float size = abs(b.w), width = floor(size / 4096.0) * unit, height = mod(size, 4096.0) * unit;
  vec3 d = b.xyz - a.xyz;
  // Material in place stands below the nozzle.
  bool blob = b.w > 0.0 && length(d) <= 1e-6;
  if (blob) d = vec3(0, 0, 1);
  d = length(d) > 1e-6 ? normalize(d) : vec3(1, 0, 0);
  vec3 side = sideOf(d), up = cross(side, d);
  vec4 other = joined ? point(end ? j + 1 : i - 1) : vec4(0);
  // The width of a row is with its end; a row without width is no extrusion.
  float otherWidth = end ? other.w : a.w;
  vec3 o = end ? other.xyz - b.xyz : a.xyz - other.xyz;
  vec3 across = side;
  if (joined && !blob && otherWidth != 0.0 && row != last && length(o) > 1e-6 && (end || i > 0)) {
    vec3 otherSide = sideOf(normalize(o));
    float c = dot(side, otherSide);
    if (c > -0.3) across = (side + otherSide) / (1.0 + c);
  }
  vec3 p = end ? b.xyz : a.xyz;
  if (blob) p.z -= end ? 0.0 : height;
  else if (b.w > 0.0) p.z -= height * 0.5;
  if (blob) height = width;
  p += across * at.x * max(width, thin) + up * at.y * max(height, thin);
  normal = normalize(side * at.x / max(width, 1e-3) + up * at.y / max(height, 1e-3));
  color = picking ? vec4(float(row & 255u), float((row >> 8) & 255u), float((row >> 16) & 255u), float(row >> 24) + 1.0) / 255.0
    : texelFetch(colors, ivec2(i % ${textureWidth}, i / ${textureWidth}), 0);
  place = p;
  gl_Position = matrix * vec4(p, 1);
}`;

const beadFragment = `#version 300 es
precision highp float;
in vec3 normal, place;
flat in vec4 color;
uniform vec4 cut;
uniform bool picking;
uniform vec3 eyeSide, eyeBack;
out vec4 result;
void main() {
  if (dot(place, cut.xyz) > cut.w) discard;
  if (picking) { result = color; return; }
  vec3 n = normalize(normal);
  vec3 light = normalize(vec3(0, 0, 0.75) + eyeBack * 0.5 - eyeSide * 0.45);
  float bright = 0.42 + 0.5 * max(dot(n, light), 0.0) + 0.16 * max(dot(n, eyeBack), 0.0);
  result = vec4(color.rgb * bright, 1);
}`;

const lineVertex = `#version 300 es
${fromTextures}
out vec3 at;
void main() {
  at = point(int(rowAt(gl_VertexID / 2)) + gl_VertexID % 2).xyz;
  gl_Position = matrix * vec4(at, 1);
  // Travels run along the tops of extrusions; a little nearer they are seen.
  gl_Position.z -= 2e-4 * gl_Position.w;
}`;

const markVertex = `#version 300 es
${fromTextures}
uniform float size;
out vec3 at;
void main() {
  at = point(int(rowAt(gl_VertexID))).xyz;
  gl_Position = matrix * vec4(at, 1);
  gl_PointSize = size;
}`;

const plainVertex = `#version 300 es
layout(location = 0) in vec3 place;
uniform mat4 matrix;
uniform vec3 shift;
out vec3 at;
void main() { at = place + shift; gl_Position = matrix * vec4(at, 1); }`;

const plainFragment = `#version 300 es
precision highp float;
in vec3 at;
uniform vec4 tint, cut;
out vec4 result;
void main() {
  if (dot(at, cut.xyz) > cut.w) discard;
  result = tint;
}`;

const solidVertex = `#version 300 es
layout(location = 0) in vec3 place;
layout(location = 2) in vec3 facing;
uniform mat4 matrix;
uniform vec3 shift;
out vec3 normal, at;
void main() { normal = facing; at = place + shift; gl_Position = matrix * vec4(at, 1); }`;

const solidFragment = `#version 300 es
precision highp float;
in vec3 normal, at;
uniform vec4 tint, cut;
uniform vec3 eyeSide, eyeBack;
out vec4 result;
void main() {
  if (dot(at, cut.xyz) > cut.w) discard;
  vec3 n = normalize(normal);
  vec3 light = normalize(vec3(0, 0, 0.75) + eyeBack * 0.5 - eyeSide * 0.45);
  result = vec4(tint.rgb * (0.45 + 0.6 * max(dot(n, light), dot(-n, light) * 0.5)), tint.a);
}`;

// Roles that outer walls and surfaces hide: inner walls, infill, gap fill, and solid infill where top surfaces have a role of their own.
function rolesInside(roles, hidden) {
  if (!roles.includes(1) || hidden.has(1)) return new Set();
  return new Set(roles.includes(6) ? [2, 4, 5, 9] : [2, 4, 9]);
}

// Extrusions inside of a growing print that are still seen.
const newest = 10000;

// The plane beyond which nothing is shown: a normal and a distance.
const uncut = [0, 0, 0, 1];

class Scene {
  constructor(canvas, middle) {
    const gl = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
    if (!gl) throw new Error("The viewer needs WebGL 2, which this browser does not support. Use another browser.");
    this.gl = gl;
    this.canvas = canvas;
    this.middle = middle;
    this.beads = this.program(beadVertex, beadFragment);
    this.lines = this.program(lineVertex, plainFragment);
    this.marks = this.program(markVertex, plainFragment);
    this.plain = this.program(plainVertex, plainFragment);
    this.solid = this.program(solidVertex, solidFragment);
    this.shapes = [8, 6, 4, 3].map((sides) => this.shape(sides));
    this.lists = {};
    this.meshes = {};
    gl.enable(gl.DEPTH_TEST);
  }

  program(vertex, fragment) {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    const uniforms = {};
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); i++) {
      const { name } = gl.getActiveUniform(program, i);
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return { program, uniforms };
  }

  buffer(data, target = this.gl.ARRAY_BUFFER) {
    const buffer = this.gl.createBuffer();
    this.gl.bindBuffer(target, buffer);
    this.gl.bufferData(target, data, this.gl.STATIC_DRAW);
    return buffer;
  }

  // As many prisms as one draw call holds.
  shape(sides) {
    const { around, triangles } = prism(sides), most = Math.floor(mostCorners / (2 * sides)), all = new Uint16Array(most * triangles.length);
    for (let k = 0; k < most; k++) for (let i = 0; i < triangles.length; i++) all[k * triangles.length + i] = k * 2 * sides + triangles[i];
    return { sides, around, most, triangles: this.buffer(all, this.gl.ELEMENT_ARRAY_BUFFER), count: triangles.length };
  }

  texture(unit, format, type, layout, data, rows, texture = this.gl.createTexture()) {
    const gl = this.gl;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, format, textureWidth, rows, 0, layout, type, data);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
  }

  // Points with the sizes of the extrusions that end in them: 4096 · width + height in whole units, negative for round ones.
  load(moves, start) {
    const gl = this.gl, rows = Math.ceil((moves.rows + 3) / textureWidth);
    const points = new Float32Array(rows * textureWidth * 4);
    const widest = moves.width.reduce((a, b) => Math.max(a, b), 0.1);
    this.unit = Math.max(widest / 4000, 0.001);
    const printed = moves.width.filter((w) => w > 0);
    this.usualWidth = printed.reduce((sum, w) => sum + w, 0) / Math.max(printed.length, 1);
    const place = (i, x, y, z) => points.set([x - this.middle[0], y - this.middle[1], z - this.middle[2]], 4 * i);
    place(0, ...start);
    for (let i = 0; i < moves.rows; i++) {
      const at = 4 * (i + 1);
      points[at] = moves.x[i] - this.middle[0];
      points[at + 1] = moves.y[i] - this.middle[1];
      points[at + 2] = moves.z[i] - this.middle[2];
      if (!(moves.width[i] > 0)) continue;
      const width = Math.min(Math.round(moves.width[i] / this.unit), 4095), round = !(moves.height[i] > 0);
      const height = round ? width : Math.min(Math.round(moves.height[i] / this.unit), 4095);
      points[at + 3] = (width * 4096 + height) * (round ? -1 : 1);
    }
    this.points = this.texture(0, gl.RGBA32F, gl.FLOAT, gl.RGBA, points, rows);
    this.colorRows = rows;
    this.colorBytes = new Uint8Array(rows * textureWidth * 4).fill(255);
    this.colors = this.texture(1, gl.RGBA8, gl.UNSIGNED_BYTE, gl.RGBA, this.colorBytes, rows);
  }

  recolor() {
    const gl = this.gl;
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.colors);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, textureWidth, this.colorRows, gl.RGBA, gl.UNSIGNED_BYTE, this.colorBytes);
  }

  // Rows to draw, ascending, by name: extrusions outside and inside, travels, retractions, seams.
  list(name, rows) {
    const gl = this.gl, entry = this.lists[name] ??= {}, lines = Math.max(Math.ceil(rows.length / textureWidth), 1);
    const data = new Uint32Array(lines * textureWidth);
    data.set(rows);
    entry.texture = this.texture(2, gl.R32UI, gl.UNSIGNED_INT, gl.RED_INTEGER, data, lines, entry.texture);
    entry.rows = rows;
    entry.count = rows.length;
  }

  // Draws the rows up to one.
  until(row) {
    for (const [name, entry] of Object.entries(this.lists)) {
      if (name === "above") continue;
      let low = 0, high = entry.rows.length;
      while (low < high) {
        const middle = (low + high) >> 1;
        if (entry.rows[middle] <= row) low = middle + 1;
        else high = middle;
      }
      entry.count = low;
    }
  }

  mesh(name, data, floats) {
    this.meshes[name] = { buffer: this.buffer(data), count: data.length / floats };
  }

  resize() {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.round(this.canvas.clientWidth * ratio), height = Math.round(this.canvas.clientHeight * ratio);
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
  }

  use(entry, camera) {
    const gl = this.gl, { program, uniforms } = entry;
    gl.useProgram(program);
    gl.uniformMatrix4fv(uniforms.matrix, false, camera.matrix());
    if (uniforms.points) gl.uniform1i(uniforms.points, 0);
    if (uniforms.colors) gl.uniform1i(uniforms.colors, 1);
    if (uniforms.rows) gl.uniform1i(uniforms.rows, 2);
    if (uniforms.eyeBack) gl.uniform3fv(uniforms.eyeBack, camera.back);
    if (uniforms.eyeSide) gl.uniform3fv(uniforms.eyeSide, camera.right);
    for (let i = 0; i < 3; i++) gl.disableVertexAttribArray(i);
    return uniforms;
  }

  // Every n-th row of a list is drawn.
  rowsOf(name, uniforms, skip = 1) {
    const gl = this.gl, entry = this.lists[name];
    gl.activeTexture(gl.TEXTURE2);
    gl.bindTexture(gl.TEXTURE_2D, entry.texture);
    gl.uniform1i(uniforms.skip, skip);
    return Math.floor(entry.count / skip);
  }

  // The extrusions of some rows of a list, in steps of skip.
  drawBeads(list, camera, state, { picking = false, quick = picking, skip = 1, from = 0, to = Infinity } = {}) {
    if (!this.lists[list]?.count) return;
    const gl = this.gl, uniforms = this.use(this.beads, camera), count = Math.min(this.rowsOf(list, uniforms, skip), to);
    gl.uniform1f(uniforms.unit, this.unit);
    gl.uniform1f(uniforms.part, state.part);
    // Extrusions thinner than a pixel would flicker.
    const pixel = camera.distance * 2 * Math.tan(0.35) / this.canvas.height;
    gl.uniform1f(uniforms.thin, pixel * (picking ? 3 : 0.8));
    gl.uniform1ui(uniforms.last, state.part < 1 ? state.row : 0xffffffff);
    gl.uniform1i(uniforms.picking, picking ? 1 : 0);
    gl.uniform1i(uniforms.joined, quick ? 0 : 1);
    gl.uniform4fv(uniforms.cut, state.cut);
    const across = this.usualWidth / pixel, shape = this.shapes[quick ? 3 : across < 5 || count >= 300000 ? 2 : across < 10 || count >= 60000 ? 1 : 0];
    // Corners run clockwise as seen from outside.
    gl.enable(gl.CULL_FACE);
    gl.cullFace(gl.FRONT);
    gl.uniform1i(uniforms.sides, shape.sides);
    gl.uniform2fv(uniforms["around[0]"], shape.around);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, shape.triangles);
    for (let first = from; first < count; first += shape.most) {
      gl.uniform1i(uniforms.first, first);
      gl.drawElements(gl.TRIANGLES, Math.min(shape.most, count - first) * shape.count, gl.UNSIGNED_SHORT, 0);
    }
    gl.disable(gl.CULL_FACE);
  }

  drawRows(program, name, camera, tint, cut, mode, points, size) {
    if (!this.lists[name]?.count) return;
    const gl = this.gl, uniforms = this.use(program, camera);
    gl.uniform4fv(uniforms.tint, tint);
    gl.uniform4fv(uniforms.cut, cut);
    if (uniforms.size) gl.uniform1f(uniforms.size, size);
    gl.drawArrays(mode, 0, points * this.rowsOf(name, uniforms));
  }

  drawLines(name, camera, tint, shift = [0, 0, 0]) {
    const mesh = this.meshes[name];
    if (!mesh?.count) return;
    const gl = this.gl, uniforms = this.use(this.plain, camera);
    gl.uniform4fv(uniforms.tint, tint);
    gl.uniform4fv(uniforms.cut, uncut);
    gl.uniform3fv(uniforms.shift, shift);
    gl.bindBuffer(gl.ARRAY_BUFFER, mesh.buffer);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.drawArrays(gl.LINES, 0, mesh.count);
  }

  drawSolid(name, camera, tint, shift, cut = uncut) {
    const mesh = this.meshes[name];
    if (!mesh?.count) return;
    const gl = this.gl, uniforms = this.use(this.solid, camera);
    gl.uniform4fv(uniforms.tint, tint);
    gl.uniform4fv(uniforms.cut, cut);
    gl.uniform3fv(uniforms.shift, shift);
    gl.bindBuffer(gl.ARRAY_BUFFER, mesh.buffer);
    for (const [location, offset] of [[0, 0], [2, 12]]) {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 24, offset);
    }
    gl.drawArrays(gl.TRIANGLES, 0, mesh.count);
  }

  // Quickly: every n-th extrusion that is seen from outside, with three sides, without joints, and with edges as they fall. In a print that grows, the newest
  // infill is seen, too; where it is cut, all of it is.
  drawQuickly(camera, state, skip) {
    this.resize();
    this.drawBackground(camera, state);
    this.drawBeads("outside", camera, state, { quick: true, skip });
    const inside = this.lists.inside;
    if (state.cut !== uncut) this.drawBeads("inside", camera, state, { quick: true, skip });
    else if (inside?.count < inside?.rows.length) this.drawBeads("inside", camera, state, { quick: true, from: Math.max(inside.count - newest, 0) });
    this.drawForeground(camera, state);
  }

  // All extrusions, with edges smooth or as they fall, in steps between which others may draw. Those that are seen from outside come first: they hide most
  // others, and with edges as they fall they are shown as soon as they are there.
  *drawWhole(camera, state, extrusions = Infinity, smooth = true) {
    const gl = this.gl;
    this.resize();
    const target = smooth ? this.smoothTarget() : this.roughTarget();
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
    this.drawBackground(camera, state);
    for (const list of ["outside", "inside"]) {
      // From above the last come first, so that what they hide takes less time.
      const pieces = Math.max(Math.ceil((this.lists[list]?.count ?? 0) / extrusions), 1);
      for (let done = 0; done < pieces; done++) {
        const from = pieces === 1 ? 0 : (camera.back[2] > 0 ? pieces - 1 - done : done) * extrusions;
        gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
        this.drawBeads(list, camera, state, { quick: !smooth, from, to: from + extrusions });
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        yield;
      }
      if (list === "outside" && !smooth) this.show(this.copy(target), camera, state);
    }
    this.show(target, camera, state);
  }

  // Draws what belongs in front of an image in memory, and shows it.
  show({ frame, width, height }, camera, state) {
    const gl = this.gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    this.drawForeground(camera, state);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  copy({ frame, width, height }) {
    const gl = this.gl, copied = this.pickTarget();
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, frame);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, copied.frame);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT, gl.NEAREST);
    return copied;
  }

  drawBackground(camera, state) {
    const gl = this.gl;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(...state.background, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    if (!state.bed) return;
    const gray = (light, dark) => [state.dark ? dark : light, state.dark ? dark : light, state.dark ? dark : light, 1];
    this.drawLines("bedThin", camera, gray(0.83, 0.24));
    this.drawLines("bedBold", camera, gray(0.5, 0.5));
  }

  drawForeground(camera, state) {
    const gl = this.gl, ink = state.dark ? 1 : 0;
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    if (state.above) this.drawRows(this.lines, "above", camera, [ink, ink, ink, 0.25], state.cut, gl.LINES, 2);
    gl.disable(gl.BLEND);
    if (state.travel) this.drawRows(this.lines, "travels", camera, [0.35, 0.5, 0.85, 1], state.cut, gl.LINES, 2);
    gl.disable(gl.DEPTH_TEST);
    if (state.retractions) this.drawRows(this.marks, "retractions", camera, [0.85, 0.2, 0.55, 1], state.cut, gl.POINTS, 1, 5);
    if (state.seams) this.drawRows(this.marks, "seams", camera, [ink, ink, ink, 1], state.cut, gl.POINTS, 1, 5);
    gl.enable(gl.DEPTH_TEST);
    if (state.model) this.drawSolid("model", camera, [0.62, 0.74, 0.6, 1], [0, 0, 0], state.cut);
    if (state.head && state.nozzle) {
      // What lies behind the head stays visible.
      this.drawLines("headBoxes", camera, [0.45, 0.5, 0.58, 1], state.nozzle);
      gl.enable(gl.BLEND);
      gl.depthMask(false);
      this.drawSolid("head", camera, [0.4, 0.45, 0.52, 0.22], state.nozzle);
      gl.depthMask(true);
      gl.disable(gl.BLEND);
    }
  }

  // The row under a place of the canvas in CSS pixels, or -1.
  pick(camera, state, x, y) {
    const gl = this.gl, ratio = this.canvas.width / this.canvas.clientWidth;
    const px = Math.floor(x * ratio), py = this.canvas.height - 1 - Math.floor(y * ratio);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.pickTarget().frame);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(px, py, 1, 1);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (const list of ["outside", "inside"]) this.drawBeads(list, camera, state, { picking: true });
    const color = new Uint8Array(4);
    gl.readPixels(px, py, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, color);
    gl.disable(gl.SCISSOR_TEST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return color[3] === 0 ? -1 : color[0] + color[1] * 256 + color[2] * 65536 + (color[3] - 1) * 16777216;
  }

  pickTarget() { return this.pickFrame = this.target(this.pickFrame, 0); }

  roughTarget() { return this.roughFrame = this.target(this.roughFrame, 0); }

  smoothTarget() { return this.smoothFrame = this.target(this.smoothFrame, Math.min(4, this.gl.getParameter(this.gl.MAX_SAMPLES))); }

  // An image in memory of the size of the canvas: the one there is, or a new one.
  target(old, samples) {
    const gl = this.gl, { width, height } = this.canvas;
    if (old?.width === width && old.height === height) return old;
    if (old) {
      gl.deleteFramebuffer(old.frame);
      gl.deleteRenderbuffer(old.color);
      gl.deleteRenderbuffer(old.depth);
    }
    const frame = gl.createFramebuffer(), color = gl.createRenderbuffer(), depth = gl.createRenderbuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    for (const [buffer, format, attachment] of [[color, gl.RGBA8, gl.COLOR_ATTACHMENT0], [depth, gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]]) {
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return { frame, color, depth, width, height };
  }
}
