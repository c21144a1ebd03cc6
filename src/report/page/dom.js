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

// A formatter with equally many decimals for all numbers of a column: four digits for the largest,
// two for the smallest, at most six decimals.
function columnFormatter(values) {
  const sizes = values.filter((v) => typeof v === 'number' && v !== 0).map(Math.abs);
  if (sizes.length === 0) return formatNumber;
  const largest = Math.max(...sizes);
  const smallest = Math.min(...sizes);
  if (largest >= 1e7 || smallest < 1e-5) return (value) => formatNumber(value, 3);
  if (values.every((v) => typeof v !== 'number' || Number.isInteger(v)))
    return (value) => (typeof value === 'number' ? minus(value.toFixed(0)) : '–');
  const leading = (value) => Math.floor(Math.log10(value));
  const wanted = Math.max(3 - leading(largest), 1 - leading(smallest));
  const decimals = Math.min(Math.max(wanted, 0), 6);
  return (value) => (typeof value === 'number' ? minus(value.toFixed(decimals)) : '–');
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
  byId('facts').append(...facts.filter(([, value]) => value !== '').map(([name, value]) =>
      el('div', {}, el('dt', {}, name), el('dd', {}, value))));
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
    button.textContent = await copyText(command) ? 'Copied' : 'Select the text and copy it';
    setTimeout(() => { button.textContent = 'Copy'; }, 2000);
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
