import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const inPackage = (path) => fileURLToPath(new URL(path, import.meta.url));

/** Everything in one file, with nothing to import at run time. */
const COMMON = {
  bundle: true,
  minify: true,
  legalComments: 'none',
  logLevel: 'warning',
  write: true,
};

/**
 * Builds the worker of `createNodeSandboxes`.
 *
 * @param {string} outfile where to, ending in .js or .mjs; an ES module
 * @returns {Promise<void>}
 */
export async function buildNodeWorker(outfile) {
  await build({
    ...COMMON,
    entryPoints: [inPackage('../src/node/node-worker.ts')],
    outfile,
    platform: 'node',
    format: 'esm',
    target: 'node20',
  });
}
