// Pointers over the panes: they inspect, drag, move the cut of a swipe, and pinch. Nothing here stops the page from
// scrolling unless it zooms.
const cutReach_px = 14;

function usePointers(stage) {
  const box = stage.panesBox;
  const pointers = new Map();
  let dragsCut = false;
  const paneOf = (event) => stage.panes.find((pane) => pane.canvas === event.target);
  const toCut = (pane, event) => {
    const { left, width } = pane.canvas.getBoundingClientRect();
    return (event.clientX - left) / width * 100;
  };

  box.addEventListener('wheel', (event) => {
    const pane = paneOf(event);
    if (!pane || !event.ctrlKey) return;
    event.preventDefault();
    const { left, top } = pane.canvas.getBoundingClientRect();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 40 : 1;
    stage.zoomBy(Math.exp(-event.deltaY * lines / 300), event.clientX - left, event.clientY - top);
  }, { passive: false });

  box.addEventListener('dblclick', (event) => {
    const pane = paneOf(event);
    if (!pane) return;
    const { left, top } = pane.canvas.getBoundingClientRect();
    stage.zoomBy(2, event.clientX - left, event.clientY - top);
  });

  box.addEventListener('pointerdown', (event) => {
    const pane = paneOf(event);
    if (!pane || event.button !== 0) return;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const off_px = Math.abs(toCut(pane, event) - stage.choice.cut) / 100 * pane.canvas.clientWidth;
    dragsCut = stage.choice.mode === 'swipe' && off_px < cutReach_px;
    if (event.pointerType === 'mouse' || dragsCut) pane.canvas.setPointerCapture(event.pointerId);
  });

  box.addEventListener('pointermove', (event) => {
    const pane = paneOf(event);
    if (!pane) return;
    const last = pointers.get(event.pointerId);
    const pixel = pane.pixelAt(event.clientX, event.clientY);
    if (pixel && !last) stage.inspect(pixel);
    if (!last) return;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (dragsCut) {
      stage.form.elements.cut.value = String(toCut(pane, event));
      stage.requestDraw();
    } else if (pointers.size === 2) {
      pinch(pane, last, event);
    } else {
      stage.viewport.moveBy(event.clientX - last.x, event.clientY - last.y, ...stage.frame);
    }
  });

  const pinch = (pane, last, event) => {
    const [other] = [...pointers.entries()].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    const before = Math.hypot(last.x - other.x, last.y - other.y);
    const after = Math.hypot(event.clientX - other.x, event.clientY - other.y);
    const { left, top } = pane.canvas.getBoundingClientRect();
    if (before > 0) {
      stage.zoomBy(after / before, (event.clientX + other.x) / 2 - left, (event.clientY + other.y) / 2 - top);
    }
  };

  for (const name of ['pointerup', 'pointercancel']) {
    box.addEventListener(name, (event) => {
      if (!pointers.delete(event.pointerId)) return;
      dragsCut = false;
      const pixel = paneOf(event)?.pixelAt(event.clientX, event.clientY);
      if (name === 'pointerup' && pixel) stage.pin(pixel);
    });
  }
}
