// SPDX-License-Identifier: MIT
// Which part of the pictures is seen, and how mouse, touch and keys change that. All panes share
// one viewport. Lengths on screen are device pixels.

const kLargestZoom = 64;

class Viewport {
  constructor(width, height) {
    this.picture = {width, height};
    this.pane = {width: 1, height: 1};
    this.isFit = true;
    this.fit();
  }

  resize(width, height) {
    this.pane = {width, height};
    if (this.isFit) this.fit();
    else this.keepInside();
  }

  get fitZoom() {
    return Math.min(this.pane.width / this.picture.width, this.pane.height / this.picture.height);
  }

  fit() {
    this.isFit = true;
    this.zoom = this.fitZoom;
    this.center = {x: this.picture.width / 2, y: this.picture.height / 2};
  }

  // Zooms by a factor around a place of the pane, which stays where it is.
  zoomBy(factor, px = this.pane.width / 2, py = this.pane.height / 2) {
    const fixedPoint = this.toPicture(px, py);
    const least = Math.min(this.fitZoom, 1);
    this.zoom = Math.min(Math.max(this.zoom * factor, least), kLargestZoom);
    this.center.x = fixedPoint.x - (px - this.pane.width / 2) / this.zoom;
    this.center.y = fixedPoint.y - (py - this.pane.height / 2) / this.zoom;
    this.isFit = Math.abs(this.zoom / this.fitZoom - 1) < 1e-6;
    this.keepInside();
  }

  panBy(dx, dy) {
    this.center.x -= dx / this.zoom;
    this.center.y -= dy / this.zoom;
    this.keepInside();
  }

  // The picture fills the pane where it is larger, and is centred where it is smaller.
  keepInside() {
    for (const [axis, side] of [
      ['x', 'width'],
      ['y', 'height'],
    ]) {
      const half = this.pane[side] / 2 / this.zoom;
      const size = this.picture[side];
      this.center[axis] =
        size <= 2 * half ? size / 2 : Math.min(Math.max(this.center[axis], half), size - half);
    }
  }

  // The place of the picture that is drawn at a place of the pane.
  toPicture(px, py) {
    const {x, y} = this.origin;
    return {x: (px - x) / this.zoom, y: (py - y) / this.zoom};
  }

  // Where the picture's top left corner lies; whole pixels once pixels are magnified.
  get origin() {
    const x = this.pane.width / 2 - this.center.x * this.zoom;
    const y = this.pane.height / 2 - this.center.y * this.zoom;
    return this.zoom >= 1 ? {x: Math.round(x), y: Math.round(y)} : {x, y};
  }
}

// Steers a viewport by wheel, drag and pinch on `stage`. `toPane` turns a pointer event into device
// pixels: `x` and `y` within the pane below it, and `stageX` within the stage, which does not jump
// from pane to pane. `onView` hears of changes, `onPoint` of the place below the pointer (null:
// none), `onPick` of a click or tap without a drag.
function steerByPointer(stage, viewport, {toPane, onView, onPoint, onPick}) {
  const pointers = new Map();
  let moved = 0;

  // The wheel belongs to the page until the stage has the focus; a pinch on a touchpad is a wheel
  // with Ctrl.
  stage.addEventListener(
    'wheel',
    (event) => {
      if (document.activeElement !== stage && !event.ctrlKey) return;
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
      const at = toPane(event);
      viewport.zoomBy(2 ** ((-event.deltaY * lines) / (event.ctrlKey ? 100 : 300)), at.x, at.y);
      onView();
      onPoint(at);
    },
    {passive: false},
  );

  stage.addEventListener('pointerdown', (event) => {
    if (event.button !== 0 || event.target.closest('.divider')) return;
    stage.setPointerCapture(event.pointerId);
    if (pointers.size === 0) moved = 0;
    pointers.set(event.pointerId, toPane(event));
  });

  stage.addEventListener('pointermove', (event) => {
    const now = toPane(event);
    const before = pointers.get(event.pointerId);
    if (before) {
      moved += Math.abs(now.stageX - before.stageX) + Math.abs(now.y - before.y);
      pinch(event.pointerId, before, now);
      viewport.panBy(
        (now.stageX - before.stageX) / pointers.size,
        (now.y - before.y) / pointers.size,
      );
      pointers.set(event.pointerId, now);
      onView();
    }
    onPoint(now);
  });

  // With two fingers, the zoom follows their distance.
  function pinch(id, before, now) {
    if (pointers.size !== 2) return;
    const other = [...pointers].find(([key]) => key !== id)[1];
    const distance = (p) => Math.hypot(p.stageX - other.stageX, p.y - other.y);
    if (distance(before) < 1) return;
    viewport.zoomBy(distance(now) / distance(before), (now.x + other.x) / 2, (now.y + other.y) / 2);
  }

  stage.addEventListener('pointerup', (event) => {
    if (pointers.delete(event.pointerId) && moved < 6 * devicePixelRatio) onPick(toPane(event));
  });
  stage.addEventListener('pointercancel', (event) => {
    pointers.delete(event.pointerId);
  });
  stage.addEventListener('pointerleave', () => onPoint(null));
}

// What a key does to the viewport; false where it is none of its keys.
function steerByKey(viewport, key) {
  const step = Math.min(viewport.pane.width, viewport.pane.height) / 8;
  const actions = {
    '+': () => viewport.zoomBy(Math.SQRT2),
    '=': () => viewport.zoomBy(Math.SQRT2),
    '-': () => viewport.zoomBy(Math.SQRT1_2),
    0: () => viewport.fit(),
    1: () => viewport.zoomBy(1 / viewport.zoom),
    ArrowLeft: () => viewport.panBy(step, 0),
    ArrowRight: () => viewport.panBy(-step, 0),
    ArrowUp: () => viewport.panBy(0, step),
    ArrowDown: () => viewport.panBy(0, -step),
  };
  if (!Object.hasOwn(actions, key)) return false;
  actions[key]();
  return true;
}
