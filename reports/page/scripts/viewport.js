// Where all panes look: `zoom` times as large as what fits, with the image's point (x, y), in parts of its size, amid.
// Plain wheels and one finger scroll the page; Ctrl with the wheel, two fingers and the buttons zoom, a drag moves.
const largestPixel_px = 96;

class Viewport {
  constructor(changed) {
    this.changed = changed;
    this.reset();
  }

  reset() {
    this.zoom = 1;
    this.x = 0.5;
    this.y = 0.5;
    this.changed?.();
  }

  // The image's place in a box of w x h CSS pixels: its scale and the box's coordinates of its corner.
  placeIn(w, h, image) {
    const scale = Math.min(w / image.width, h / image.height) * this.zoom;
    const corner = (size, shown, centre) => {
      const full = size * scale;
      if (full <= shown) return (shown - full) / 2;
      return Math.min(0, Math.max(shown - full, shown / 2 - centre * full));
    };
    return { scale, left: corner(image.width, w, this.x), top: corner(image.height, h, this.y) };
  }

  // Zooms by `factor` so that the point (px, py) of the box stays where it is.
  zoomAt(factor, px, py, w, h, image) {
    const before = this.placeIn(w, h, image);
    const fit = before.scale / this.zoom;
    const u = (px - before.left) / (image.width * before.scale);
    const v = (py - before.top) / (image.height * before.scale);
    this.zoom = Math.min(Math.max(this.zoom * factor, 1), Math.max(1, largestPixel_px / fit));
    const scale = fit * this.zoom;
    this.x = (w / 2 - px) / (image.width * scale) + u;
    this.y = (h / 2 - py) / (image.height * scale) + v;
    this.settle(w, h, image);
  }

  moveBy(dx, dy, w, h, image) {
    const { scale } = this.placeIn(w, h, image);
    this.x -= dx / (image.width * scale);
    this.y -= dy / (image.height * scale);
    this.settle(w, h, image);
  }

  // Takes back what the image's border does not allow, so that the way back is as long as the way there.
  settle(w, h, image) {
    const { scale, left, top } = this.placeIn(w, h, image);
    this.x = (w / 2 - left) / (image.width * scale);
    this.y = (h / 2 - top) / (image.height * scale);
    this.changed();
  }

  // Shows a region of the image, in its pixels, with as much around it.
  showRegion(region, w, h, image) {
    const fit = Math.min(w / image.width, h / image.height);
    const wanted = Math.min(w / region.width, h / region.height) / 2;
    this.zoom = Math.min(Math.max(wanted / fit, 1), Math.max(1, largestPixel_px / fit));
    this.x = (region.x + region.width / 2) / image.width;
    this.y = (region.y + region.height / 2) / image.height;
    this.settle(w, h, image);
  }
}
