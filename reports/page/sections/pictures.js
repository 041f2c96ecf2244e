// The stage comes to life when it comes into sight, or when an address names what it shows: its images are unpacked then.
whenBuilt('pictures', (section) => {
  const element = section.querySelector('.stage');
  const stage = new Stage(element);
  stage.form.addEventListener('change', () => stage.update());
  stage.form.addEventListener('input', () => stage.requestDraw());
  stage.form.addEventListener('submit', (event) => event.preventDefault());
  for (const button of element.querySelectorAll('[data-does]')) {
    const key = button.dataset.does;
    button.addEventListener('click', () => stageKeys.find(({ test }) => test(key)).act(stage, key));
  }
  element.querySelector('.stage-copies').append(
    copyButton('Copy link', () => addressOf(stageAddress(stage))), ' ', copyButton('Copy command', () => stageCommand(stage)));
  usePointers(stage);
  useKeys(stage);
  stage.form.hidden = false;
  useAddress(stage);
  const sight = new IntersectionObserver((entries) => {
    if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
    sight.disconnect();
    if (stage.panes.length === 0) stage.update();
    new ResizeObserver(() => requestAnimationFrame(() => stage.arrange())).observe(stage.panesBox);
    addEventListener('resize', () => stage.arrange());
  });
  sight.observe(element);
});
