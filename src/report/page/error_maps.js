// SPDX-License-Identifier: MIT
// All error maps side by side; a click on one takes it into the viewer.

class ErrorMaps {
  constructor(data, views, screens, {onScale, onPick}) {
    this.screens = screens;
    this.onScale = onScale;
    this.maps = views
      .filter((view) => view.map)
      .map((view) => ({view, canvas: el('canvas', {'aria-hidden': 'true'})}));
    if (this.maps.length === 0) return;
    byId('maps').hidden = false;
    byId('map-grid').append(
      ...this.maps.map(({view, canvas}) =>
        el(
          'li',
          {},
          el(
            'button',
            {type: 'button', class: 'map', onclick: () => onPick(view)},
            canvas,
            el('span', {}, view.label),
          ),
        ),
      ),
    );
    byId('legend-bar').style.backgroundImage = kMagmaGradient;
    byId('map-scale').addEventListener('input', () => this.setScale());
    this.setScale();
  }

  // The slider goes in stops of two: to the right, smaller errors become visible.
  setScale() {
    this.screens.mapScale = 2 ** -Number(byId('map-scale').value);
    const scales = [...new Set(this.maps.map(({view}) => view.map.full_scale))];
    const top = scales
      .map((scale) => `${formatNumber(scale * this.screens.mapScale, 3)}`)
      .join(' or ');
    byId('legend-top').textContent = `${top} and more`;
    byId('map-scale-value').textContent = `×${formatNumber(1 / this.screens.mapScale, 3)}`;
    this.update();
    this.onScale();
  }

  // Once a frame; called again when a map has been unpacked.
  update() {
    cancelAnimationFrame(this.pending);
    this.pending = requestAnimationFrame(() => this.draw());
  }

  draw() {
    for (const {view, canvas} of this.maps) {
      const screen = this.screens.canvasOf(view, 'composed');
      if (!screen) continue;
      const width = Math.min(screen.width, 480);
      canvas.width = width;
      canvas.height = Math.max(1, Math.round((width * screen.height) / screen.width));
      const context = canvas.getContext('2d');
      context.imageSmoothingQuality = 'high';
      context.drawImage(screen, 0, 0, canvas.width, canvas.height);
    }
  }
}
