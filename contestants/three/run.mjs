// Draws the ambient occlusion of a pass of three.js in headless Chromium, as a request asks for it:
//   node run.mjs REQUEST.json PASS PACKAGE@VERSION...
// It serves page.mjs, the scene and the packages to the page, and writes what the page returns as PFM.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { delimiter, dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const [requestFile, pass, ...packages] = process.argv.slice(2);
const request = JSON.parse(readFileSync(requestFile, 'utf8'));
const modules = join(request.data, 'node_modules');

// Ends with a sentence, which becomes the reason of the failed row.
function refuse(reason) {
  console.error(reason);
  process.exit(1);
}

function chromiumPath() {
  if (process.env.AOSCORE_CHROMIUM) return process.env.AOSCORE_CHROMIUM;
  const folders = process.env.PATH.split(delimiter);
  const found = folders.flatMap((folder) => ['chromium', 'google-chrome'].map((name) => join(folder, name)))
    .find((path) => existsSync(path));
  return found ?? refuse('Chromium is not installed (AOSCORE_CHROMIUM names another place)');
}

// The images were made by one version of a package; another would need another descriptor.
for (const wanted of packages) {
  const [name, version] = wanted.split('@');
  const file = join(modules, name, 'package.json');
  if (!existsSync(file)) refuse(`the npm package ${wanted} is not installed (npm ci in the source tree)`);
  const found = JSON.parse(readFileSync(file, 'utf8')).version;
  if (found !== version) refuse(`the npm package ${name} is of version ${found}, not ${version}`);
}

const types = { html: 'text/html', js: 'text/javascript', mjs: 'text/javascript', glb: 'model/gltf-binary' };
const here = dirname(fileURLToPath(import.meta.url));
const imports = {
  three: '/modules/three/build/three.module.js',
  'three/': '/modules/three/',
  n8ao: '/modules/n8ao/dist/N8AO.js',
  postprocessing: '/modules/postprocessing/build/index.js',
};
const document = `<!doctype html><script type="importmap">${JSON.stringify({ imports })}</script>`;

function served(path) {
  if (path === '/') return { body: document, contentType: types.html };
  let file = join(here, path);
  if (path === '/scene.glb') file = request.scene;
  if (path.startsWith('/modules/')) file = join(modules, path.slice('/modules/'.length));
  if (!existsSync(file)) return { status: 404 };
  return { body: readFileSync(file), contentType: types[file.split('.').pop()] };
}

// Portable float map of one channel: rows from the bottom up, little-endian.
function pfm({ width, height, values }) {
  const pixels = Buffer.from(values, 'base64');
  return Buffer.concat([Buffer.from(`Pf\n${width} ${height}\n-1.0\n`), pixels]);
}

const playwright = join(modules, 'playwright-core', 'index.mjs');
if (!existsSync(playwright)) refuse('the npm package playwright-core is not installed (npm ci in the source tree)');
const { chromium } = await import(pathToFileURL(playwright));
const browser = await chromium.launch({
  executablePath: chromiumPath(),
  args: ['--no-sandbox', '--disable-background-networking', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
    '--ignore-gpu-blocklist'],
});
try {
  const page = await browser.newPage({ viewport: { width: request.width, height: request.height } });
  page.setDefaultTimeout(0);  // who asked for the image bounds the time
  await page.route('**/*', (route) => route.fulfill(served(new URL(route.request().url()).pathname)));
  await page.goto('http://contestant.invalid/');
  const image = await page.evaluate(
    async ([name, asked]) => (await import('/page.mjs')).draw(name, asked), [pass, request]);
  writeFileSync(request.output, pfm(image));
} catch (error) {
  refuse(String(error.message).split('\n')[0]);
} finally {
  await browser.close();
}
