// SPDX-License-Identifier: MIT
// Where the time goes: a bar for each technique, a piece for each pass.

// Passes of one kind differ in what follows '@', and share a colour.
const passKind = (name) => name.split('@')[0];

function showTimes(data) {
  const timed = data.entries.filter((entry) => entry.passes.some((pass) => pass.ms > 0));
  if (timed.length === 0) return;
  byId('times').hidden = false;
  const kinds = kindsBySize(timed);
  const total = (entry) => entry.passes.reduce((sum, pass) => sum + (pass.ms ?? 0), 0);
  const longest = Math.max(...timed.map(total));
  byId('bars').append(
    ...timed.map((entry) =>
      el(
        'div',
        {class: 'bar-row'},
        el('span', {class: 'bar-label'}, entry.label),
        el('span', {class: 'bar-total number'}, `${formatNumber(total(entry), 3)} ms`),
        bar(entry, total(entry), longest, kinds),
      ),
    ),
  );
  byId('bar-legend').append(...legend(kinds));
  byId('pass-table').append(scrollBox('Times of all passes', passTable(timed)));
}

// The eight kinds that take most time have a colour of their own, the rest share one.
function kindsBySize(entries) {
  const sums = new Map();
  for (const pass of entries.flatMap((entry) => entry.passes))
    sums.set(passKind(pass.name), (sums.get(passKind(pass.name)) ?? 0) + (pass.ms ?? 0));
  const sorted = [...sums.keys()].sort((a, b) => sums.get(b) - sums.get(a));
  return new Map(sorted.map((kind, i) => [kind, i < 8 ? seriesColor(i) : 'var(--series-rest)']));
}

function bar(entry, total, longest, kinds) {
  const label = `${entry.label}: ${formatNumber(total, 3)} ms in ${entry.passes.length} passes`;
  return el(
    'div',
    {class: 'bar', role: 'img', 'aria-label': label, style: `width: ${(total / longest) * 100}%`},
    entry.passes
      .filter((pass) => pass.ms > 0)
      .map((pass) =>
        el('span', {
          style: `flex-grow: ${pass.ms}; background-color: ${kinds.get(passKind(pass.name))}`,
          title: passTitle(pass, total),
        }),
      ),
  );
}

function passTitle({name, ms}, total) {
  const percent = ((ms / total) * 100).toFixed(1);
  return `${name}: ${formatNumber(ms, 3)} ms, ${percent} %`;
}

function legend(kinds) {
  const items = [...kinds].slice(0, 8);
  if (kinds.size > 8) items.push([`${kinds.size - 8} others`, 'var(--series-rest)']);
  return items.map(([name, color]) =>
    el(
      'li',
      {},
      el('span', {class: 'swatch', 'aria-hidden': 'true', style: `background-color: ${color}`}),
      name,
    ),
  );
}

// A row for each pass of any entry, in the order in which passes first occur.
function passTable(entries) {
  const names = [...new Set(entries.flatMap((entry) => entry.passes.map((pass) => pass.name)))];
  const timeOf = (entry, name) =>
    entry.passes
      .filter((pass) => pass.name === name)
      .reduce((sum, pass) => (sum ?? 0) + (pass.ms ?? 0), null);
  return makeTable({
    columns: [
      {heading: 'pass', sortable: true},
      ...entries.map((entry) => ({heading: entry.label, unit: 'ms', sortable: true})),
    ],
    rows: names.map((name) => [name, ...entries.map((entry) => timeOf(entry, name))]),
  });
}
