// When to draw what. Where a whole image takes long, changes are shown quickly, by as many extrusions as the time allows, and the whole follows in pieces
// when they pause.
const frameTime = 80, pause = 250, firstExtrusions = 100000, piece = 16384;

class Frames {
  constructor(scene, camera, state) {
    this.scene = scene;
    this.camera = camera;
    this.state = state;
    // What is large is not drawn whole before it is known to be quick.
    this.skip = Math.max(Math.floor((scene.lists.outside?.count ?? 0) / firstExtrusions), 1);
    this.isFirst = this.skip > 1;
    this.areSlow = false;
  }

  redraw() {
    clearTimeout(this.resting);
    this.setWhole(null);
    document.documentElement.dataset.image = "partial";
    if (this.isQueued) return;
    this.isQueued = true;
    requestAnimationFrame(() => {
      const quickly = this.areSlow || this.isFirst, skip = this.skip, start = performance.now();
      if (quickly) this.scene.drawQuickly(this.camera, this.state, skip);
      else for (const step of this.scene.drawWhole(this.camera, this.state)) void step;
      this.isQueued = false;
      this.afterDrawing(() => this.drawn(performance.now() - start, quickly, skip));
    });
  }

  drawn(time, quickly, skip) {
    if (!quickly) {
      this.areSlow = time > frameTime;
      return this.finished();
    }
    if (this.isFirst) {
      this.isFirst = false;
      this.areSlow = time > frameTime;
      if (!this.areSlow) return this.redraw();
    }
    this.skip = Math.min(Math.max(Math.round(skip * time / frameTime), 1), 1000);
    // One slow image, as at the start, does not make all slow.
    if (skip === 1 && time < frameTime / 4) this.areSlow = false;
    clearTimeout(this.resting);
    this.resting = setTimeout(() => {
      this.setWhole(this.refined());
      this.next(this.whole);
    }, pause);
  }

  // Where the quick image has only some of the extrusions, all of them come first with edges as they fall, which takes a third of the time.
  *refined() {
    if (this.skip > 1) yield* this.scene.drawWhole(this.camera, this.state, piece, false);
    yield* this.scene.drawWhole(this.camera, this.state, piece);
  }

  setWhole(whole) {
    this.whole = whole;
    byId("refining").hidden = whole === null;
  }

  // A piece when the one before is done, until the whole is there or something changes.
  next(whole) {
    if (whole !== this.whole) return;
    if (!whole.next().done) return this.afterDrawing(() => this.next(whole));
    this.setWhole(null);
    this.finished();
  }

  // A page that is driven by a program says when its image is there.
  finished() {
    if (!this.isQueued) document.documentElement.dataset.image = "whole";
  }

  afterDrawing(then) {
    const gl = this.scene.gl, fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    const wait = () => {
      if (gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return setTimeout(wait, 4);
      gl.deleteSync(fence);
      then();
    };
    setTimeout(wait, 0);
  }
}
