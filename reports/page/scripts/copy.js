// Copying links and commands. A page that was opened from disk may write to the clipboard only after a click.
async function copyText(text, button, field = null) {
  const usual = button.dataset.usual ??= button.textContent;
  try {
    await navigator.clipboard.writeText(text);
    button.textContent = 'Copied';
  } catch {
    // Where the browser refuses, the text is shown and selected for the reader to copy.
    const shown = field ?? Object.assign(make('input', 'copied-text'), { value: text, readOnly: true, ariaLabel: button.ariaLabel ?? usual });
    if (!field) button.after(shown);
    shown.select();
    button.textContent = 'Selected: press Ctrl C';
  }
  setTimeout(() => { button.textContent = usual; }, 2000);
}

function addressOf(hash) {
  return location.href.split('#')[0] + hash;
}

// `wanted()` gives the text, or a promise of it.
function copyButton(text, wanted) {
  const button = make('button', '', text);
  button.type = 'button';
  button.addEventListener('click', async () => copyText(await wanted(), button));
  return button;
}

// The command that measures one cell alone.
let cellCommands = null;
async function cellCommand(id) {
  cellCommands ??= inflatedBytes('commands').then((bytes) => JSON.parse(new TextDecoder().decode(bytes)));
  return (await cellCommands)[id];
}

// The part of a section that has this name.
function partNamed(section, name) {
  return [...section.querySelectorAll('[aria-label]')].find((part) => part.getAttribute('aria-label') === name);
}

function copyLine(section, name) {
  const address = new URLSearchParams({ section: section.id, part: name });
  return make('p', 'copy-buttons', copyButton('Copy link', () => addressOf(`#${address}`)), ' ',
    copyButton('Copy command', () => stageData.command));
}

// Under every table, chart and row of pictures: a link to it, and the command that makes it; in every row of one cell, the
// command of that cell.
function addCopyButtons(section) {
  for (const part of section.querySelectorAll('.scroll, .chart, .sweep-chart, .thumbnails')) {
    if (part.closest('.live')) continue;  // it says the command of its setting itself
    const line = copyLine(section, part.getAttribute('aria-label'));
    const figure = part.closest('figure');
    if (figure) figure.append(line);
    else part.after(line);
  }
  for (const row of section.querySelectorAll('tr[data-cell]')) {
    const button = copyButton('copy', () => cellCommand(row.dataset.cell));
    button.ariaLabel = button.title = `Copy the command that measures ${row.dataset.cell} alone`;
    button.className = 'copy-cell';
    row.querySelector('th')?.append(' ', button);
  }
}
