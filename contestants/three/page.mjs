// Runs in the page: draws one view of a scene, and a pass over it, and returns the picture's first channel.
import {
  DoubleSide, FloatType, OrthographicCamera, PerspectiveCamera, Scene, ShaderMaterial, Vector2, Vector3,
  WebGLRenderer, WebGLRenderTarget,
} from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

// The passes draw random numbers; these are the same for the same seed (mulberry32: Tommy Ettinger, 2017).
function seedRandom(seed) {
  let state = seed >>> 0;
  Math.random = () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

// `scale` is what one metre becomes: SAOPass knows no unit but its own.
function cameraOf(request, scale) {
  const { camera, width, height } = request;
  const near = camera.near_m * scale, far = camera.far_m * scale;
  const half = (camera.half_height_m ?? 0) * scale, aspect = width / height;
  const made = camera.projection === 'orthographic'
    ? new OrthographicCamera(-half * aspect, half * aspect, half, -half, near, far)
    : new PerspectiveCamera(camera.fovy_deg, aspect, near, far);
  made.up.fromArray(camera.up);
  made.position.fromArray(camera.position_m).multiplyScalar(scale);
  made.lookAt(new Vector3().fromArray(camera.target_m).multiplyScalar(scale));
  made.updateMatrixWorld();
  return made;
}

async function sceneOf(scale) {
  const { scene: content } = await new GLTFLoader().loadAsync('/scene.glb');
  const scene = new Scene();
  content.scale.setScalar(scale);
  // glTF asks for flat normals where a mesh has none; an override material knows nothing of that.
  content.traverse((object) => {
    if (!object.isMesh || object.geometry.attributes.normal) return;
    object.geometry = object.geometry.toNonIndexed();
    object.geometry.computeVertexNormals();
  });
  scene.add(content);
  scene.updateMatrixWorld(true);
  return scene;
}

// View depth -z in metres, infinite where there is no surface.
function depthPicture(stage) {
  const material = new ShaderMaterial({
    side: DoubleSide,
    vertexShader: 'varying float z; void main() { vec4 p = modelViewMatrix * vec4(position, 1.0); z = -p.z; '
      + 'gl_Position = projectionMatrix * p; }',
    fragmentShader: 'varying float z; void main() { gl_FragColor = vec4(z, 0.0, 0.0, 1.0); }',
  });
  stage.renderer.setRenderTarget(stage.write);
  stage.renderer.setClearColor(0x000000, 0);
  stage.renderer.clear();
  stage.scene.overrideMaterial = material;
  stage.renderer.render(stage.scene, stage.camera);
  stage.scene.overrideMaterial = null;
  const pixels = stage.read(stage.write);
  const depth = new Float32Array(pixels.length / 4);
  for (let i = 0; i < depth.length; i++) depth[i] = pixels[4 * i + 3] > 0 ? pixels[4 * i] / stage.scale : Infinity;
  return depth;
}

// The AO radius in pixels at the median depth of all surfaces.
function radiusInPixels(stage, request) {
  const depths = depthPicture(stage).filter(Number.isFinite).sort();
  const median = depths[depths.length >> 1];
  const { camera, height, radius_m } = request;
  const half = camera.projection === 'orthographic'
    ? camera.half_height_m : median * Math.tan((camera.fovy_deg * Math.PI) / 360);
  return (radius_m * height) / (2 * half);
}

// Draws with a pass's own target, or with the one of the two that it writes into.
function drawn(stage, pass, target) {
  pass.renderToScreen = false;
  // The scene's surfaces have two sides; an override material would cull one.
  if (pass.normalMaterial) pass.normalMaterial.side = DoubleSide;
  pass.setSize(stage.width, stage.height);
  pass.render(stage.renderer, stage.write, stage.front);
  return stage.read(target);
}

const passes = {
  async gtao(stage, request) {
    const { GTAOPass } = await import('three/examples/jsm/postprocessing/GTAOPass.js');
    const { parameters, radius_m } = request;
    const pass = new GTAOPass(stage.scene, stage.camera, stage.width, stage.height);
    pass.output = parameters.denoise ? GTAOPass.OUTPUT.Denoise : GTAOPass.OUTPUT.AO;
    pass.updateGtaoMaterial({
      radius: radius_m, samples: parameters.samples, thickness: parameters.thickness_per_radius * radius_m,
      screenSpaceRadius: false,
    });
    return drawn(stage, pass, stage.write);
  },
  async sao(stage, request) {
    const { SAOPass } = await import('three/examples/jsm/postprocessing/SAOPass.js');
    const { parameters } = request;
    const pass = new SAOPass(stage.scene, stage.camera, new Vector2(stage.width, stage.height));
    const kernel = radiusInPixels(stage, request);
    Object.assign(pass.params, {
      output: SAOPass.OUTPUT.SAO, saoBlur: parameters.denoise, saoBias: parameters.bias,
      saoIntensity: parameters.intensity, saoScale: parameters.scale_per_far * stage.camera.far,
      saoKernelRadius: kernel,
    });
    return drawn(stage, pass, stage.front);
  },
  async ssao(stage, request) {
    const { SSAOPass } = await import('three/examples/jsm/postprocessing/SSAOPass.js');
    const { parameters, radius_m } = request;
    const pass = new SSAOPass(stage.scene, stage.camera, stage.width, stage.height, parameters.samples);
    const span = stage.camera.far - stage.camera.near;
    pass.output = parameters.denoise ? SSAOPass.OUTPUT.Blur : SSAOPass.OUTPUT.SSAO;
    pass.kernelRadius = radius_m;
    pass.minDistance = (parameters.least_distance_per_radius * radius_m) / span;
    pass.maxDistance = (parameters.most_distance_per_radius * radius_m) / span;
    return drawn(stage, pass, stage.front);
  },
  async n8ao(stage, request) {
    const { N8AOPass } = await import('n8ao');
    const { parameters, radius_m } = request;
    const pass = new N8AOPass(stage.scene, stage.camera, stage.width, stage.height);
    Object.assign(pass.configuration, {
      aoRadius: radius_m, distanceFalloff: parameters.distance_falloff, aoSamples: parameters.samples,
      intensity: parameters.intensity, gammaCorrection: false, screenSpaceRadius: false,
      denoiseIterations: parameters.denoise ? 2 : 0,
    });
    pass.setDisplayMode('AO');
    return drawn(stage, pass, stage.write);
  },
};

function stageOf(request, scene, camera, scale) {
  const { width, height } = request;
  const renderer = new WebGLRenderer({ antialias: false });
  renderer.setPixelRatio(1);
  renderer.setSize(width, height);
  const target = () => new WebGLRenderTarget(width, height, { type: FloatType });
  return {
    renderer, scene, camera, scale, width, height, write: target(), front: target(),
    read(from) {
      const pixels = new Float32Array(4 * width * height);
      renderer.readRenderTargetPixels(from, 0, 0, width, height, pixels);
      return pixels;
    },
  };
}

function base64(bytes) {
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text);
}

export async function draw(name, request) {
  seedRandom(request.seed);
  const scale = name === 'sao' ? 1 / request.radius_m : 1;
  const stage = stageOf(request, await sceneOf(scale), cameraOf(request, scale), scale);
  let values;
  if (request.parameters.picture === 'depth') {
    values = depthPicture(stage);
  } else {
    const pixels = await passes[name](stage, request);
    values = Float32Array.from({ length: pixels.length / 4 }, (_, i) => pixels[4 * i]);
  }
  const failure = stage.renderer.getContext().getError();
  if (failure !== 0) throw new Error(`WebGL error ${failure}`);
  return { width: request.width, height: request.height, values: base64(new Uint8Array(values.buffer)) };
}
