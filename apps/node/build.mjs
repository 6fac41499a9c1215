import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildNodeWorker } from '@ubii/pm-sandbox/build';
import { build } from 'esbuild';

const inPackage = (path) => fileURLToPath(new URL(path, import.meta.url));

// One level below the package, whatever its name: the program finds its files by relative paths.
const outdir = inPackage(process.argv[2] ?? 'dist');
rmSync(outdir, { recursive: true, force: true });
await build({
  entryPoints: { main: inPackage('src/main.ts'), recordings: inPackage('src/recordings-main.ts') },
  outdir,
  bundle: true,
  platform: 'node',
  format: 'esm',
  target: 'node20',
  sourcemap: true,
  // The sources lie beside the build; without them the map takes less of the process.
  sourcesContent: false,
  minifySyntax: true,
  minifyWhitespace: true,
  // As in the master's build, so that the text of a module is the same in both. [PM-64]
  keepNames: true,
  legalComments: 'linked',
  // Native helpers that `ws` looks for: one has a replacement, it does without the other.
  alias: { bufferutil: fileURLToPath(import.meta.resolve('@ubii/program/websocket-mask')) },
  external: ['utf-8-validate'],
  // Dependencies written as CommonJS ask for Node's modules by `require`.
  banner: {
    js: "import { createRequire } from 'node:module'; const require = createRequire(import.meta.url);",
  },
  logLevel: 'warning',
});
// On their own: a thread and a process, which share nothing with the program.
await build({
  entryPoints: {
    'check-process': fileURLToPath(import.meta.resolve('@ubii/recording/check-process')),
    'recorder-worker': fileURLToPath(import.meta.resolve('@ubii/recording/recorder-worker')),
  },
  outdir,
  bundle: true,
  platform: 'node',
  format: 'esm',
  target: 'node20',
  minifySyntax: true,
  minifyWhitespace: true,
  logLevel: 'warning',
});
await buildNodeWorker(join(outdir, 'module-worker.js'));
