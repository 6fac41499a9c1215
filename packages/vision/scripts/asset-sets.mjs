import { copyFileSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, dirname, join } from 'node:path';
import { writeAssetSet } from '@ubii/pm-sandbox/build';
import { opencvFolder, readOpenCv } from './opencv.mjs';

const { resolve } = createRequire(import.meta.url);

/** Folder of the models in `@vladmandic/human`, which exports programs only. */
const humanModels = () => join(dirname(resolve('@vladmandic/human')), '..', 'models');
const humanLicence = () => join(humanModels(), '..', 'LICENSE');
/** Of this package. */
const { version } = JSON.parse(
  readFileSync(join(import.meta.dirname, '..', 'package.json'), 'utf8'),
);
const LIBRARY_FILE = 'vision.js';
const wasmFolder = () => dirname(resolve('@tensorflow/tfjs-backend-wasm'));

/**
 * @typedef {object} AssetSet files that modules are handed, under one name
 * @property {string} name
 * @property {string} version of the package that carries the files
 * @property {string} licence SPDX expression
 * @property {string} source where the files come from
 * @property {() => string} [folder] where they are installed
 * @property {readonly string[]} files
 * @property {string} [library] the file that is a script, whose value is a library
 * @property {() => Record<string, Uint8Array>} [make] makes the files of what is installed
 * @property {() => string} [licenceFile] the licence that has to go with copies
 */

/** @type {readonly AssetSet[]} */
export const ASSET_SETS = [
  {
    name: 'tfjs-wasm',
    version: '4.22.0',
    licence: 'Apache-2.0',
    source: 'https://github.com/tensorflow/tfjs, npm @tensorflow/tfjs-backend-wasm',
    folder: wasmFolder,
    files: ['tfjs-backend-wasm-simd.wasm'],
  },
  {
    name: 'centernet-coco',
    version: '3.3.6',
    licence: 'MIT',
    source:
      'https://github.com/610265158/mobilenetv3_centernet, converted by Vladimir Mandic, npm @vladmandic/human',
    folder: humanModels,
    licenceFile: humanLicence,
    files: ['centernet.json', 'centernet.bin'],
  },
  {
    name: 'movenet-lightning',
    version: '3.3.6',
    licence: 'Apache-2.0',
    source:
      'https://tfhub.dev/google/movenet/singlepose/lightning/4, converted by Vladimir Mandic, npm @vladmandic/human',
    folder: humanModels,
    licenceFile: humanLicence,
    files: ['movenet-lightning.json', 'movenet-lightning.bin'],
  },
  {
    name: 'hand-pose',
    version: '3.3.6',
    licence: 'MIT AND ISC AND Apache-2.0',
    source:
      'https://github.com/victordibia/handtracking and https://github.com/google/mediapipe, converted by Vladimir Mandic, npm @vladmandic/human',
    folder: humanModels,
    licenceFile: humanLicence,
    files: ['handtrack.json', 'handtrack.bin', 'handlandmark-lite.json', 'handlandmark-lite.bin'],
  },
  {
    name: 'opencv',
    version: '4.12.0-release.1',
    licence: 'Apache-2.0 AND BSD-3-Clause AND BSD-2-Clause AND MIT AND Zlib',
    source: 'https://github.com/opencv/opencv, npm @techstark/opencv-js',
    licenceFile: () => join(opencvFolder(), 'LICENSE'),
    files: ['opencv.js', 'opencv.wasm'],
    library: 'opencv.js',
    make: readOpenCv,
  },
];

/**
 * Reads the files of an asset set out of the installed packages.
 *
 * @param {string} name of the set
 * @returns {Record<string, Uint8Array>} bytes by filename
 */
export function readAssetSet(name) {
  const set = ASSET_SETS.find((one) => one.name === name);
  if (set === undefined) throw new Error(`There is no asset set "${name}".`);
  if (set.make !== undefined) return set.make();
  return Object.fromEntries(
    set.files.map((file) => [
      basename(file),
      new Uint8Array(readFileSync(join(set.folder(), file))),
    ]),
  );
}

/**
 * Writes all asset sets, each as a folder with its files, `manifest.json` and, where it has to be, `LICENSE`.
 *
 * @param {string} outdir
 * @param {string} [library] the built library, which is the set `vision`
 */
export function writeAssetSets(outdir, library) {
  if (library !== undefined) {
    const about = { name: 'vision', version, licence: 'BSD-3-Clause AND Apache-2.0 AND MIT' };
    const source = 'Ubi-Interact, packages/vision';
    const bytes = new Uint8Array(readFileSync(library));
    writeAssetSet(outdir, { ...about, source, library: LIBRARY_FILE }, { [LIBRARY_FILE]: bytes });
  }
  for (const { name, version, licence, source, library, licenceFile } of ASSET_SETS) {
    writeAssetSet(outdir, { name, version, licence, source, library }, readAssetSet(name));
    if (licenceFile !== undefined) copyFileSync(licenceFile(), join(outdir, name, 'LICENSE'));
  }
}
