// Thumbnails of the worst regions: the signed error there, with as much around it. Painted when they come into sight.
const thumbnailMargin = 0.5;

async function paintRegion(link) {
  const { view: key, cell: id, box } = link.dataset;
  const view = stageData.views.find((other) => other.key === key);
  const cell = view.cells.find((other) => other.id === id);
  const { canvas: error } = await paintedLayer(layerOf('error', view, cell, { range: 0.5, gray: false }));
  const [left, top, width, height] = box.split(',').map(Number);
  const canvas = link.querySelector('canvas');
  const scale = Math.min(canvas.width / width, canvas.height / height) / (1 + thumbnailMargin);
  const context = canvas.getContext('2d');
  context.imageSmoothingEnabled = scale < 1;
  context.translate(canvas.width / 2, canvas.height / 2);
  context.scale(scale, scale);
  context.drawImage(error, -left - width / 2, -top - height / 2);
  context.lineWidth = 1.5 / scale;
  context.strokeStyle = '#000';
  context.strokeRect(-width / 2, -height / 2, width, height);
  canvas.dataset.painted = 'true';
}

const regionsInSight = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    regionsInSight.unobserve(target);
    paintRegion(target);
  }
}, { rootMargin: '200px' });
whenBuilt('failures', (section) => {
  for (const link of section.querySelectorAll('.regions a')) regionsInSight.observe(link);
});
