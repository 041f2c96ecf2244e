// Folded sections: a line with the section's result, and its contents, which a script builds when a reader unfolds it. They
// lie in a noscript element, which is one text where scripts run, and plain contents where they do not.
const sectionBuilders = new Map();

// Has `act(section)` called once, when the section's contents are there.
function whenBuilt(id, act) {
  const section = document.getElementById(id);
  if (!section) return;
  if (section.querySelector(':scope > .fold > noscript')) sectionBuilders.set(id, act);
  else act(section);
}

// Puts the contents of a noscript element in its place.
function unwrap(noscript) {
  const holder = document.createElement('template');
  holder.innerHTML = noscript.textContent;
  noscript.replaceWith(holder.content);
}

function buildSection(section) {
  const noscript = section.querySelector(':scope > .fold > noscript');
  if (!noscript) return;
  unwrap(noscript);
  for (const element of section.querySelectorAll('.without-scripts')) element.remove();
  addCopyButtons(section);
  useColumns(section);
  sectionBuilders.get(section.id)?.(section);
}

function unfold(section) {
  const fold = section.querySelector(':scope > .fold');
  if (!fold) return;
  fold.open = true;  // first, so that tables know their place when they are built
  buildSection(section);
}

// The section that holds the element of that id, though it may not be built yet.
function sectionOf(id) {
  const built = document.getElementById(id);
  if (built) return built.closest('main > section');
  return [...document.querySelectorAll('main > section')].find((section) =>
    section.querySelector(':scope > .fold > noscript')?.textContent.includes(` id="${CSS.escape(id)}"`)) ?? null;
}

// Unfolds what the address names: the id of a section or of something in it, or `section` with the name of a `part`.
function followFold() {
  const hash = decodeURIComponent(location.hash.slice(1));
  const entries = new URLSearchParams(location.hash.slice(1));
  const section = entries.has('section') ? document.getElementById(entries.get('section')) : sectionOf(hash);
  if (hash === '' || !section?.matches('main > section')) return false;
  unfold(section);
  (partNamed(section, entries.get('part')) ?? document.getElementById(hash) ?? section).scrollIntoView({ behavior: 'instant' });  // a slow way would start the stage on it
  return true;
}

for (const fold of document.querySelectorAll('.fold')) {
  fold.addEventListener('toggle', () => { if (fold.open) buildSection(fold.parentElement); });
}
addEventListener('hashchange', followFold);
addEventListener('beforeprint', () => { document.querySelectorAll('main > section').forEach(unfold); });
// Sections register what they do when they are built further down in this script.
queueMicrotask(() => {
  document.documentElement.dataset.interactive = performance.now().toFixed(0);
  const [first] = document.querySelectorAll('main > section');
  if (first) unfold(first);
  followFold();
});
