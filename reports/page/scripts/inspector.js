// The exact values of every image under the pointer, as the page holds them.
class Inspector {
  constructor(element) {
    this.body = element.querySelector('tbody');
    this.place = element.querySelector('.pixel-place');
    this.note = element.querySelector('.inspector-note');
    this.turn = 0;
  }

  async show(view, pixel) {
    const turn = ++this.turn;
    this.note.textContent = quantisationText(view);
    if (!pixel) return;
    this.place.textContent = `Pixel ${pixel.x}, ${pixel.y}`;
    const i = pixel.x + pixel.y * view.width;
    const { truth, noise, depth } = view.images;
    const [base, error] = await Promise.all([truth, noise].map(imageValues));
    const compared = error.codes[i] !== error.none;
    const rows = [{ name: 'Truth', value: numberText(base.at(i), decimalsOf(truth)),
      error: !view.noiseHigh ? '' : compared ? `± ${numberText(error.at(i), 3)}` : 'not compared' }];
    for (const { name, images } of view.cells) {
      if (!images) continue;
      for (const [kind, image] of Object.entries(images)) {
        const values = await imageValues(image);
        rows.push({ name: kind === 'raw' ? `${name}, raw` : name, kind, value: numberText(values.at(i), decimalsOf(image)),
          error: compared ? signedText(values.at(i) - base.at(i), decimalsOf(image)) : '' });
      }
    }
    if (depth) {
      const metres = (await imageValues(depth)).at(i);
      rows.push({ name: 'Depth', value: Number.isNaN(metres) ? 'no surface' : `${numberText(metres, 3)} m`, error: '' });
    }
    for (const { id, label } of occlusionParts(view)) {
      const occlusion = (await imageValues(view.images[id])).at(i);
      rows.push({ name: label, value: numberText(occlusion, decimalsOf(view.images[id])), error: '' });
    }
    if (turn !== this.turn) return;
    this.body.replaceChildren(...rows.map(({ name, value, error: off }) => {
      const head = make('th', '', name);
      head.scope = 'row';
      return make('tr', '', head, make('td', '', value), make('td', '', off));
    }));
  }
}

function quantisationText({ images }) {
  const levels = Math.round(1 / images.truth.step);
  return `Visibility is kept in steps of 1/${levels}: what stands here is within half a step of the EXR files.`;
}

// What is known of the truth's occlusion: its causes, and what one layer of depth could show of it.
function occlusionParts({ images }) {
  return [...stageData.causes.map(({ id, label }) => ({ id, label: `Occluded: ${label}` })),
    { id: 'one_layer', label: 'Occluded, in one layer' }].filter(({ id }) => images[id]);
}
