// Nothing is unpacked or compiled before the section is opened.
whenBuilt('live', (section) => section.querySelector('details.live')?.addEventListener('toggle', async ({ target: details }) => {
  try {
    const index = JSON.parse(new TextDecoder().decode(await inflatedBytes('live index')));
    const bench = new LiveBench(details, index);
    await bench.chooseView(stageData.views[0].key);
    details.querySelector('.live-bench').hidden = false;
  } catch (error) {
    const failure = details.querySelector('.live-failure');
    failure.textContent = error.message;
    failure.hidden = false;
  }
}, { once: true }));
