// SPDX-License-Identifier: MIT
// Points and curves in a coordinate system, as SVG.

const seriesColor = (i) => `var(--series-${i % 8})`;

// Fills `box` with a plot and draws it anew when the width of the box changes.
//   x, y       {label, log}
//   series     [{label, color, dashed, line, dots, points: [{x, y, label, title}]}]
//   baselines  [{label, y}]: horizontal lines
// Points that a logarithmic axis cannot show are left out.
function showPlot(box, plot) {
  const draw = () => box.replaceChildren(plotSvg(plot, Math.max(box.clientWidth, 260)));
  box.plotObserver?.disconnect();
  let width = 0;
  box.plotObserver = new ResizeObserver(() => {
    if (box.clientWidth === width) return;
    width = box.clientWidth;
    draw();
  });
  box.plotObserver.observe(box);
}

function plotSvg(plot, width) {
  const height = Math.round(Math.min(Math.max(width * 0.55, 290), 380));
  const shown = ({x, y}) =>
    Number.isFinite(x) && Number.isFinite(y) && !(plot.x.log && x <= 0) && !(plot.y.log && y <= 0);
  const series = plot.series.map((s) => ({...s, points: s.points.filter(shown)}));
  const points = series.flatMap((s) => s.points);
  const baselines = (plot.baselines ?? []).filter(
    ({y}) => Number.isFinite(y) && !(plot.y.log && y <= 0),
  );
  const area = {left: 58, right: width - 14, top: 12, bottom: height - 42};
  const xMargin = series.some((s) => s.dots) ? 0.08 : 0;
  const x = makeScale(
    points.map((p) => p.x),
    plot.x.log,
    xMargin,
    area.left,
    area.right,
  );
  const y = makeScale(
    [...points, ...baselines].map((p) => p.y),
    plot.y.log,
    0.08,
    area.bottom,
    area.top,
  );

  const svg = svgEl('svg', {
    viewBox: `0 0 ${width} ${height}`,
    width,
    height,
    role: 'img',
    class: 'plot',
    'aria-label': `${plot.y.label} over ${plot.x.label}`,
  });
  svg.append(...axes(plot, x, y, area));
  const labels = new LabelPlacer(area);
  for (const baseline of baselines) {
    const at = y.position(baseline.y);
    svg.append(svgEl('line', {class: 'baseline', x1: area.left, x2: area.right, y1: at, y2: at}));
  }
  for (const s of series) {
    const at = s.points.map((p) => [x.position(p.x), y.position(p.y)]);
    if (s.line && at.length > 1)
      svg.append(
        svgEl('polyline', {
          class: s.dots ? 'curve thin' : 'curve',
          points: at.map((p) => p.map(fixed).join(',')).join(' '),
          style: `stroke: ${s.color}`,
          'stroke-dasharray': s.dashed ? '5 4' : null,
        }),
      );
    if (s.dots)
      at.forEach(([px, py], i) => {
        labels.reserve(px - 5, py - 5, 10, 10);
        svg.append(
          svgEl(
            'circle',
            {class: 'dot', cx: fixed(px), cy: fixed(py), r: 4.5, style: `fill: ${s.color}`},
            svgEl('title', {}, s.points[i].title ?? ''),
          ),
        );
      });
  }
  for (const baseline of baselines)
    svg.append(labels.text(area.left, y.position(baseline.y), baseline.label));
  for (const s of series)
    if (s.dots)
      for (const p of s.points) svg.append(labels.text(x.position(p.x), y.position(p.y), p.label));
  return svg;
}

const fixed = (value) => Number(value.toFixed(2));

// Maps values to positions. The range gets a margin, a share of it, and reaches to 0 on a linear
// axis where the values come near it.
function makeScale(values, log, margin, from, to) {
  const inAxis = log ? Math.log10 : (value) => value;
  let [low, high] =
    values.length === 0 ? [0, 1] : [inAxis(Math.min(...values)), inAxis(Math.max(...values))];
  if (!log && low > 0 && low < high * 0.5) low = 0;
  const extra = high > low ? (high - low) * margin : Math.abs(high) * 0.1 || 1;
  if (log || low !== 0) low -= extra;
  high += extra;
  return {
    position: (value) => from + ((to - from) * (inAxis(value) - low)) / (high - low),
    ticks: log ? logTicks(low, high) : linearTicks(low, high),
  };
}

function linearTicks(low, high) {
  const rough = (high - low) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].find((s) => s * power >= rough * (1 - 1e-9)) * power;
  const decimals = String(Number(step.toPrecision(2))).split('.')[1]?.length ?? 0;
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + step * 1e-9; ++k)
    ticks.push({value: k * step, text: minus((k * step).toFixed(decimals))});
  return ticks;
}

// Powers of ten, with steps between them where the axis is short.
function logTicks(low, high) {
  const steps = high - low > 2.5 ? [1] : high - low > 0.9 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 8];
  const ticks = [];
  for (let power = Math.floor(low); power <= Math.ceil(high); ++power)
    for (const step of steps) {
      const value = step * 10 ** power;
      if (Math.log10(value) >= low && Math.log10(value) <= high)
        ticks.push({value, text: tickText(value)});
    }
  return ticks;
}

function tickText(value) {
  if (value >= 1e5 || value < 1e-3) return minus(value.toExponential());
  return String(Number(value.toPrecision(2)));
}

function axes(plot, x, y, area) {
  const parts = [];
  for (const {value, text} of y.ticks) {
    const at = fixed(y.position(value));
    parts.push(svgEl('line', {class: 'grid', x1: area.left, x2: area.right, y1: at, y2: at}));
    parts.push(
      svgEl('text', {class: 'tick', x: area.left - 6, y: at + 4, 'text-anchor': 'end'}, text),
    );
  }
  for (const {value, text} of x.ticks) {
    const at = fixed(x.position(value));
    parts.push(svgEl('line', {class: 'grid', x1: at, x2: at, y1: area.top, y2: area.bottom}));
    parts.push(
      svgEl('text', {class: 'tick', x: at, y: area.bottom + 16, 'text-anchor': 'middle'}, text),
    );
  }
  const middle = (area.top + area.bottom) / 2;
  parts.push(
    svgEl(
      'text',
      {
        class: 'axis',
        x: (area.left + area.right) / 2,
        y: area.bottom + 34,
        'text-anchor': 'middle',
      },
      plot.x.label,
    ),
  );
  parts.push(
    svgEl(
      'text',
      {
        class: 'axis',
        x: 13,
        y: middle,
        'text-anchor': 'middle',
        transform: `rotate(-90 13 ${middle})`,
      },
      plot.y.label,
    ),
  );
  return parts;
}

// Finds room for labels: beside their point, without covering a point or another label.
class LabelPlacer {
  constructor(area) {
    this.area = area;
    this.taken = [];
  }

  reserve(x, y, width, height) {
    this.taken.push({x, y, width, height});
  }

  text(px, py, label) {
    const width = label.length * 6.4 + 4; // of 11.5 px text, not less than it takes
    const height = 14;
    const places = [];
    for (const dy of [0, -13, 13, -26, 26, -39, 39])
      places.push(
        [px + 9, py - 7 + dy],
        [px - 9 - width, py - 7 + dy],
        [px - width / 2, py - 7 + dy],
      );
    const box = places
      .map(([x, y]) => ({x, y, width, height}))
      .find((candidate) => this.isFree(candidate)) ?? {
      x: Math.min(px + 9, this.area.right - width),
      y: py - 7,
      width,
      height,
    };
    this.taken.push(box);
    return svgEl('text', {class: 'label', x: fixed(box.x + 2), y: fixed(box.y + 11)}, label);
  }

  isFree(box) {
    const {left, right, top, bottom} = this.area;
    return (
      box.x >= left &&
      box.x + box.width <= right &&
      box.y >= top - 8 &&
      box.y + box.height <= bottom &&
      !this.taken.some(
        (other) =>
          box.x < other.x + other.width &&
          other.x < box.x + box.width &&
          box.y < other.y + other.height &&
          other.y < box.y + box.height,
      )
    );
  }
}

// A legend for curves: a line of their colour, and their name.
function plotLegend(series) {
  return el(
    'ul',
    {class: 'legend'},
    series.map((s) =>
      el(
        'li',
        {},
        svgEl(
          'svg',
          {width: 22, height: 10, 'aria-hidden': 'true'},
          svgEl('line', {
            x1: 1,
            x2: 21,
            y1: 5,
            y2: 5,
            style: `stroke: ${s.color}`,
            'stroke-width': 2,
            'stroke-dasharray': s.dashed ? '5 4' : null,
          }),
        ),
        s.label,
      ),
    ),
  );
}
