// A link to the view on the stage, where each picture has its own, and the command that makes the page.
function lookCopies(key) {
  return make('p', 'copy-buttons', copyButton('Copy link', () => addressOf(`#${new URLSearchParams({ view: key })}`)), ' ',
    copyButton('Copy command', () => stageData.command));
}

// The first screen: a switch for views, each with its pictures and a small chart.
whenBuilt('verdict', (section) => {
  const tabs = section.querySelector('.view-tabs');
  const look = (key) => [...section.querySelectorAll('.look')].find(({ dataset }) => dataset.view === key);
  const showLook = (key) => {
    const later = [...section.querySelectorAll('.looks > noscript')].find(({ dataset }) => dataset.view === key);
    if (later) unwrap(later);
    const shown = look(key);
    for (const other of section.querySelectorAll('.look')) other.hidden = other !== shown;
    for (const tab of tabs?.querySelectorAll('button') ?? []) tab.setAttribute('aria-pressed', String(tab.dataset.view === key));
    const chart = shown.querySelector('.small-cost-chart:empty');
    if (chart) startCostChart(chart, { brief: true });
    const words = shown.querySelector('.look-words');
    if (!words.querySelector('.copy-buttons')) words.append(lookCopies(key));
  };
  const [first] = section.querySelectorAll('.look');
  if (first) showLook(first.dataset.view);
  if (!tabs) return;
  tabs.hidden = false;
  tabs.addEventListener('click', (event) => {
    const tab = event.target.closest('button');
    if (!tab) return;
    showLook(tab.dataset.view);
    chooseStageView(tab.dataset.view);
  });
});
