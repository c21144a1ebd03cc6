// SPDX-License-Identifier: MIT
// Two of the pictures, over or beside each other.

const kGap = 2; // device pixels between the panes side by side

class Viewer {
  constructor(data, store, views, screens) {
    this.store = store;
    this.views = views;
    this.screens = screens;
    this.viewport = new Viewport(store.width, store.height);
    this.readOut = new ReadOut(byId('read-out'), data, store, views);
    this.stage = byId('stage');
    this.canvas = byId('canvas');
    this.layout = 'wipe';
    this.sides = firstSides(data, views);
    const have = (quantity, of) => of.filter((view) => typeof view[quantity] === 'number').length;
    this.quantities = kQuantities.filter(
      (quantity) => quantity !== 'occlusion' || have(quantity, views) > 0,
    );
    byId('occlusion-choice').hidden = !this.quantities.includes('occlusion');
    // What both sides have, or else most of them.
    this.quantity = this.quantities.reduce((best, quantity) =>
      have(quantity, this.sides) > have(best, this.sides) ? quantity : best,
    );
    this.divider = 0.5;
    this.pointed = null; // picture coordinates below the mouse
    this.pinned = null; // and where it was clicked
    this.defaultEv = screens.exposureEv;
    document.querySelector(`input[name="quantity"][value="${this.quantity}"]`).checked = true;
    this.connectControls();
    this.connectStage();
    this.update();
  }

  // --- controls ---

  connectControls() {
    for (const id of ['left', 'right']) {
      byId(id).append(...optionGroups(this.views));
      byId(id).addEventListener('change', () => this.choose(id, byId(id).value));
    }
    byId('swap').addEventListener('click', () => this.swap());
    for (const radio of document.getElementsByName('layout'))
      radio.addEventListener('change', () => this.setLayout(radio.value));
    for (const radio of document.getElementsByName('quantity'))
      radio.addEventListener('change', () => this.setQuantity(radio.value));
    byId('exposure').addEventListener('input', () => this.setStops(Number(byId('exposure').value)));
    byId('exposure-reset').addEventListener('click', () => this.setStops(0));
    byId('tone-map').append(
      ...Object.keys(kToneMaps).map((name) => el('option', {value: name}, name)),
    );
    byId('tone-map').value = this.screens.toneMap;
    byId('tone-map').addEventListener('change', () => {
      this.screens.toneMap = byId('tone-map').value;
      this.update();
    });
    for (const [id, by] of [
      ['zoom-in', '+'],
      ['zoom-out', '-'],
      ['zoom-fit', '0'],
      ['zoom-one', '1'],
    ])
      byId(id).addEventListener('click', () => {
        steerByKey(this.viewport, by);
        this.update();
      });
  }

  choose(side, key) {
    const view = this.views.find((candidate) => candidate.key === key);
    this.sides[side === 'left' ? 0 : 1] = view;
    this.update();
  }

  // The next or previous picture on one side.
  step(side, by) {
    const at = this.views.indexOf(this.sides[side]);
    this.sides[side] = this.views[(at + by + this.views.length) % this.views.length];
    this.update();
  }

  swap() {
    this.sides.reverse();
    this.update();
  }

  setLayout(layout) {
    this.layout = layout;
    this.fitStage();
    this.update();
  }

  setQuantity(quantity) {
    this.quantity = quantity;
    this.update();
  }

  setStops(stops) {
    const slider = byId('exposure');
    slider.value = stops;
    this.screens.exposureEv = this.defaultEv + Number(slider.value);
    this.update();
  }

  // --- the stage ---

  connectStage() {
    new ResizeObserver(() => this.fitStage()).observe(this.stage.parentElement);
    addEventListener('resize', () => this.fitStage());
    steerByPointer(this.stage, this.viewport, {
      toPane: (event) => this.toPane(event),
      onView: () => this.update(),
      onPoint: (at) => {
        this.pointed = at && this.viewport.toPicture(at.x, at.y);
        this.update();
      },
      onPick: (at) => {
        this.pinned = this.viewport.toPicture(at.x, at.y);
        this.update();
      },
    });
    this.stage.addEventListener('keydown', (event) => this.onKey(event));
    const handle = byId('divider');
    handle.addEventListener('pointerdown', (event) => handle.setPointerCapture(event.pointerId));
    handle.addEventListener('pointermove', (event) => {
      if (!handle.hasPointerCapture(event.pointerId)) return;
      const box = this.canvas.getBoundingClientRect();
      this.moveDivider((event.clientX - box.left) / box.width);
    });
  }

  onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const onDivider = event.target === byId('divider');
    const arrow = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    const actions = {
      x: () => this.swap(),
      ' ': () => this.swap(),
      s: () => this.setRadio('layout', nextOf(['wipe', 'side', 'one'], this.layout)),
      i: () => this.setRadio('quantity', nextOf(this.quantities, this.quantity)),
      '[': () => this.setStops(Number(byId('exposure').value) - 0.5),
      ']': () => this.setStops(Number(byId('exposure').value) + 0.5),
      r: () => this.setStops(0),
      ',': () => this.step(0, -1),
      '.': () => this.step(0, 1),
      '<': () => this.step(1, -1),
      '>': () => this.step(1, 1),
      Escape: () => {
        this.pinned = null;
      },
    };
    if (arrow && (onDivider || event.shiftKey)) this.moveDivider(this.divider + arrow * 0.02);
    else if (onDivider && event.key === 'Home') this.moveDivider(0);
    else if (onDivider && event.key === 'End') this.moveDivider(1);
    else if (Object.hasOwn(actions, event.key)) actions[event.key]();
    else if (!steerByKey(this.viewport, event.key)) return;
    event.preventDefault();
    this.update();
  }

  setRadio(name, value) {
    document.querySelector(`input[name="${name}"][value="${value}"]`).click();
  }

  moveDivider(share) {
    this.divider = Math.min(Math.max(share, 0), 1);
    this.update();
  }

  get paneWidth() {
    return this.layout === 'side' ? (this.canvas.width - kGap) / 2 : this.canvas.width;
  }

  toPane(event) {
    const box = this.canvas.getBoundingClientRect();
    const stageX = ((event.clientX - box.left) * this.canvas.width) / box.width;
    const y = ((event.clientY - box.top) * this.canvas.height) / box.height;
    const start = stageX >= this.paneWidth + kGap ? this.paneWidth + kGap : 0;
    return {x: stageX - start, y, stageX};
  }

  // As wide as the page; as high as the picture then is, but no higher than most of the window.
  fitStage() {
    const width = this.stage.clientWidth;
    const across = this.layout === 'side' ? 2 : 1;
    const wanted = ((width / across) * this.store.height) / this.store.width;
    const height = Math.round(Math.min(Math.max(wanted, 160), Math.max(innerHeight * 0.74, 240)));
    this.stage.style.height = `${height}px`;
    this.canvas.width = Math.round(width * devicePixelRatio);
    this.canvas.height = Math.round(height * devicePixelRatio);
    this.viewport.resize(this.paneWidth, this.canvas.height);
    this.draw();
  }

  // --- showing ---

  // Draws once before the next frame, however often it is called.
  update() {
    if (this.pending) return;
    this.pending = requestAnimationFrame(() => {
      this.pending = null;
      this.draw();
    });
  }

  draw() {
    this.showControls();
    const context = this.canvas.getContext('2d');
    const {width, height} = this.canvas;
    context.clearRect(0, 0, width, height);
    const cut = Math.round(width * this.divider);
    if (this.layout === 'side') {
      this.drawPane(context, this.sides[0], 0, 0, this.paneWidth);
      this.drawPane(context, this.sides[1], width - this.paneWidth, width - this.paneWidth, width);
    } else if (this.layout === 'wipe') {
      this.drawPane(context, this.sides[0], 0, 0, cut);
      this.drawPane(context, this.sides[1], 0, cut, width);
    } else {
      this.drawPane(context, this.sides[0], 0, 0, width);
    }
    this.showPixel();
  }

  // Draws a picture whose pane starts at `start`, between `from` and `to`.
  drawPane(context, view, start, from, to) {
    if (to <= from) return;
    context.save();
    context.beginPath();
    context.rect(from, 0, to - from, this.canvas.height);
    context.clip();
    const screen = this.screens.canvasOf(view, this.quantity);
    const {x, y} = this.viewport.origin;
    const {zoom} = this.viewport;
    if (screen) {
      context.imageSmoothingEnabled = zoom < 1;
      context.imageSmoothingQuality = 'high';
      context.drawImage(screen, start + x, y, screen.width * zoom, screen.height * zoom);
      this.drawMarker(context, start + x, y, zoom);
    } else {
      context.fillStyle = '#999';
      context.font = `${13 * devicePixelRatio}px system-ui, sans-serif`;
      context.textAlign = 'center';
      const missing = {
        composed: 'no composed picture',
        indirect: 'no picture of indirect light',
        occlusion: 'no picture of occlusion',
      }[this.quantity];
      const text = view.map || view[this.quantity] !== null ? 'unpacking …' : missing;
      context.fillText(text, (from + to) / 2, this.canvas.height / 2);
    }
    context.restore();
  }

  // A frame around the pixel that was clicked.
  drawMarker(context, x, y, zoom) {
    if (!this.pinned) return;
    const size = Math.max(zoom, 7 * devicePixelRatio);
    const left = x + (Math.floor(this.pinned.x) + 0.5) * zoom - size / 2;
    const top = y + (Math.floor(this.pinned.y) + 0.5) * zoom - size / 2;
    for (const [color, width] of [
      ['#000', 3],
      ['#fff', 1],
    ]) {
      context.strokeStyle = color;
      context.lineWidth = width * devicePixelRatio;
      context.strokeRect(left, top, size, size);
    }
  }

  showControls() {
    const [left, right] = this.sides;
    byId('left').value = left.key;
    byId('right').value = right.key;
    byId('left-label').textContent = left.label;
    byId('right-label').textContent = right.label;
    byId('right-label').hidden = this.layout === 'one';
    const stops = this.screens.exposureEv - this.defaultEv;
    const ev = minus(this.screens.exposureEv.toFixed(2));
    const sign = stops < 0 ? '−' : '+';
    byId('exposure-value').textContent = `${sign}${Math.abs(stops).toFixed(2)} stops (EV ${ev})`;
    const handle = byId('divider');
    handle.hidden = this.layout !== 'wipe';
    handle.style.left = `${this.divider * 100}%`;
    handle.setAttribute('aria-valuenow', Math.round(this.divider * 100));
    this.stage.style.touchAction = this.viewport.isFit ? 'pan-y' : 'none';
    const spoken = this.layout === 'one' ? left.label : `${left.label} and ${right.label}`;
    if (byId('spoken').textContent !== spoken) byId('spoken').textContent = spoken;
  }

  // The pixel below the mouse, or the one that was clicked, or the middle of the view.
  showPixel() {
    const {x, y} = this.pinned ?? this.pointed ?? this.viewport.center;
    const pixel = {
      x: Math.min(Math.floor(x), this.store.width - 1),
      y: Math.min(Math.floor(y), this.store.height - 1),
    };
    const inside = pixel.x >= 0 && pixel.y >= 0;
    const from = this.pinned ? 'clicked' : this.pointed ? 'below the pointer' : 'in the middle';
    const hint =
      this.pointed && document.activeElement !== this.stage
        ? '; click the picture to zoom with the wheel'
        : '';
    byId('status').textContent =
      `zoom ${Math.round(this.viewport.zoom * 100)} %` +
      (inside ? `, pixel ${pixel.x}, ${pixel.y} (${from})` : '') +
      hint;
    this.readOut.show(pixel, this.quantity, this.screens.exposureEv, this.screens.toneMap);
  }
}

const nextOf = (list, value) => list[(list.indexOf(value) + 1) % list.length];
