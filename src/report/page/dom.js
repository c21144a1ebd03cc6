// SPDX-License-Identifier: MIT
// Elements and numbers. Text reaches the page only as text nodes and attributes, never as markup.

const byId = (id) => document.getElementById(id);

// Makes an element. Attributes whose name starts with "on" are listeners; true is an attribute
// without value, false, null and undefined are none. Children are nodes or text.
function el(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

function svgEl(tag, attributes = {}, ...children) {
  return fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);
}

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false && value !== null && value !== undefined)
      element.setAttribute(name, value);
  }
  element.append(...children.flat().filter((child) => child !== null));
  return element;
}

// A number of so many digits, and a dash for none.
function formatNumber(value, digits = 4) {
  if (typeof value !== 'number') return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-4) return minus(value.toExponential(digits - 1));
  return minus(size >= 10 ** digits ? value.toFixed(0) : value.toPrecision(digits));
}

// A formatter with equally many decimals for all numbers of a column: as many as give the largest
// so many digits, or one more where that shows small ones better. What they do not show is written
// with an exponent.
function columnFormatter(values, digits) {
  const numbers = values.filter((value) => typeof value === 'number');
  const sizes = numbers.filter((value) => value !== 0).map(Math.abs);
  const format = (decimals) => (value) => {
    if (typeof value !== 'number') return '–';
    const vanishes = value !== 0 && Math.abs(value) < 0.5 * 10 ** -decimals;
    return minus(vanishes ? value.toExponential(1) : value.toFixed(decimals));
  };
  if (numbers.every(Number.isInteger)) return format(0);
  const leading = (value) => Math.floor(Math.log10(value));
  const forLargest = digits - 1 - leading(Math.max(...sizes));
  const forSmallest = digits - 2 - leading(Math.min(...sizes));
  return format(Math.min(Math.max(forLargest, Math.min(forSmallest, forLargest + 1), 0), 12));
}

// The typographic sign lines up with digits.
function minus(text) {
  return text.replace('-', '−').replace('e+', 'e');
}

// The data that the page carries.
function readData() {
  return JSON.parse(byId('data').textContent);
}

// --- parts that all pages share ------------------------------------------------------------------

// Title, facts and warnings at the head of a page.
function showHead({title, summary, facts, warnings}) {
  byId('title').textContent = title;
  if (summary) byId('summary').textContent = summary;
  byId('facts').append(
    ...facts
      .filter(([, value]) => value !== '')
      .map(([name, value]) => el('div', {}, el('dt', {}, name), el('dd', {}, value))),
  );
  for (const warning of warnings) warn(warning);
}

function warn(text) {
  byId('warnings').append(el('li', {}, text));
  byId('warnings').hidden = false;
}

// The command that reproduces the page, with a button that copies it.
function showCommand(command) {
  if (command === '') return;
  byId('command').textContent = command;
  byId('reproduce').hidden = false;
  const button = byId('copy');
  button.addEventListener('click', async () => {
    button.textContent = (await copyText(command)) ? 'Copied' : 'Select the text and copy it';
    setTimeout(() => {
      button.textContent = 'Copy';
    }, 2000);
  });
}

// Pages opened from a file may have no clipboard; the selection then does.
async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    getSelection().selectAllChildren(byId('command'));
    return document.execCommand('copy');
  }
}
