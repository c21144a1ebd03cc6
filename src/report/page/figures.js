// SPDX-License-Identifier: MIT
// A page of figures: builds each block of each section.

const kBlocks = {
  paragraph: ({text}) => el('p', {}, text),
  pictures: ({pictures, caption}) =>
    el(
      'figure',
      {},
      el('div', {class: 'picture-row'}, pictures.map(pictureFigure)),
      caption === '' ? null : el('figcaption', {}, caption),
    ),
  table: ({caption, columns, rows}) => scrollBox(caption, makeTable({caption, columns, rows})),
  plot: plotFigure,
};

// A picture, with its marks drawn over it.
function pictureFigure({url, caption, size: [width, height], marks}) {
  const lines = marks.flatMap(([x1, y1, x2, y2]) =>
    ['under', 'over'].map((name) => svgEl('line', {class: `mark ${name}`, x1, y1, x2, y2})),
  );
  const overlay =
    lines.length === 0
      ? null
      : svgEl('svg', {viewBox: `0 0 ${width} ${height}`, 'aria-hidden': 'true'}, lines);
  return el(
    'figure',
    {},
    el('div', {class: 'picture'}, el('img', {src: url, width, height, alt: caption}), overlay),
    el('figcaption', {}, caption),
  );
}

function plotFigure({caption, x, y, curves}) {
  const series = curves.map((curve, i) => ({
    label: curve.label,
    dashed: curve.dashed,
    color: seriesColor(i),
    line: true,
    points: curve.points.map(([px, py]) => ({x: px ?? NaN, y: py ?? NaN})),
  }));
  const box = el('div');
  showPlot(box, {x, y, series});
  return el(
    'figure',
    {class: 'plot-figure'},
    plotLegend(series),
    box,
    el('figcaption', {}, caption),
  );
}

function showFigures() {
  const data = readData();
  showHead(data);
  byId('sections').append(
    ...data.sections.map(({title, blocks}) =>
      el(
        'section',
        {},
        el('h2', {}, title),
        blocks.map((block) => kBlocks[block.kind](block)),
      ),
    ),
  );
  showCommand(data.command);
}

showFigures();
