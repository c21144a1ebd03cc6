// SPDX-License-Identifier: MIT
// What the program exports is valid to Khronos' glTF validator:  node validator_test.mjs LUEUR
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {exitCode, runTest, skip} from '../support/node_test.mjs';
import {sampleModel} from './sample_model.mjs';

const {default: validator} = await import('gltf-validator').catch(() =>
  skip('gltf-validator is missing: run `./run test`, or `npm ci` in tests/validator'),
);

const folder = mkdtempSync(join(tmpdir(), 'lueur-validator-'));

function lueur(...options) {
  const run = spawnSync(process.argv[2], options, {encoding: 'utf8', timeout: 120000});
  assert.equal(run.status, 0, `lueur ${options.join(' ')}: ${run.error ?? run.stderr}`);
  return run.stdout;
}

// Exports a scene; returns the file's bytes.
function exported(scene) {
  const file = join(folder, 'scene.glb');
  lueur('scene', 'export', scene, '-o', file);
  return readFileSync(file);
}

const validate = (bytes) => validator.validateBytes(new Uint8Array(bytes), {maxIssues: 20});

// Errors and warnings, a line each; `validate` lists the worst first. What is merely a remark, such
// as an object that nothing uses, is let be.
const faults = ({issues}) =>
  issues.messages
    .filter(({severity}) => severity <= 1)
    .map(({code, pointer, message}) => `${code} at ${pointer}: ${message}`);

const builtin = JSON.parse(lueur('scene', 'list', '--json')).scenes;
assert.ok(builtin.length > 0);
for (const {name} of builtin)
  await runTest(name, async () => assert.deepEqual(faults(await validate(exported(name))), []));

await runTest('a model with one of everything', async () => {
  const model = sampleModel();
  const source = JSON.stringify(model);
  assert.deepEqual(faults(await validate(Buffer.from(source))), [], 'the model itself');
  const file = join(folder, 'model.gltf');
  writeFileSync(file, source);
  const report = await validate(exported(file));
  assert.deepEqual(faults(report), []);

  // That it is valid says something only if all of it is there.
  assert.deepEqual([...report.info.extensionsUsed].sort(), model.extensionsUsed);
  const {hasSkins, hasMorphTargets, hasTextures, maxUVs} = report.info;
  assert.deepEqual(
    {hasSkins, hasMorphTargets, hasTextures},
    {hasSkins: true, hasMorphTargets: true, hasTextures: true},
  );
  assert.equal(maxUVs, 2);
});

await runTest('a broken file is found', async () => {
  const bytes = exported(builtin[0].name);
  const {issues} = await validate(bytes.subarray(0, bytes.length - 4));
  assert.ok(issues.numErrors > 0);
});

rmSync(folder, {recursive: true});
process.exit(exitCode());
