import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildNodeWorker } from '@ubii/pm-sandbox/build';
import { build } from 'esbuild';

import { ENTRIES } from './manifest.mjs';

const inPackage = (path) => fileURLToPath(new URL(`../${path}`, import.meta.url));

/** Everything is bundled: an import that stays fails the build, unless Node.js has it. */
const COMMON = {
  absWorkingDir: inPackage(''),
  bundle: true,
  metafile: true,
  format: 'esm',
  target: 'es2022',
  legalComments: 'none', // All licences are in one file.
  logLevel: 'warning',
};

/** In pages: no module of Node.js, one file. */
const FOR_PAGES = { ...COMMON, platform: 'browser', entryPoints: [ENTRIES.index] };

/**
 * Bundles the entries of the package. They are not minified, so that errors and debuggers show readable code without
 * source maps.
 *
 * @param {string} outdir
 * @returns {Promise<string[]>} absolute paths of the files that are in the bundles
 */
export async function bundleForPackage(outdir) {
  const { node, processing } = ENTRIES;
  const [forPages, forNode] = await Promise.all([
    build({ ...FOR_PAGES, outfile: join(outdir, 'index.js') }),
    build({
      ...COMMON,
      entryPoints: { node, processing },
      outdir,
      platform: 'node',
      target: 'node20',
      splitting: true,
      chunkNames: 'chunks/[name]-[hash]',
      minifySyntax: true,
      // `ws` looks for native helpers: one has a replacement, it does without the other.
      alias: { bufferutil: fileURLToPath(import.meta.resolve('@ubii/program/websocket-mask')) },
      define: { 'process.env.WS_NO_UTF_8_VALIDATE': '"1"' },
      // Dependencies written as CommonJS ask for Node's modules by `require`.
      banner: {
        js: "import { createRequire } from 'node:module'; const require = createRequire(import.meta.url);",
      },
    }),
    buildNodeWorker(join(outdir, 'module-worker.js')),
  ]);
  return [forPages, forNode].flatMap(({ metafile }) => Object.keys(metafile.inputs).map(inPackage));
}

/**
 * Bundles the entry for pages into one minified file. Its source map is a file beside it, which only developer tools load.
 *
 * @param {string} outfile
 */
export async function bundleForPages(outfile) {
  await build({ ...FOR_PAGES, outfile, minify: true, sourcemap: true, sourceRoot: '/' });
}
