'use strict';
// A page that was opened from disk may be refused the clipboard: then the text is selected for the reader to copy.
for (const button of document.querySelectorAll('button[data-of]')) {
  button.addEventListener('click', async () => {
    const text = document.getElementById(button.dataset.of);
    try {
      await navigator.clipboard.writeText(text.textContent);
      button.textContent = 'Copied';
    } catch {
      getSelection().selectAllChildren(text);
      button.textContent = 'Selected: press Ctrl C';
    }
    setTimeout(() => { button.textContent = 'Copy'; }, 2000);
  });
}
