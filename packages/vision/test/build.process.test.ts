import { createHash } from 'node:crypto';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Worker } from 'node:worker_threads';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { ASSET_SETS, readAssetSet, writeAssetSets } from '../scripts/asset-sets.mjs';
import { buildLibrary } from '../scripts/library.mjs';
import type { Detection } from '../src/detection/detector.ts';
import { readPhoto } from './photos.ts';

let folder: string;
beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'ubii-vision-'));
});
afterAll(() => rmSync(folder, { recursive: true }));

/** Program of a module worker, without access to files or network. */
const PROGRAM = `
  const { parentPort, workerData } = require('node:worker_threads');
  const { text, wasm, model, picture } = workerData;
  for (const name of ['fetch', 'XMLHttpRequest', 'WebSocket', 'process', 'require']) {
    delete globalThis[name];
  }
  const vision = (0, eval)(text);
  (async () => {
    const tensorflow = await vision.createTensorflow(wasm);
    const detector = await vision.createCenterNet(tensorflow, model);
    const found = await detector.detect(picture, { inputSize: 256 });
    parentPort.postMessage({ backend: tensorflow.backend, found });
  })().catch((error) => parentPort.postMessage({ error: String(error.stack) }));
`;

describe('the built library', () => {
  it('finds a person in a worker that has only evaluated it', async () => {
    const file = join(folder, 'vision.js');
    await buildLibrary(file);
    const workerData = {
      text: readFileSync(file, 'utf8'),
      wasm: readAssetSet('tfjs-wasm'),
      model: readAssetSet('centernet-coco'),
      picture: readPhoto('camera.jpg'),
    };
    const worker = new Worker(PROGRAM, { eval: true, workerData });
    const answer = await new Promise<{ backend?: string; found?: Detection[]; error?: string }>(
      (resolve, reject) => worker.once('message', resolve).once('error', reject),
    );
    await worker.terminate();
    expect(answer).toMatchObject({ backend: 'wasm', found: [{ class: 'person' }] });
  });
});

describe('the built asset sets', () => {
  it('have the files that their manifests name, with size and hash', () => {
    const outdir = join(folder, 'assets');
    writeAssetSets(outdir);
    expect(readdirSync(outdir).sort()).toEqual(ASSET_SETS.map(({ name }) => name).sort());
    for (const { name, licenceFile } of ASSET_SETS) {
      const manifest = JSON.parse(readFileSync(join(outdir, name, 'manifest.json'), 'utf8')) as {
        name: string;
        files: { path: string; bytes: number; sha256: string }[];
      };
      expect(manifest.name).toBe(name);
      const paths = manifest.files.map(({ path }) => path);
      const others = licenceFile === undefined ? ['manifest.json'] : ['LICENSE', 'manifest.json'];
      expect(readdirSync(join(outdir, name)).sort()).toEqual([...paths, ...others].sort());
      for (const { path, bytes, sha256 } of manifest.files) {
        const content = readFileSync(join(outdir, name, path));
        expect(content.length).toBe(bytes);
        expect(createHash('sha256').update(content).digest('hex')).toBe(sha256);
      }
    }
  });

  it('name the versions that are installed', () => {
    const { dependencies, devDependencies } = JSON.parse(
      readFileSync(new URL('../package.json', import.meta.url), 'utf8'),
    ) as Record<string, Record<string, string>>;
    const versions = { ...dependencies, ...devDependencies };
    for (const { source, version } of ASSET_SETS) {
      expect(versions[source.slice(source.indexOf('npm ') + 4)]).toBe(version);
    }
  });
});
