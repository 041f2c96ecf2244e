// Runs methods and filters of the registry on one view's G-buffer, as screen/method_runner.cpp does with GL 3.3.

// Points of a kernel at its present size: the table's first ones, scaled as screen/kernel.h says.
const kernelPoints = (kernel, parameters) => {
  const valueOf = (member) => (member.startsWith('@') ? parameters[member.slice(1)] : member);
  const size = Number(valueOf(kernel.size)), scale = valueOf(kernel.scale);
  const table = kernel.tables.find(({ when }) => Object.entries(when).every(([id, choice]) => parameters[id] === choice));
  const points = Float32Array.from(table.points.slice(0, 3 * size));
  if (scale === 'none') return points;
  return points.map((component, i) => {
    const t = Math.floor(i / 3) / (scale === 'squared_of_64' ? 64 : size);
    return component * (0.1 + 0.9 * t * t);
  });
};

class LiveRunner {
  // Runners on one `live` share their programs.
  constructor(contract, live = new LiveGl()) {
    this.live = live;
    this.contract = contract;
    this.noise = this.live.texture('RGBA', 4, 4, { data: Float32Array.from(contract.noise_4x4) });
    this.textures = new Map();
    this.layers = new LiveLayers(this);
  }

  // `inputs`: {name: {format: 'R' or 'RGBA', data}} of the G-buffer.
  setView(view, inputs) {
    for (const { texture } of this.textures.values()) this.live.deleteTexture(texture);
    this.textures.clear();
    this.view = view;
    this.layers.clear();
    for (const [name, { format, data }] of Object.entries(inputs)) {
      this.textures.set(name, { texture: this.live.texture(format, view.width, view.height, { data }) });
    }
  }

  // Whether all that the method reads is here: depth layers are gathered from surfaces, which layers.unpack() brings.
  holdsInputsOf(method) {
    return !method.depth_layers || this.layers.surfaces !== null;
  }

  target(name, scale) {
    const key = `target ${name} ${scale}`;
    if (!this.textures.has(key)) {
      const width = Math.ceil(this.view.width / scale), height = Math.ceil(this.view.height / scale);
      this.textures.set(key, { texture: this.live.texture('R', width, height), width, height });
    }
    return this.textures.get(key);
  }

  setViewUniforms(set) {
    const { width, height, pixel_size: pixelSize, near_m: near, far_m: far } = this.view;
    set('u_size_px', '2f', width, height);
    set('u_pixel_size', '2f', ...pixelSize);
    set('u_near', '1f', near);
    set('u_far', '1f', far);
  }

  derivedProgram(file, macros) {
    const all = { ORTHOGRAPHIC: Number(this.view.orthographic), ...macros };
    return this.live.program(this.contract.screen_vertex, this.contract.derived[file], all);
  }

  normalFromDepth(accurate) {
    const key = `normal_from_depth ${accurate}`;
    if (!this.textures.has(key)) {
      const { width, height } = this.view;
      const made = { texture: this.live.texture('RGBA', width, height), width, height };
      this.textures.set(key, made);
      this.live.draw(this.derivedProgram('normal_from_depth.frag', { ACCURATE: Number(accurate) }), made,
        { u_linear_depth: this.textures.get('linear_depth').texture }, (set) => this.setViewUniforms(set));
    }
    return this.textures.get(key).texture;
  }

  // One chain is kept: a radius that is dragged makes many.
  depthMips(filter, radius) {
    const { width, height } = this.view;
    const levels = Math.min(this.contract.depth_mip_levels, 1 + Math.floor(Math.log2(Math.max(width, height))));
    if (!this.textures.has('depth_mips')) {
      this.textures.set('depth_mips', { texture: this.live.texture('R', width, height, { levels }), of: '' });
    }
    const mips = this.textures.get('depth_mips');
    if (mips.of === `${filter} ${radius}`) return mips.texture;
    mips.of = `${filter} ${radius}`;
    const program = this.derivedProgram('depth_mip.frag', { WEIGHTED: Number(filter === 'weighted') });
    for (let level = 0; level < levels; level += 1) {
      // A level may be read while another is drawn only when the drawn one is out of the sampler's reach.
      if (level > 0) this.live.setLevels(mips.texture, level - 1);
      const source = level === 0 ? this.textures.get('linear_depth').texture : mips.texture;
      const target = { texture: mips.texture, level, width: Math.max(width >> level, 1), height: Math.max(height >> level, 1) };
      this.live.draw(program, target, { u_source: source }, (set) => {
        this.setViewUniforms(set);
        set('u_source_level', '1i', level - 1);
        set('u_radius', '1f', radius);
      });
    }
    this.live.setLevels(mips.texture, levels - 1);
    return mips.texture;
  }

  input(name, descriptor, parameters, previous) {
    if (name === 'visibility' || name === 'coarser') return previous.texture;
    if (name === 'noise_4x4') return this.noise;
    if (name === 'depth_layers') return this.layers.texture(descriptor.depth_layers, parameters);
    if (name === 'side_layers') return this.layers.noSideLayers(descriptor.side_layers, parameters);
    if (name === 'normal_from_depth') return this.normalFromDepth(false);
    if (name === 'normal_from_depth_accurate') return this.normalFromDepth(true);
    if (name === 'depth_mips') {
      const { filter, radius } = descriptor.depth_mips;
      return this.depthMips(filter, radius ? parameters[radius] : 0);
    }
    return this.textures.get(name).texture;
  }

  setParameters(program, set, descriptor, parameters) {
    for (const { id, type, choices } of descriptor.parameters) {
      const value = parameters[id];
      if (type === 'real') set(`p_${id}`, '1f', value);
      else set(`p_${id}`, '1i', type === 'choice' ? choices.indexOf(value) : Number(value));
    }
    for (const kernel of descriptor.kernels) {
      this.live.bindKernel(program, kernel.id, kernelPoints(kernel, parameters), kernel.largest);
    }
  }

  macros(border, scale, coarserScale) {
    return { ...this.contract.macros, ORTHOGRAPHIC: Number(this.view.orthographic), BORDER_FAR: Number(border === 'far'),
      SCALE: scale, COARSER_SCALE: coarserScale };
  }

  // Draws a pass in so many strips of an even number of rows, and lets the page work in between. `goOn(done, strips)` is asked
  // after each one but the last; false where it says no.
  async drawStrips(program, target, inputs, setUniforms, strips, goOn) {
    const rows = 2 * Math.ceil(target.height / strips / 2);
    for (let first = 0; first < target.height; first += rows) {
      this.live.drawRows(program, target, inputs, setUniforms, first, Math.min(first + rows, target.height));
      if (first + rows >= target.height) break;
      await this.live.finished();
      if (!goOn(first / rows + 1, Math.ceil(target.height / rows))) return false;
    }
    return true;
  }

  // The passes of a method or filter, drawn at 1/divisor of their sizes; `visibility` is what a filter's first pass reads.
  // A promise of the last target; of null where `how.goOn` stopped it, or another view came.
  async passes(descriptor, parameters, border, visibility, divisor, how) {
    const { view } = this;
    let previous = visibility;
    let before = 1;
    for (const [i, pass] of descriptor.passes.entries()) {
      const scale = pass.scale * divisor;
      const program = this.live.program(this.contract.screen_vertex, descriptor.sources[pass.source],
        this.macros(border, scale, before));
      // Inputs first: making one draws by itself.
      const inputs = {};
      for (const name of pass.inputs) inputs[`u_${name}`] = this.input(name, descriptor, parameters, previous);
      const target = this.target(`${visibility ? 'filter' : 'method'} ${i}`, scale);
      const setUniforms = (set) => {
        this.setViewUniforms(set);
        set('u_seed', '1ui', this.contract.seed);
        this.setParameters(program, set, descriptor, parameters);
      };
      const which = `${visibility ? 'filter' : 'method'}${descriptor.passes.length > 1 ? `, pass ${i + 1} of ${descriptor.passes.length}` : ''}`;
      const goOn = (strip, strips) => how.goOn(`${which}, part ${strip} of ${strips}`);
      const whole = await this.drawStrips(program, target, inputs, setUniforms, how.strips, goOn);
      if (!whole || this.view !== view) return null;
      previous = target;
      before = scale;
    }
    return before === 1 ? previous : this.upsampled(previous, before);
  }

  // Brought up to the picture's size by nearness in depth.
  upsampled(coarser, scale) {
    const program = this.derivedProgram('upsample.frag', this.macros('far', 1, scale));
    const target = this.target('upsampled', 1);
    const inputs = { u_coarser: coarser.texture, u_linear_depth: this.textures.get('linear_depth').texture };
    this.live.draw(program, target, inputs, (set) => this.setViewUniforms(set));
    return target;
  }

  // A promise of a method's visibility, after the filter where there is one; of null where `how.goOn(text)`, which is told how
  // far it is, says no, or inputs are missing. Every pass is drawn in `how.strips` strips.
  async run({ method, parameters, filter, filterParameters, border, resolution }, how = { strips: 1, goOn: () => true }) {
    const { view } = this;
    if (!this.holdsInputsOf(method)) return null;
    const raw = await this.passes(method, parameters, border, null, resolution === 'half' ? 2 : 1, how);
    if (!raw || this.view !== view) return null;
    const drawn = filter ? await this.passes(filter, filterParameters, border, raw, 1, how) : raw;
    if (!drawn || this.view !== view) return null;
    const values = await this.live.read(drawn);
    return values.map((v) => (v > 1 ? 1 : v));
  }
}
