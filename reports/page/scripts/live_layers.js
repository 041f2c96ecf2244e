// Depth layers of a view, gathered from the surfaces behind one another that the page holds: shaders/gbuffer/gathered_layers.frag
// tosses the coins that the run tossed for triangles.

class LiveLayers {
  constructor(runner) {
    this.runner = runner;
    this.made = [];
    this.gathered = '';
    this.surfaces = null;  // of the runner's view, once they are unpacked
  }

  make(...array) {
    const texture = this.runner.live.textureArray(...array);
    this.made.push(texture);
    return texture;
  }

  // Forgets those of an earlier view.
  clear() {
    for (const texture of this.made.splice(0)) this.runner.live.deleteTexture(texture);
    this.gathered = '';
    this.layers = null;
    this.none = null;
    this.surfaces = null;
  }

  // Unpacks the surfaces of the runner's view, unless another view has come meanwhile. `say(text)` is told how far it is.
  async unpack(say) {
    const { view } = this.runner;
    if (this.surfaces) return;
    const { count, depths, triangles } = await unpackedSurfaces(view, say);
    if (this.surfaces || this.runner.view !== view) return;
    const { width, height } = count > 0 ? view : { width: 1, height: 1 };  // an empty picture has arrays, too
    const make = (format, data) => this.make(format, width, height, Math.max(count, 1), count > 0 ? data : null);
    this.surfaces = { count, depths: make('R', depths), triangles: make('U', triangles) };
  }

  // What a program gets that could read side cameras and is not to.
  noSideLayers(members, parameters) {
    if (memberValue(members, 'cameras', parameters) !== 0) throw new Error('Depth layers of further cameras need the scene, which the page does not hold.');
    this.none ??= this.make('RGBA', 1, 1, 1);
    return this.none;
  }

  // Of these settings; one gathering is kept.
  texture(members, parameters) {
    const value = (member) => memberValue(members, member, parameters);
    const samples = value('samples');
    const sampling = this.runner.contract.layer_samplings[value('sampling')];
    if (!sampling) throw new Error(`Depth layers by the sampling ${value('sampling')} need the scene, which the page does not hold.`);
    const wanted = JSON.stringify(Object.keys(members).map(value));
    if (this.gathered === wanted) return this.layers;
    const { width, height } = this.runner.view;
    const pictures = Math.ceil(samples / 4);
    if (this.pictures !== pictures || !this.layers) {
      if (this.layers) this.runner.live.deleteTexture(this.made.splice(this.made.indexOf(this.layers), 1)[0]);
      this.layers = this.make('RGBA', width, height, pictures);
      this.pictures = pictures;
    }
    const macros = { SAMPLES: samples, PER_SAMPLE: Number(value('per_sample')), [sampling]: '', ...(value('facing') ? { FACING: '' } : {}) };
    for (let picture = 0; picture < pictures; picture += 1) this.draw(macros, picture, value);
    this.gathered = wanted;
    return this.layers;
  }

  draw(macros, picture, value) {
    const { runner } = this;
    const { width, height } = runner.view;
    const { count, depths, triangles } = this.surfaces;
    const inputs = { u_surface_depths: depths, u_surface_triangles: triangles };
    const target = { texture: this.layers, layer: picture, width, height };
    runner.live.draw(runner.derivedProgram('gathered_layers.frag', macros), target, inputs, (set) => {
      runner.setViewUniforms(set);
      set('u_surfaces', '1i', count);
      set('u_picture', '1i', picture);
      set('u_alpha', '1f', value('alpha'));
      set('u_seed', '1ui', value('seed') || runner.contract.seed);
      set('u_least_gap', '1f', value('least_gap'));
    });
  }
}

// A member of a descriptor's "depth_layers" or "side_layers", for these parameters.
function memberValue(members, member, parameters) {
  const value = members[member];
  return typeof value === 'string' && value.startsWith('@') ? parameters[value.slice(1)] : value;
}
