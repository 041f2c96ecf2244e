// Nothing is unpacked or compiled before the section is opened.
whenBuilt('live', (section) => section.querySelector('details.live')?.addEventListener('toggle', async ({ target: details }) => {
  try {
    const index = JSON.parse(new TextDecoder().decode(await inflatedBytes('live index')));
    const bench = new LiveBench(details, index);
    details.querySelector('.live-bench').hidden = false;
    await bench.chooseView(stageData.views[0].key);
  } catch (error) {
    details.querySelector('.live-bench').hidden = true;
    const failure = details.querySelector('.live-failure');
    failure.textContent = error.message;
    failure.hidden = false;
  }
}, { once: true }));
