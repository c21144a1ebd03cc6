// SPDX-License-Identifier: MIT
// A contact sheet: cards in a grid, the search among them, and one picture large. A picture gets its
// data when its card comes near the window, so that a page of hundreds opens at once.

const grouped = (value) => value.toLocaleString('en');

// One line on a scene as one of its cameras shows it.
function sceneFacts({triangles, load_ms: loadMs}, {camera}, isOnlyPicture) {
  const parts = [
    `${grouped(triangles)} ${triangles === 1 ? 'triangle' : 'triangles'}`,
    `loaded in ${formatNumber(loadMs, 2)} ms`,
  ];
  if (!isOnlyPicture) parts.unshift(camera);
  return parts.join(' · ');
}

const warningItems = (warnings) => warnings.map((warning) => el('li', {}, warning));

function warningDetails(warnings) {
  if (warnings.length === 0) return null;
  const count = warnings.length === 1 ? '1 warning' : `${warnings.length} warnings`;
  return el(
    'details',
    {},
    el('summary', {}, count),
    el('ul', {class: 'scene-warnings'}, warningItems(warnings)),
  );
}

// The pictures in the page's order, each with its scene and number.
function entriesOf(scenes) {
  return scenes
    .flatMap((scene) => scene.pictures.map((picture) => ({scene, picture})))
    .map((entry, number) => ({...entry, number}));
}

// The data of an entry's picture. The card gets it on first use, and the page lets go of its own copy.
function pictureUrl({card, number}) {
  const image = card.querySelector('img');
  if (!image.hasAttribute('src')) {
    const packed = byId(`picture-${number}`);
    image.src = `data:image/png;base64,${packed.textContent}`;
    packed.remove();
  }
  return image.src;
}

// A path that breaks after its slashes first.
function breakable(path) {
  return path.split(/(?<=\/)/).flatMap((part, i) => (i === 0 ? [part] : [el('wbr'), part]));
}

function makeCard({scene, picture}, [width, height], onOpen) {
  const image = el('img', {width, height, alt: `${scene.name}, ${picture.camera}`});
  return el(
    'li',
    {class: 'card'},
    el('button', {type: 'button', class: 'open', title: 'Open', onclick: onOpen}, image),
    el('p', {class: 'name'}, scene.name),
    scene.source === scene.name ? null : el('p', {class: 'quiet'}, breakable(scene.source)),
    el('p', {class: 'quiet'}, sceneFacts(scene, picture, scene.pictures.length === 1)),
    warningDetails(scene.warnings),
  );
}

// Gives each card its picture before it is seen, and all of them before they are printed.
function loadWhenNear(entries) {
  const entryOf = new Map(entries.map((entry) => [entry.card, entry]));
  const observer = new IntersectionObserver(
    (changes) => {
      for (const {isIntersecting, target} of changes) {
        if (!isIntersecting) continue;
        observer.unobserve(target);
        pictureUrl(entryOf.get(target));
      }
    },
    {rootMargin: '100% 0px'},
  );
  for (const {card} of entries) observer.observe(card);
  addEventListener('beforeprint', () => entries.forEach(pictureUrl));
}

// Returns what opens an entry. `entries` that are hidden are passed over.
function makeLarge(entries) {
  const dialog = byId('large');
  let current = null;
  const show = (entry) => {
    const {scene, picture} = entry;
    current = entry;
    byId('large-name').textContent = scene.name;
    byId('large-picture').src = pictureUrl(entry);
    byId('large-picture').alt = `${scene.name}, ${picture.camera}`;
    const exposure = minus(picture.exposure_ev.toFixed(2));
    byId('large-facts').textContent = [
      scene.source === scene.name ? null : scene.source,
      sceneFacts(scene, picture, false),
      `exposure ${exposure} EV`,
    ]
      .filter(Boolean)
      .join(' · ');
    byId('large-warnings').replaceChildren(...warningItems(scene.warnings));
  };
  const step = (by) => {
    const visible = entries.filter(({card}) => !card.hidden);
    const next = visible.indexOf(current) + by;
    show(visible[(next + visible.length) % visible.length]);
  };
  byId('previous').addEventListener('click', () => step(-1));
  byId('next').addEventListener('click', () => step(1));
  byId('close').addEventListener('click', () => dialog.close());
  dialog.addEventListener('keydown', ({key}) => {
    if (key === 'ArrowLeft') step(-1);
    if (key === 'ArrowRight') step(1);
  });
  // The dialog itself is hit only where nothing in it is: on its padding and around it.
  dialog.addEventListener('click', ({target}) => {
    if (target === dialog) dialog.close();
  });
  dialog.addEventListener('close', () => current.card.querySelector('button').focus());
  return (entry) => {
    show(entry);
    dialog.showModal();
  };
}

// Hides what does not hold all words that are typed. An item is {element, text}.
function showSearch(items) {
  if (items.length < 2) return;
  byId('search').hidden = false;
  byId('search').addEventListener('submit', (event) => event.preventDefault());
  const filter = byId('filter');
  const update = () => {
    const words = filter.value.toLowerCase().split(/\s+/);
    for (const {element, text} of items)
      element.hidden = !words.every((word) => text.toLowerCase().includes(word));
    const shown = items.filter(({element}) => !element.hidden).length;
    byId('shown').textContent = shown === items.length ? '' : `${shown} of ${items.length}`;
  };
  filter.addEventListener('input', update);
  update(); // browsers may fill in what was typed before
}

function showSheet() {
  const data = readData();
  if (data.refused.length > 0)
    data.facts.push(['not drawn', el('a', {href: '#refused'}, grouped(data.refused.length))]);
  showHead(data);
  const entries = entriesOf(data.scenes);
  const open = makeLarge(entries);
  for (const entry of entries) entry.card = makeCard(entry, data.size, () => open(entry));
  byId('grid').append(...entries.map(({card}) => card));
  loadWhenNear(entries);

  const refusals = data.refused.map(({source, reason}) =>
    el('li', {}, el('span', {}, breakable(source)), el('span', {}, reason)),
  );
  byId('refusals').append(...refusals);
  byId('refused').hidden = refusals.length === 0;

  showSearch([
    ...entries.map(({card, scene, picture}) => ({
      element: card,
      text: [scene.name, scene.source, picture.camera, ...scene.warnings].join('\n'),
    })),
    ...refusals.map((element, i) => ({
      element,
      text: `${data.refused[i].source}\n${data.refused[i].reason}`,
    })),
  ]);
  showCommand(data.command);
}

showSheet();
