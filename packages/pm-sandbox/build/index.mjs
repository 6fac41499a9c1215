import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const inPackage = (path) => fileURLToPath(new URL(path, import.meta.url));

/**
 * Paths of the workers for browsers, and the content security policies to serve them with.
 *
 * @type {{ readonly [kind in 'trusted' | 'sandboxed']: { readonly path: string; readonly csp: string } }}
 */
export const SANDBOX_WORKER_FILES = JSON.parse(
  readFileSync(inPackage('../src/sandbox-worker-files.json'), 'utf8'),
);

/** Everything in one file, with nothing to import at run time. */
const COMMON = { bundle: true, minify: true, legalComments: 'eof', logLevel: 'warning' };

/** The licence of the engine wants to be told; its package brings no comment that would. */
const QUICKJS_NOTICE = {
  js: '/*! Contains QuickJS, (c) Fabrice Bellard and Charlie Gordon, and quickjs-emscripten, (c) Jake Teton-Landis, both under the MIT licence. */',
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
    banner: QUICKJS_NOTICE,
    platform: 'node',
    format: 'esm',
    target: 'node20',
  });
}

/**
 * Builds the workers of `createBrowserSandboxes` under the paths of `SANDBOX_WORKER_FILES`.
 *
 * @param {string} outdir root of what is served
 * @returns {Promise<void>}
 */
export async function buildBrowserWorkers(outdir) {
  for (const kind of Object.keys(SANDBOX_WORKER_FILES)) {
    const outfile = join(outdir, SANDBOX_WORKER_FILES[kind].path);
    await build({ ...browserBuild(kind), outfile });
  }
}

/**
 * Vite plugin: serves the browser workers with their policies in development, adds them to the build.
 * The server of the build must send the policies, too.
 *
 * @returns {{ name: string }} a Vite plugin
 */
export function sandboxWorkersPlugin() {
  return {
    name: 'ubii-sandbox-workers',
    configureServer(server) {
      server.middlewares.use((request, response, next) => {
        const path = new URL(request.url ?? '/', 'http://localhost').pathname;
        const kind = Object.keys(SANDBOX_WORKER_FILES).find(
          (name) => SANDBOX_WORKER_FILES[name].path === path,
        );
        if (kind === undefined) return next();
        workerText(kind).then((text) => {
          response.setHeader('Content-Type', 'text/javascript');
          response.setHeader('Content-Security-Policy', SANDBOX_WORKER_FILES[kind].csp);
          response.setHeader('Cache-Control', 'no-cache');
          response.end(text);
        }, next);
      });
    },
    async generateBundle() {
      for (const [kind, { path }] of Object.entries(SANDBOX_WORKER_FILES)) {
        this.emitFile({ type: 'asset', fileName: path.slice(1), source: await workerText(kind) });
      }
    },
  };
}

async function workerText(kind) {
  const { outputFiles } = await build({ ...browserBuild(kind), write: false });
  return outputFiles[0].text;
}

function browserBuild(kind) {
  return {
    ...COMMON,
    entryPoints: [inPackage(`../src/browser/${kind}-worker.ts`)],
    banner: kind === 'sandboxed' ? QUICKJS_NOTICE : {},
    platform: 'browser',
    format: 'iife',
    target: ['chrome105', 'firefox110', 'safari16'],
    // Under Node the engine asks for this module; and everywhere where its script lies, for files it
    // does not have.
    external: ['module'],
    define: { 'import.meta.url': '"file:///"' },
  };
}

/**
 * Writes an asset set: a folder of its name with its files and `manifest.json`. [PM-92]
 *
 * @param {string} outdir where the folders of all sets are
 * @param {{ name: string }} about members of the manifest
 * @param {Record<string, Uint8Array>} contents by path
 */
export function writeAssetSet(outdir, about, contents) {
  const folder = join(outdir, about.name);
  mkdirSync(folder, { recursive: true });
  const files = Object.entries(contents).map(([path, bytes]) => {
    writeFileSync(join(folder, path), bytes);
    const sha256 = createHash('sha256').update(bytes).digest('hex');
    return { path, bytes: bytes.length, sha256 };
  });
  const manifest = { ...about, files };
  writeFileSync(join(folder, 'manifest.json'), `${JSON.stringify(manifest, undefined, 2)}\n`);
}
