// A small version of a view for a first picture: every so many pixels of its G-buffer (src/page/live/live_preview.h), which a
// camera of fewer and larger pixels would see too.
function previewView(view) {
  const factor = view.preview_factor;
  return { ...view, width: Math.ceil(view.width / factor), height: Math.ceil(view.height / factor),
    pixel_size: view.pixel_size.map((size) => size * factor), inputs: view.preview_inputs, surfaces: view.preview_surfaces };
}
