// Draws the ambient occlusion of a pass of three.js in headless Chromium, as a request asks for it:
//   node run.mjs REQUEST.json PASS PACKAGE@VERSION...
// It serves page.mjs, the scene and the packages to the page, and writes what the page returns as PFM.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { delimiter, dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const [requestFile, pass, ...packages] = process.argv.slice(2);
const request = JSON.parse(readFileSync(requestFile, 'utf8'));
// Where npm packages may lie: with the program in its source tree, and in the user's folder where it is installed.
const userFolder = join(process.env.XDG_DATA_HOME || join(homedir(), '.local', 'share'), 'aoscore');
const folders = [request.data, userFolder].map((folder) => join(folder, 'node_modules'));

// Ends with a sentence, which becomes the reason of the failed row.
function refuse(reason) {
  console.error(reason);
  process.exit(1);
}

function chromiumPath() {
  if (process.env.AOSCORE_CHROMIUM) return process.env.AOSCORE_CHROMIUM;
  const places = process.env.PATH.split(delimiter);
  const found = places.flatMap((folder) => ['chromium', 'google-chrome'].map((name) => join(folder, name)))
    .find((path) => existsSync(path));
  return found ?? refuse('Chromium is not installed: install it, or let AOSCORE_CHROMIUM name the program');
}

// The images are made by one version of a package; another would need another descriptor.
function folderOf(wanted) {
  const [name, version] = wanted.split('@');
  const found = folders.map((folder) => join(folder, name)).filter((folder) => existsSync(join(folder, 'package.json')));
  const versions = found.map((folder) => JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')).version);
  if (versions.includes(version)) return found[versions.indexOf(version)];
  const other = versions.length ? ` in version ${version}, only in ${versions.join(', ')}` : '';
  return refuse(`the npm package ${name} is not installed${other}; `
    + `install what this needs by: npm install --prefix ${userFolder} ${packages.join(' ')}`);
}
const packageFolders = Object.fromEntries(packages.map((wanted) => [wanted.split('@')[0], folderOf(wanted)]));

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
  const [, modules, name, ...rest] = path.split('/');
  if (modules === 'modules' && name in packageFolders) file = join(packageFolders[name], ...rest);
  if (!existsSync(file)) return { status: 404 };
  return { body: readFileSync(file), contentType: types[file.split('.').pop()] };
}

// Portable float map of one channel: rows from the bottom up, little-endian.
function pfm({ width, height, values }) {
  const pixels = Buffer.from(values, 'base64');
  return Buffer.concat([Buffer.from(`Pf\n${width} ${height}\n-1.0\n`), pixels]);
}

const { chromium } = await import(pathToFileURL(join(packageFolders['playwright-core'], 'index.mjs')));
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
