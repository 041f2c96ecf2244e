// Copying links and commands. A page that was opened from disk may write to the clipboard only after a click.
async function copyText(text, button, field = null) {
  const usual = button.dataset.usual ??= button.textContent;
  try {
    await navigator.clipboard.writeText(text);
    button.textContent = 'Copied';
  } catch {
    // Where the browser refuses, the text is shown and selected for the reader to copy.
    const shown = field ?? Object.assign(make('input', 'copied-text'), { value: text, readOnly: true, ariaLabel: usual });
    if (!field) button.after(shown);
    shown.select();
    button.textContent = 'Selected: press Ctrl C';
  }
  setTimeout(() => { button.textContent = usual; }, 2000);
}

function addressOf(hash) {
  return location.href.split('#')[0] + hash;
}

function copyButton(text, wanted) {
  const button = make('button', '', text);
  button.type = 'button';
  button.addEventListener('click', () => copyText(wanted(), button));
  return button;
}

// Under every table of a section: a link to it, and the command that makes its numbers.
function addCopyButtons(section) {
  for (const box of section.querySelectorAll('.scroll')) {
    const address = new URLSearchParams({ section: section.id, table: box.getAttribute('aria-label') });
    box.after(make('p', 'copy-buttons', copyButton('Copy link', () => addressOf(`#${address}`)), ' ',
      copyButton('Copy command', () => stageData.command)));
  }
}
