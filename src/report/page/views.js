// SPDX-License-Identifier: MIT
// What can be looked at, and how it looks on the display.

const kQuantities = ['composed', 'indirect', 'occlusion'];

// Exposure and tone map; occlusion is no light, and shown as it is.
const shownAs = (quantity, exposureEv, toneMap) =>
  quantity === 'occlusion' ? [0, 'none'] : [exposureEv, toneMap];

// All that can be looked at: techniques, references, direct light, error maps. A view is
// {key, group, label, composed, indirect, occlusion} with numbers of pictures (null: there is none),
// or {key, group, label, entryKey, map} for an error map.
function viewsOf(data) {
  const views = [];
  const add = (group, key, label, pictures) => {
    if (kQuantities.some((quantity) => pictures[quantity] !== null))
      views.push({key, group, label, ...pictures});
  };
  data.entries.forEach((entry, i) => add('Techniques', `entry-${i}`, entry.label, entry.pictures));
  data.references.forEach((r, i) => add('References', `reference-${i}`, r.label, r.pictures));
  add('Direct light', 'direct', 'direct light only', {
    composed: data.direct,
    indirect: null,
    occlusion: null,
  });
  data.entries.forEach((entry, i) =>
    entry.maps.forEach((map, k) =>
      views.push({
        key: `map-${i}-${k}`,
        group: 'Error maps',
        entryKey: `entry-${i}`,
        map,
        label: `${metricLabel(data, map.metric)}: ${entry.label} / ${map.reference}`,
      }),
    ),
  );
  return views;
}

const metricLabel = (data, name) => data.metrics.find((metric) => metric.name === name).label;

// The first technique that does something, and the first reference.
function firstSides(data, views) {
  const busy = data.entries.findIndex((entry) => entry.technique_ms > 0);
  const left = views.find((view) => view.key === `entry-${busy}`) ?? views[0];
  const others = views.filter((view) => view !== left);
  return [left, others.find((view) => view.group === 'References') ?? others[0] ?? left];
}

function optionGroups(views) {
  const groups = new Map();
  for (const view of views) {
    if (!groups.has(view.group)) groups.set(view.group, el('optgroup', {label: view.group}));
    groups.get(view.group).append(el('option', {value: view.key}, view.label));
  }
  return [...groups.values()];
}

// Pictures as the display shows them, at the present exposure, tone map and scale of the maps.
class Screens {
  constructor(data, store, onReady) {
    this.store = store;
    this.onReady = onReady;
    this.exposureEv = data.exposure_ev ?? 0;
    this.toneMap = data.tone_map;
    this.mapScale = 1;
    this.painted = new Map();
  }

  // A canvas of the picture's size; null while it is unpacked, and for a picture that is missing.
  canvasOf(view, quantity) {
    const number = view.map ? view.map.picture : view[quantity];
    if (number === null) return null;
    const codes = this.store.codes(number);
    if (!codes) {
      this.store.unpack(number, view.map ? 1 : 3).then(this.onReady);
      return null;
    }
    const shown = shownAs(quantity, this.exposureEv, this.toneMap);
    const settings = view.map ? `${this.mapScale}` : shown.join(' ');
    let screen = this.painted.get(number);
    if (screen?.settings === settings) return screen.canvas;
    screen ??= {canvas: el('canvas', {width: this.store.width, height: this.store.height})};
    screen.settings = settings;
    this.painted.set(number, screen);
    const image = new ImageData(this.store.width, this.store.height);
    if (view.map) toMagma(codes, this.store.light, view.map.full_scale * this.mapScale, image.data);
    else toDisplay(codes, this.store.light, ...shown, image.data);
    screen.canvas.getContext('2d').putImageData(image, 0, 0);
    return screen.canvas;
  }
}
