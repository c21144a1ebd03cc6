// SPDX-License-Identifier: MIT
// Tables with aligned numbers, grouped headings and, where asked for, sorting.

// A column is {heading, unit, group, title, digits, better, sortable}: `digits` are those of its
// largest number, 4 if absent; `better` is "lower", "higher", "nearer_zero" or absent. A row is a
// list of cells: numbers, text, null, or nodes. A column of numbers marks its best ones where it has
// `better`; `ranked(row, column)` may leave rows out.
function makeTable({caption, columns, rows, ranked = () => true}) {
  const numeric = columns.map((_, c) => rows.some((row) => typeof row[c] === 'number'));
  const body = el('tbody');
  const bodyRows = rows.map((row, r) => ({row, element: bodyRow(row, r)}));
  const headings = columns.map(heading);
  const table = el(
    'table',
    {},
    caption ? el('caption', {}, caption) : null,
    el('thead', {}, groupRow(columns), el('tr', {}, headings)),
    body,
  );
  body.append(...bodyRows.map(({element}) => element));
  return table;

  function bodyRow(row, r) {
    return el(
      'tr',
      {},
      row.map((cell, c) => {
        const tag = c === 0 ? 'th' : 'td';
        const best = isBest(r, c);
        const attributes = {
          scope: c === 0 ? 'row' : null,
          class:
            [numeric[c] ? 'number' : '', best ? 'best' : '', starts(c) ? 'starts' : '']
              .filter(Boolean)
              .join(' ') || null,
          title: best ? 'best of its column' : null,
        };
        return el(tag, attributes, numeric[c] ? formatterOf(c)(cell) : (cell ?? '–'));
      }),
    );
  }

  function formatterOf(c) {
    return (columns[c].formatter ??= columnFormatter(
      rows.map((row) => row[c]),
      columns[c].digits ?? 4,
    ));
  }

  function isBest(r, c) {
    const rank = {
      lower: (v) => v,
      higher: (v) => -v,
      nearer_zero: (v) => Math.abs(v),
    }[columns[c].better];
    if (!rank || typeof rows[r][c] !== 'number' || !ranked(r, c)) return false;
    const rivals = rows
      .filter((row, k) => typeof row[c] === 'number' && ranked(k, c))
      .map((row) => rank(row[c]));
    return rivals.length > 1 && rank(rows[r][c]) === Math.min(...rivals);
  }

  // A column starts a group where its neighbour has another one.
  function starts(c) {
    return c > 0 && (columns[c].group ?? '') !== (columns[c - 1].group ?? '');
  }

  function heading(column, c) {
    const arrow = {lower: ' ↓', higher: ' ↑', nearer_zero: ' → 0'}[column.better] ?? '';
    const spoken = {
      lower: 'lower is better',
      higher: 'higher is better',
      nearer_zero: 'nearer to 0 is better',
    }[column.better];
    const title = [column.title, spoken && `${spoken}.`].filter(Boolean).join(' ') || null;
    const unit = el('span', {class: 'unit'}, `${column.unit ?? ''}${arrow}`);
    const content = [el('span', {}, column.heading), unit];
    const attributes = {
      scope: 'col',
      title,
      class:
        [numeric[c] ? 'number' : '', starts(c) ? 'starts' : ''].filter(Boolean).join(' ') || null,
    };
    if (!column.sortable) return el('th', attributes, content);
    const label = [column.group, column.heading, column.unit, spoken].filter(Boolean).join(', ');
    return el(
      'th',
      {...attributes, 'aria-sort': 'none'},
      el(
        'button',
        {type: 'button', 'aria-label': `Sort by ${label}`, onclick: () => sort(c)},
        content,
      ),
    );
  }

  // Sorts by a column, first with the better values on top, then the other way round.
  function sort(c) {
    const before = headings[c].getAttribute('aria-sort');
    const first = columns[c].better === 'higher' ? 'descending' : 'ascending';
    const second = first === 'ascending' ? 'descending' : 'ascending';
    const order = before === first ? second : first;
    for (const other of headings)
      if (other.hasAttribute('aria-sort')) other.setAttribute('aria-sort', 'none');
    headings[c].setAttribute('aria-sort', order);
    const sign = order === 'ascending' ? 1 : -1;
    bodyRows.sort((a, b) => compareCells(a.row[c], b.row[c], sign));
    body.append(...bodyRows.map(({element}) => element));
  }
}

// Cells without a number come last in either order.
function compareCells(a, b, sign) {
  if (typeof a === 'number' && typeof b === 'number') return sign * (a - b);
  if (typeof a === 'number') return -1;
  if (typeof b === 'number') return 1;
  return sign * String(a ?? '').localeCompare(String(b ?? ''), 'en', {numeric: true});
}

// The row above the headings; null where no column has a group.
function groupRow(columns) {
  if (!columns.some((column) => column.group)) return null;
  const cells = [];
  for (let c = 0; c < columns.length;) {
    let end = c + 1;
    const group = columns[c].group ?? '';
    while (end < columns.length && (columns[end].group ?? '') === group) ++end;
    cells.push(
      group === ''
        ? el('td', {colspan: end - c})
        : el(
            'th',
            {colspan: end - c, scope: 'colgroup', class: c > 0 ? 'starts group' : 'group'},
            group,
          ),
    );
    c = end;
  }
  return el('tr', {}, cells);
}

// A box in which a wide table scrolls, by keyboard, too.
function scrollBox(label, ...children) {
  return el(
    'div',
    {class: 'scroll', tabindex: 0, role: 'region', 'aria-label': label},
    ...children,
  );
}
