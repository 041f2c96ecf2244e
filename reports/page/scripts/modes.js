// The ways to hold pictures against each other. Each says which panes there are: [base, top] or [base] of layers; and how
// the top lies over the base. `chosen` is the method's picture, `against` what it is held against.
const modes = {
  alone: { panes: ({ chosen }) => [[chosen]] },
  beside: { panes: ({ against, chosen }) => [[against], [chosen]] },
  swipe: { panes: ({ against, chosen }) => [[chosen, against]] },
  blink: { panes: ({ against, chosen }) => [[chosen, against]] },
  onion: { panes: ({ against, chosen }) => [[chosen, against]] },
  difference: { panes: ({ difference }) => [[difference]] },
  all: { panes: ({ truth, everyMethod }) => [[truth], ...everyMethod.map((layer) => [layer])] },
};

function drawComparison(context, pane, place, w, h) {
  const { base, top, image } = pane;
  const { mode, cut, mix } = pane.stage.choice;
  const draw = (painted) => drawPainted(context, painted, image, place, w, h);
  if (!top) {
    draw(base);
  } else if (mode === 'blink') {
    draw(pane.stage.blink.showsTop ? top : base);
  } else if (mode === 'onion') {
    draw(base);
    context.globalAlpha = 1 - mix / 100;
    draw(top);
    context.globalAlpha = 1;
  } else {
    const x = cutPosition(cut, w);
    draw(base);
    context.save();
    context.beginPath();
    context.rect(0, 0, x, h);
    context.clip();
    context.clearRect(0, 0, x, h);
    draw(top);
    context.restore();
    context.fillStyle = '#000';
    context.fillRect(x - 2, 0, 4, h);
    context.fillStyle = '#fff';
    context.fillRect(x - 1, 0, 2, h);
  }
}

function cutPosition(cut, w) {
  return Math.round(cut / 100 * w);
}

// Changes the blinking pane by the clock, never more than three times a second (WCAG 2.3.1), and not at all for those
// who asked for less motion: they change it by the key.
class Blink {
  constructor(stage) {
    this.stage = stage;
    this.showsTop = false;
    this.timer = 0;
    this.running = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  }

  set(interval_ms) {
    clearInterval(this.timer);
    if (interval_ms && this.running) this.timer = setInterval(() => this.change(), Math.max(interval_ms, 334));
  }

  change() {
    this.showsTop = !this.showsTop;
    this.stage.requestDraw();
    this.stage.said();
  }
}
