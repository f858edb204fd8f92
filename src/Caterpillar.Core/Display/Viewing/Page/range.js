// A slider with one handle, or with two for a range; works with pointer and keyboard.
class Range {
  constructor(element, labels, changed, textOf) {
    this.element = element;
    this.changed = changed;
    this.textOf = textOf;
    this.least = 0;
    this.greatest = 1;
    this.values = labels.map(() => 0);
    element.classList.add("range");
    element.append(Object.assign(document.createElement("div"), { className: "track" }));
    this.chosen = element.appendChild(Object.assign(document.createElement("div"), { className: "chosen" }));
    this.handles = labels.map((label, i) => this.handle(label, i));
    this.listen();
  }

  handle(label, index) {
    const handle = this.element.appendChild(Object.assign(document.createElement("div"), { className: "handle", tabIndex: 0 }));
    handle.setAttribute("role", "slider");
    handle.setAttribute("aria-label", label);
    handle.addEventListener("keydown", (e) => {
      const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10 }[e.key];
      if (step) this.move(index, this.values[index] + step * (e.shiftKey ? 10 : 1));
      else if (e.key === "Home") this.move(index, this.least);
      else if (e.key === "End") this.move(index, this.greatest);
      else return;
      e.preventDefault();
      e.stopPropagation();
    });
    return handle;
  }

  listen() {
    let held = -1;
    const valueAt = (e) => {
      const box = this.element.getBoundingClientRect();
      return this.least + (e.clientX - box.left) / box.width * (this.greatest - this.least);
    };
    this.element.addEventListener("pointerdown", (e) => {
      this.element.setPointerCapture(e.pointerId);
      const value = valueAt(e);
      held = 0;
      if (this.values.length > 1) {
        const [a, b] = this.values.map((v) => Math.abs(v - value));
        held = a < b || (a === b && value < this.values[0]) ? 0 : 1;
      }
      this.move(held, value);
    });
    this.element.addEventListener("pointermove", (e) => { if (held >= 0) this.move(held, valueAt(e)); });
    for (const end of ["pointerup", "pointercancel"]) this.element.addEventListener(end, () => { held = -1; });
  }

  limits(least, greatest) {
    this.least = least;
    this.greatest = Math.max(greatest, least);
  }

  // Places that stand out, each a value with a text and maybe a color.
  mark(places) {
    for (const old of this.element.querySelectorAll(".mark")) old.remove();
    const size = Math.max(this.greatest - this.least, 1);
    for (const [value, title, color] of places) {
      const mark = Object.assign(document.createElement("div"), { className: "mark", title });
      if (color) mark.style.background = color;
      mark.style.left = 100 * (value - this.least) / size + "%";
      this.element.insertBefore(mark, this.handles[0]);
    }
  }

  move(index, value) {
    let next = Math.round(Math.min(Math.max(value, this.least), this.greatest));
    if (this.values.length > 1) next = index === 0 ? Math.min(next, this.values[1]) : Math.max(next, this.values[0]);
    if (next === this.values[index]) return;
    this.values[index] = next;
    this.show();
    this.changed(this.values);
  }

  set(...values) {
    this.values = values;
    this.show();
  }

  show() {
    const size = Math.max(this.greatest - this.least, 1);
    const parts = this.values.map((v) => 100 * (v - this.least) / size);
    this.handles.forEach((handle, i) => {
      handle.style.left = parts[i] + "%";
      handle.setAttribute("aria-valuemin", this.least);
      handle.setAttribute("aria-valuemax", this.greatest);
      handle.setAttribute("aria-valuenow", this.values[i]);
      handle.setAttribute("aria-valuetext", this.textOf(this.values[i]));
    });
    const from = parts.length > 1 ? parts[0] : 0;
    this.chosen.style.left = from + "%";
    this.chosen.style.width = parts[parts.length - 1] - from + "%";
  }
}
