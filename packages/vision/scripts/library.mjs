import { join } from 'node:path';
import { build } from 'esbuild';

/** Notices that the licences of the parts require; their files contain some of them as comments. */
const NOTICE = `/*! Contains TensorFlow.js and its COCO-SSD, (c) Google LLC, Apache-2.0; seedrandom, (c) David Bau, MIT; long.js, (c) Daniel Wirtz, Apache-2.0; jpeg-js, (c) Eugene Ware, BSD-3-Clause, with code (c) notmasteryet, Apache-2.0. */`;

/**
 * TensorFlow.js keeps its engine and its registries on the global object, and takes those that it finds. A worker that
 * needs the library again evaluates it again, after the last instance that used it has ended: then they would be those
 * of the evaluation before, whose backends know other files.
 */
const FRESH = 'delete globalThis._tfengine;delete globalThis._tfGlobals;';

/**
 * Builds the library as one script without imports, which is a `var ubiiVision`, and whose value, when
 * it is evaluated, is the library.
 *
 * @param {string} outfile
 * @returns {Promise<void>}
 */
export async function buildLibrary(outfile) {
  await build({
    entryPoints: [join(import.meta.dirname, '..', 'src', 'index.ts')],
    outfile,
    bundle: true,
    minify: true,
    legalComments: 'eof',
    logLevel: 'warning',
    // Files that only Node would read are left out; `process` would make code look for them.
    platform: 'browser',
    define: { process: 'undefined' },
    format: 'iife',
    globalName: 'ubiiVision',
    target: 'es2022',
    banner: { js: `${NOTICE}\n${FRESH}` },
    footer: { js: 'ubiiVision;' },
  });
}
