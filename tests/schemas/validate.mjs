// node validate.mjs SOURCE FOLDER: holds every file of the source tree to its schema, and FOLDER/score/results.json to
// FOLDER/results.schema.json. A member that no schema names must be refused in each.
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';

const [source, folder] = process.argv.slice(2);
const Ajv = createRequire(path.join(source, 'package.json'))('ajv/dist/2020').default;
const read = (file) => JSON.parse(fs.readFileSync(file, 'utf8'));

const ajv = new Ajv({ strict: true, strictRequired: false, allowUnionTypes: true });
const schemas = path.join(source, 'reports/schemas');
for (const file of fs.readdirSync(schemas)) ajv.addSchema(read(path.join(schemas, file)), file);
ajv.addSchema(read(path.join(folder, 'results.schema.json')), 'results.schema.json');

const below = (dir, wanted, recursive = true) => fs.readdirSync(path.join(source, dir), { recursive })
    .filter((file) => wanted.test(file)).map((file) => path.join(source, dir, file));
const files = {
    method: below('shaders', /method\.json$/),
    presets: below('shaders', /tuned\.json$/),
    views: below('scenes', /views\.json$/),
    claims: below('reports/claims', /\.json$/),
    tuning: below('reports/tunings', /\.json$/),
    contestant: below('contestants', /contestant\.json$/),
    experiment: below('reports', /\.json$/, false),
    results: [path.join(folder, 'score/results.json')],
};

let tried = 0, refused = 0;
for (const [kind, paths] of Object.entries(files)) {
    if (paths.length === 0) throw new Error(`no file of the kind ${kind}`);
    const accepts = ajv.getSchema(`${kind}.schema.json`);
    for (const file of paths) {
        ++tried;
        const content = read(file);
        if (!accepts(content)) {
            ++refused;
            console.log(file, JSON.stringify(accepts.errors.slice(0, 3)));
        }
        content.no_such_member = 1;
        if (accepts(content)) {
            ++refused;
            console.log(file, 'is accepted with a member that no schema names');
        }
    }
}
console.log(`${tried} files, ${refused} refused`);
process.exit(refused === 0 ? 0 : 1);
