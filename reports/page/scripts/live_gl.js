// WebGL 2 below the live methods: programs, float textures, passes over the whole picture.

// The passes are GLSL 3.30 in the uniform form. GLSL ES 3.00 wants another version line and a precision for every type
// that has none; a kernel becomes a uniform block, because plain uniforms may end at 224 vectors and a block holds 1024.
// The macros of shaders/contract come after that; nothing else is changed.
const kEsPreamble = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
precision highp usampler2DArray;
`;
const glslEs = (source, macros) => {
  const defines = Object.entries(macros).map(([name, value]) => `#define ${name} ${value}\n`).join('');
  const body = source.replace(/^#version 330 core\n/, '')
    .replace(/^uniform vec3 (k_\w+)\[(\d+)\];$/gm, 'layout(std140) uniform block_$1 { vec3 $1[$2]; };');
  return kEsPreamble + defines + body;
};

class LiveGl {
  constructor() {
    this.canvas = document.createElement('canvas');
    this.canvas.width = this.canvas.height = 1;  // every picture is drawn into a texture
    const gl = this.canvas.getContext('webgl2', { antialias: false, depth: false });
    if (!gl) throw new Error('This browser has no WebGL 2.');
    if (!gl.getExtension('EXT_color_buffer_float')) {
      throw new Error('This browser cannot draw into textures of 32-bit floats (EXT_color_buffer_float).');
    }
    this.gl = gl;
    this.programs = new Map();
    this.buffers = new Map();
    this.arrays = new Set();  // textures that are arrays
    this.framebuffer = gl.createFramebuffer();
    gl.bindVertexArray(gl.createVertexArray());
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.pixelStorei(gl.PACK_ALIGNMENT, 1);
  }

  shader(type, text) {
    const { gl } = this;
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    return shader;
  }

  // Kept by its text.
  program(vertex, fragment, macros) {
    const { gl } = this;
    const text = glslEs(fragment, macros);
    const known = this.programs.get(text);
    if (known) return known;
    const name = gl.createProgram();
    const shaders = [this.shader(gl.VERTEX_SHADER, glslEs(vertex, {})), this.shader(gl.FRAGMENT_SHADER, text)];
    for (const shader of shaders) gl.attachShader(name, shader);
    gl.linkProgram(name);
    if (!gl.getProgramParameter(name, gl.LINK_STATUS) && !gl.isContextLost()) {
      const log = shaders.map((shader) => gl.getShaderInfoLog(shader)).join('') + gl.getProgramInfoLog(name);
      throw new Error(`A shader does not compile in this browser: ${log}`);
    }
    const program = { name, uniforms: new Map() };
    const count = gl.getProgramParameter(name, gl.ACTIVE_UNIFORMS);
    for (let i = 0; i < count; i += 1) {
      const { name: uniform } = gl.getActiveUniform(name, i);
      program.uniforms.set(uniform, gl.getUniformLocation(name, uniform));
    }
    this.programs.set(text, program);
    return program;
  }

  texture(format, width, height, { data = null, levels = 1 } = {}) {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, levels, format === 'R' ? gl.R32F : gl.RGBA32F, width, height);
    if (data) {
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format === 'R' ? gl.RED : gl.RGBA, gl.FLOAT, data);
    }
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
      gl.texParameteri(gl.TEXTURE_2D, filter,
        levels > 1 && filter === gl.TEXTURE_MIN_FILTER ? gl.NEAREST_MIPMAP_NEAREST : gl.NEAREST);
    }
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
    return texture;
  }

  // `count` textures of one size, of 'R' or 'RGBA' floats or of integers, 'U'. `data` holds one after the other.
  textureArray(format, width, height, count, data = null) {
    const { gl } = this;
    const [internal, transfer, type] = { R: [gl.R32F, gl.RED, gl.FLOAT], RGBA: [gl.RGBA32F, gl.RGBA, gl.FLOAT],
      U: [gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT] }[format];
    const texture = gl.createTexture();
    this.arrays.add(texture);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, internal, width, height, count);
    if (data) gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, 0, width, height, count, transfer, type, data);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D_ARRAY, filter, gl.NEAREST);
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D_ARRAY, wrap, gl.CLAMP_TO_EDGE);
    return texture;
  }

  deleteTexture(texture) {
    this.gl.deleteTexture(texture);
    this.arrays.delete(texture);
  }

  setLevels(texture, last) {
    this.gl.bindTexture(this.gl.TEXTURE_2D, texture);
    this.gl.texParameteri(this.gl.TEXTURE_2D, this.gl.TEXTURE_MAX_LEVEL, last);
  }

  // x, y, z, x, y, z, … into the uniform block of a kernel, whose points take four floats each.
  bindKernel(program, id, points, largest) {
    const { gl } = this;
    const index = gl.getUniformBlockIndex(program.name, `block_k_${id}`);
    if (index === gl.INVALID_INDEX) return;
    const padded = new Float32Array(4 * largest);
    for (let i = 0; 3 * i < points.length; i += 1) padded.set(points.subarray(3 * i, 3 * i + 3), 4 * i);
    if (!this.buffers.has(id)) this.buffers.set(id, gl.createBuffer());
    gl.bindBuffer(gl.UNIFORM_BUFFER, this.buffers.get(id));
    gl.bufferData(gl.UNIFORM_BUFFER, padded, gl.DYNAMIC_DRAW);
    gl.uniformBlockBinding(program.name, index, index);
    gl.bindBufferBase(gl.UNIFORM_BUFFER, index, this.buffers.get(id));
  }

  // Draws into a level of a target's texture, or, where it is an array, into one of its textures: `layer`.
  attach({ texture, level = 0, layer = 0 }) {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    if (this.arrays.has(texture)) gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, texture, level, layer);
    else gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, level);
  }

  // Fills a target {texture, width, height, level, layer} with 1 and draws over it. `setUniforms` is called with the program in
  // use, `inputs` are textures by sampler name.
  draw(program, target, inputs, setUniforms) {
    this.drawRows(program, target, inputs, setUniforms, 0, target.height);
  }

  // Draws rows from `first` up to `end` alone; the first ones begin with the fill.
  drawRows(program, target, inputs, setUniforms, first, end) {
    const { gl } = this;
    this.attach(target);
    gl.viewport(0, 0, target.width, target.height);
    if (first === 0) gl.clearBufferfv(gl.COLOR, 0, [1, 1, 1, 1]);
    gl.useProgram(program.name);
    let unit = 0;
    for (const [sampler, texture] of Object.entries(inputs)) {
      const location = program.uniforms.get(sampler);
      if (!location) continue;
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(this.arrays.has(texture) ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D, texture);
      gl.uniform1i(location, unit++);
    }
    gl.activeTexture(gl.TEXTURE0);
    setUniforms((name, kind, ...values) => {
      const location = program.uniforms.get(name);
      if (location) gl[`uniform${kind}`](location, ...values);
    });
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, first, target.width, end - first);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.SCISSOR_TEST);
  }

  // Waits until all that was asked for is drawn, without holding up the page.
  async finished() {
    const { gl } = this;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) await new Promise((resolve) => { setTimeout(resolve, 2); });
    gl.deleteSync(fence);
  }

  // A promise of the picture as floats, row 0 at the top.
  async read({ texture, width, height }) {
    const { gl } = this;
    this.attach({ texture });
    const single = gl.getParameter(gl.IMPLEMENTATION_COLOR_READ_FORMAT) === gl.RED;
    const values = new Float32Array(width * height * (single ? 1 : 4));
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.bufferData(gl.PIXEL_PACK_BUFFER, values.byteLength, gl.STREAM_READ);
    gl.readPixels(0, 0, width, height, single ? gl.RED : gl.RGBA, gl.FLOAT, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    await this.finished();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, values);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.deleteBuffer(buffer);
    const error = gl.getError();
    if (error === gl.CONTEXT_LOST_WEBGL) throw new Error('The graphics driver gave up.');
    if (error !== gl.NO_ERROR) throw new Error(`WebGL failed with error 0x${error.toString(16)}.`);
    return single ? values : values.filter((_, i) => i % 4 === 0);
  }
}
