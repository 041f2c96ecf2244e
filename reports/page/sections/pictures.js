// The stage comes to life once the page is parsed; its images are unpacked as they are shown.
const stageElement = document.querySelector('.stage');
if (stageElement) {
  const stage = new Stage(stageElement);
  const again = () => stage.update();
  stage.form.addEventListener('change', again);
  stage.form.addEventListener('input', () => stage.requestDraw());
  stage.form.addEventListener('submit', (event) => event.preventDefault());
  for (const button of stageElement.querySelectorAll('[data-does]')) {
    const key = button.dataset.does;
    button.addEventListener('click', () => stageKeys.find(({ test }) => test(key)).act(stage, key));
  }
  usePointers(stage);
  useKeys(stage);
  new ResizeObserver(() => stage.requestDraw()).observe(stage.panesBox);
  stage.form.hidden = false;
  stage.update();
  const jumped = followAddress(stage);
  useAddress(stage);
  if (jumped) stageElement.scrollIntoView();
}
