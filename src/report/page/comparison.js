// SPDX-License-Identifier: MIT
// The page of a comparison: puts its parts together.

function showComparison() {
  const data = readData();
  showHead({
    title: data.title,
    warnings: data.warnings,
    facts: [
      ['scene', data.scene],
      ['camera', data.camera],
      ['size', data.size.join(' × ')],
      ['exposure', `${minus(formatNumber(data.exposure_ev ?? 0, 3))} EV`],
      ['tone map', data.tone_map],
      ['device', data.device],
    ],
  });
  showErrors(data);
  showScatter(data);
  showTimes(data);
  showSettings(data);
  showReferences(data);
  showCommand(data.command);
  showPictures(data);
}

function showPictures(data) {
  const views = viewsOf(data);
  if (views.length === 0) return;
  if (!canUnpack()) {
    warn(
      'The pictures are not shown: this browser lacks DecompressionStream. Chromium 80, ' +
        'Firefox 113 and Safari 16.4 have it. Tables and plots are complete.',
    );
    return;
  }
  byId('viewer').hidden = false;
  const store = new PictureStore(data);
  const screens = new Screens(data, store, () => update());
  const viewer = new Viewer(data, store, views, screens);
  const maps = new ErrorMaps(data, views, screens, {
    onScale: () => viewer.update(),
    onPick: (view) => {
      viewer.choose('right', view.key);
      byId('stage').focus({preventScroll: true});
      byId('viewer').scrollIntoView({block: 'start'});
    },
  });
  function update() {
    viewer.update();
    maps.update();
  }
  // The read-out wants all pictures; those on screen come first.
  viewer.draw();
  for (const view of views)
    for (const number of [view.composed, view.indirect, view.occlusion, view.map?.picture])
      if (typeof number === 'number') store.unpack(number, view.map ? 1 : 3).then(update);
}

// --- tables --------------------------------------------------------------------------------------

function showErrors(data) {
  const columns = [
    {heading: 'technique', sortable: true},
    {
      heading: 'technique',
      unit: 'ms',
      group: 'time',
      better: 'lower',
      sortable: true,
      digits: 3,
      title: 'Median time of the technique alone.',
    },
    {
      heading: 'frame',
      unit: 'ms',
      group: 'time',
      better: 'lower',
      sortable: true,
      digits: 3,
      title: 'Median time of the whole frame.',
    },
    ...data.references.flatMap((reference) =>
      usedMetrics(data, reference).map((metric) => ({
        heading: metric.label,
        unit: metric.unit,
        group: `against ${reference.label}`,
        better: metric.better,
        title: metric.summary,
        sortable: true,
      })),
    ),
  ];
  const rows = data.entries.map((entry) => [
    entry.label,
    entry.technique_ms,
    entry.frame_ms,
    ...data.references.flatMap((reference) =>
      usedMetrics(data, reference).map(
        (metric) => entry.errors[reference.label]?.[metric.name] ?? null,
      ),
    ),
  ]);
  if (data.references.length === 0)
    note('error-note', 'There is no reference, so errors are not known.');
  if (rows.length === 0) {
    note('error-note', 'There is no technique to compare.');
    return;
  }
  // What takes no time because it does nothing is not the fastest.
  const ranked = (r, c) => !(c === 1 && rows[r][1] === 0);
  byId('error-table').append(scrollBox('Errors and times', makeTable({columns, rows, ranked})));
}

function usedMetrics(data, reference) {
  return data.metrics.filter((metric) =>
    data.entries.some(
      (entry) =>
        entry.errors[reference.label] && Object.hasOwn(entry.errors[reference.label], metric.name),
    ),
  );
}

function note(id, text) {
  byId(id).textContent = text;
  byId(id).hidden = false;
}

// Settings are rows; what differs between entries of one technique stands out.
function showSettings(data) {
  if (data.entries.length === 0) return;
  byId('settings').hidden = false;
  const names = [...new Set(data.entries.flatMap((entry) => Object.keys(entry.settings)))];
  const text = (value) =>
    value === undefined ? '–' : typeof value === 'string' ? value : JSON.stringify(value);
  const varies = (name, entry) =>
    new Set(
      data.entries
        .filter((other) => other.technique === entry.technique)
        .map((other) => text(other.settings[name])),
    ).size > 1;
  const cell = (name, entry) =>
    el('span', {class: varies(name, entry) ? 'varies' : null}, text(entry.settings[name]));
  byId('settings-table').append(
    scrollBox(
      'Settings',
      makeTable({
        columns: [{heading: 'setting'}, ...data.entries.map((entry) => ({heading: entry.label}))],
        rows: [
          ['technique', ...data.entries.map((entry) => entry.technique)],
          ...names.map((name) => [name, ...data.entries.map((entry) => cell(name, entry))]),
        ],
      }),
    ),
  );
}

function showReferences(data) {
  if (data.references.length === 0) return;
  byId('references').hidden = false;
  const percent = (share) => (share === null ? null : share * 100);
  byId('references-table').append(
    scrollBox(
      'References',
      makeTable({
        columns: [
          {heading: 'reference'},
          {heading: 'mode'},
          {heading: 'samples', unit: 'a pixel'},
          {
            heading: 'estimated error',
            unit: '%',
            digits: 3,
            title: 'Relative, of the picture as a whole: what is left of its noise.',
          },
          {heading: 'time', unit: 's', digits: 3},
        ],
        rows: data.references.map((r) => [
          r.label,
          r.mode,
          r.samples_per_pixel,
          percent(r.relative_error),
          r.seconds,
        ]),
      }),
    ),
  );
}

// --- error over time -----------------------------------------------------------------------------

function showScatter(data) {
  const choices = data.references.filter((reference) => usedMetrics(data, reference).length > 0);
  if (choices.length === 0) return;
  byId('scatter').hidden = false;
  const reference = byId('scatter-reference');
  const metric = byId('scatter-metric');
  reference.append(...choices.map(({label}) => el('option', {value: label}, label)));
  reference.addEventListener('change', chooseReference);
  metric.addEventListener('change', show);
  chooseReference();

  function chooseReference() {
    const before = metric.value;
    const used = usedMetrics(
      data,
      data.references.find(({label}) => label === reference.value),
    );
    metric.replaceChildren(...used.map(({name, label}) => el('option', {value: name}, label)));
    metric.value = used.some(({name}) => name === before) ? before : used[0].name;
    show();
  }

  function show() {
    showPlot(byId('scatter-plot'), scatterOf(data, reference.value, metric.value));
  }
}

// Entries of one technique are one series, joined in the order of their times. An entry that takes
// no time is a line across.
function scatterOf(data, reference, metricName) {
  const metric = data.metrics.find(({name}) => name === metricName);
  const points = data.entries
    .map((entry) => ({
      x: entry.technique_ms,
      y: entry.errors[reference]?.[metricName] ?? null,
      label: entry.label,
      technique: entry.technique,
      title:
        `${entry.label}: ${formatNumber(entry.technique_ms, 3)} ms, ${metric.label} ` +
        formatNumber(entry.errors[reference]?.[metricName]),
    }))
    .filter(({x, y}) => x !== null && y !== null);
  const moving = points.filter(({x}) => x > 0);
  const techniques = [...new Set(moving.map(({technique}) => technique))];
  const better = {
    lower: 'lower is better',
    higher: 'higher is better',
    nearer_zero: 'nearer to 0 is better',
  };
  const unit = metric.unit === '' ? '' : ` in ${metric.unit}`;
  return {
    x: {label: 'time of the technique in ms', log: isWide(moving.map(({x}) => x))},
    y: {
      label: `${metric.label}${unit} (${better[metric.better]})`,
      log: metric.better === 'lower' && isWide(points.map(({y}) => y)),
    },
    series: techniques.map((technique, i) => ({
      label: technique,
      color: seriesColor(i),
      dots: true,
      line: true,
      points: moving.filter((point) => point.technique === technique).sort((a, b) => a.x - b.x),
    })),
    baselines: points
      .filter(({x}) => x === 0)
      .map(({y, label}) => ({y, label: `${label} (no time)`})),
  };
}

// A logarithmic axis is worth it where values span more than a factor of eight.
function isWide(values) {
  return (
    values.length > 1 && Math.min(...values) > 0 && Math.max(...values) > 8 * Math.min(...values)
  );
}

showComparison();
