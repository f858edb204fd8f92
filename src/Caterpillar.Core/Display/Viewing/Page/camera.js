// Matrices by columns, as WebGL takes them.
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const times = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

function multiply(a, b) {
  const c = new Float32Array(16);
  for (let i = 0; i < 4; i++) for (let j = 0; j < 4; j++) for (let k = 0; k < 4; k++) c[4 * j + i] += a[4 * k + i] * b[4 * j + k];
  return c;
}

// Turns around a target; Z is up. Angles in radians, lengths in mm.
class Camera {
  constructor(canvas, changed) {
    this.canvas = canvas;
    this.changed = changed;
    this.target = [0, 0, 0];
    this.distance = 100;
    this.azimuth = -Math.PI / 3;
    this.elevation = 0.5;
    this.box = [[-1, -1, -1], [1, 1, 1]];
    // Whether the box is in view as a whole, because nobody has zoomed or panned since.
    this.isFitted = false;
    // What the panels cover, CSS pixels from the right and from the bottom.
    this.covered = [0, 0];
    this.listen();
  }

  get back() {
    const c = Math.cos(this.elevation);
    return [Math.cos(this.azimuth) * c, Math.sin(this.azimuth) * c, Math.sin(this.elevation)];
  }

  get right() { return [-Math.sin(this.azimuth), Math.cos(this.azimuth), 0]; }

  get eye() { return add(this.target, times(this.back, this.distance)); }

  look(azimuth, elevation) {
    this.azimuth = azimuth * Math.PI / 180;
    this.elevation = elevation * Math.PI / 180;
    this.fit(this.box);
  }

  // As near as all eight corners of the box stay in what the panels leave free, and in its middle. Perspective enlarges the near ones.
  fit(box) {
    this.box = box;
    const middle = times(add(box[0], box[1]), 0.5), back = this.back, right = this.right, up = cross(back, right);
    const corners = Array.from({ length: 8 }, (_, i) => [0, 1, 2].map((k) => box[i >> k & 1][k] - middle[k]));
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const axes = [[right, width - this.covered[0]], [up, height - this.covered[1]]];
    // What the picture shows of an axis on one side of its middle, for each mm of distance from the eye.
    const nearest = axes.map(([axis, free]) => {
      const seen = 0.94 * Math.tan(0.35) * Math.max(free / Math.max(height, 1), 0.2);
      const [above, below] = [1, -1].map((side) => Math.max(...corners.map((c) => side * dot(c, axis) / seen + dot(c, back))));
      return (above + below) / 2;
    });
    this.distance = Math.max(1 / Math.sin(0.35), ...nearest);
    this.target = middle;
    for (const [axis] of axes) {
      let shift = 0;
      for (let i = 0; i < 20; i++) {
        const seen = corners.map((c) => (dot(c, axis) - shift) / (this.distance - dot(c, back)));
        shift += (Math.min(...seen) + Math.max(...seen)) / 2 * this.distance;
      }
      this.target = add(this.target, times(axis, shift));
    }
    this.isFitted = true;
    this.changed();
  }

  // For a window or panels of another size.
  refit() {
    if (this.isFitted) this.fit(this.box);
    else this.changed();
  }

  approach(target, distance) {
    this.target = target;
    this.distance = Math.min(this.distance, distance);
    this.isFitted = false;
    this.changed();
  }

  matrix() {
    const back = this.back, right = this.right, up = cross(back, right), eye = this.eye;
    const view = new Float32Array([right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2], back[2], 0,
      -dot(right, eye), -dot(up, eye), -dot(back, eye), 1]);
    const reach = Math.hypot(...[0, 1, 2].map((i) => this.box[1][i] - this.box[0][i])) + 600;
    const near = Math.max(this.distance / 400, 0.05), far = this.distance + reach * 2;
    const f = 1 / Math.tan(0.35), aspect = this.canvas.width / Math.max(this.canvas.height, 1);
    const projection = new Float32Array([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0]);
    return multiply(this.aside(), multiply(projection, view));
  }

  // Moves the image to the middle of what the panels leave free.
  aside() {
    const shift = new Float32Array(16);
    for (let i = 0; i < 4; i++) shift[5 * i] = 1;
    shift[12] = -this.covered[0] / Math.max(this.canvas.clientWidth, 1);
    shift[13] = this.covered[1] / Math.max(this.canvas.clientHeight, 1);
    return shift;
  }

  turn(dx, dy) {
    this.azimuth -= dx * 0.008;
    this.elevation = Math.min(Math.max(this.elevation + dy * 0.008, -Math.PI / 2), Math.PI / 2);
    this.changed();
  }

  pan(dx, dy) {
    const size = this.distance * 2 * Math.tan(0.35) / this.canvas.clientHeight;
    const up = cross(this.back, this.right);
    this.target = add(this.target, add(times(this.right, -dx * size), times(up, dy * size)));
    this.isFitted = false;
    this.changed();
  }

  // The line of sight through a place of the canvas: a point and a direction.
  ray(x, y) {
    const size = this.distance * 2 * Math.tan(0.35) / this.canvas.clientHeight, up = cross(this.back, this.right);
    const dx = x - (this.canvas.clientWidth - this.covered[0]) / 2, dy = y - (this.canvas.clientHeight - this.covered[1]) / 2;
    const seen = add(this.target, add(times(this.right, dx * size), times(up, -dy * size)));
    return [this.eye, add(seen, times(this.eye, -1))];
  }

  // Zooms so that what lies under the pointer stays there.
  zoom(factor, x, y) {
    const before = this.distance;
    this.distance = Math.min(Math.max(before * factor, 0.5), 20000);
    const size = (before - this.distance) * Math.tan(0.35) / this.canvas.clientHeight * 2;
    const up = cross(this.back, this.right);
    const dx = x - (this.canvas.clientWidth - this.covered[0]) / 2, dy = y - (this.canvas.clientHeight - this.covered[1]) / 2;
    this.target = add(this.target, add(times(this.right, dx * size), times(up, -dy * size)));
    this.isFitted = false;
    this.changed();
  }

  listen() {
    const pointers = new Map();
    const canvas = this.canvas;
    canvas.addEventListener("contextmenu", (e) => e.preventDefault());
    canvas.addEventListener("pointerdown", (e) => {
      canvas.setPointerCapture(e.pointerId);
      pointers.set(e.pointerId, e);
      canvas.classList.add("turning");
    });
    const end = (e) => {
      pointers.delete(e.pointerId);
      if (pointers.size === 0) canvas.classList.remove("turning");
    };
    canvas.addEventListener("pointerup", end);
    canvas.addEventListener("pointercancel", end);
    canvas.addEventListener("pointermove", (e) => {
      const last = pointers.get(e.pointerId);
      if (!last) return;
      const dx = e.clientX - last.clientX, dy = e.clientY - last.clientY;
      if (pointers.size === 1) {
        if (e.buttons & 6 || e.shiftKey) this.pan(dx, dy);
        else this.turn(dx, dy);
      } else {
        const other = [...pointers.values()].find((p) => p.pointerId !== e.pointerId);
        const apart = (p) => Math.hypot(p.clientX - other.clientX, p.clientY - other.clientY);
        this.zoom(apart(last) / Math.max(apart(e), 1), (e.clientX + other.clientX) / 2, (e.clientY + other.clientY) / 2);
        this.pan(dx / 2, dy / 2);
      }
      pointers.set(e.pointerId, e);
    });
    canvas.addEventListener("wheel", (e) => {
      e.preventDefault();
      this.zoom(Math.exp(Math.sign(e.deltaY) * Math.min(Math.abs(e.deltaY), 100) * 0.0015), e.clientX, e.clientY);
    }, { passive: false });
  }
}
