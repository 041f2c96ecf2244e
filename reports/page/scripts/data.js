// What the page knows of its views, methods and images (src/page/sections/stage_data.h).
const stageData = JSON.parse(document.getElementById('stage-data').textContent);
for (const { images } of stageData.views) if (images.depth?.exact) images.depth.valid = images.noise;
window.addEventListener('error', (event) => { document.documentElement.dataset.scriptError = event.message; });
window.addEventListener('unhandledrejection', (event) => {
  document.documentElement.dataset.scriptError = String(event.reason);
});
