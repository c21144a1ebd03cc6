// SPDX-License-Identifier: MIT
// The linear values of all pictures at one pixel.

class ReadOut {
  // `views` as in views.js; error maps become columns of their technique's row.
  constructor(box, data, store, views) {
    this.store = store;
    this.pictures = views.filter((view) => !view.map);
    this.columns = mapColumns(data, views);
    this.rows = this.pictures.map((view) => this.row(view));
    const headings = ['R', 'G', 'B', 'Y', ...this.columns.map(({label}) => label)];
    box.append(
      el(
        'table',
        {class: 'read-out'},
        el(
          'caption',
          {class: 'unseen'},
          'Linear values at the pixel, before exposure and tone map',
        ),
        el(
          'thead',
          {},
          el(
            'tr',
            {},
            el('th', {scope: 'col'}, 'linear values'),
            headings.map((text) => el('th', {scope: 'col', class: 'number'}, text)),
          ),
        ),
        el(
          'tbody',
          {},
          this.rows.map(({element}) => element),
        ),
      ),
    );
  }

  row(view) {
    const swatch = el('span', {class: 'swatch', 'aria-hidden': 'true'});
    const cells = [0, 1, 2, 3, ...this.columns].map(() => el('td', {class: 'number'}, '–'));
    const element = el('tr', {}, el('th', {scope: 'row'}, swatch, view.label), cells);
    return {swatch, cells, element, view};
  }

  // Shows pixel (x, y), or dashes for null. `quantity` is one of kQuantities.
  show(pixel, quantity, exposureEv, toneMap) {
    const {width, height, light} = this.store;
    const inside = pixel && pixel.x >= 0 && pixel.y >= 0 && pixel.x < width && pixel.y < height;
    const at = inside ? pixel.y * width + pixel.x : -1;
    for (const {swatch, cells, view} of this.rows) {
      const codes = inside ? this.store.codes(view[quantity]) : undefined;
      const rgb = codes && Array.from(codes.subarray(at * 3, at * 3 + 3));
      const values = rgb ? rgb.map((code) => light[code]) : [null, null, null];
      const luminance = rgb ? 0.2126 * values[0] + 0.7152 * values[1] + 0.0722 * values[2] : null;
      [...values, luminance].forEach((value, i) => {
        cells[i].textContent = formatNumber(value, 3);
      });
      const shown = shownAs(quantity, exposureEv, toneMap);
      swatch.style.backgroundColor = rgb ? displayColor(rgb, light, ...shown) : '';
      this.columns.forEach((column, i) => {
        const map = inside ? this.store.codes(column.pictures.get(view.key)) : undefined;
        cells[4 + i].textContent = formatNumber(map ? light[map[at]] : null, 3);
      });
    }
  }
}

function displayColor(rgb, light, exposureEv, toneMap) {
  const rgba = [0, 0, 0, 0];
  toDisplay(rgb, light, exposureEv, toneMap, rgba);
  return `rgb(${rgba.slice(0, 3).join(' ')})`;
}

// A column for each metric and reference of which there is a map: from the key of a technique's
// view to the number of its map.
function mapColumns(data, views) {
  const columns = new Map();
  for (const view of views.filter(({map}) => map)) {
    const {metric, reference, picture} = view.map;
    const label = `${metricLabel(data, metric)}, ${reference}`;
    if (!columns.has(label)) columns.set(label, {label, pictures: new Map()});
    columns.get(label).pictures.set(view.entryKey, picture);
  }
  return [...columns.values()];
}
