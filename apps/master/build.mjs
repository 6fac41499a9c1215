import { rmSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { join } from 'node:path';
import { buildNodeWorker } from '@ubii/pm-sandbox/build';
import { build } from 'esbuild';

const inPackage = (path) => fileURLToPath(new URL(path, import.meta.url));

// One level below the package, whatever its name: the program finds its files by relative paths.
const outdir = inPackage(process.argv[2] ?? 'dist');
rmSync(outdir, { recursive: true, force: true });
await build({
  entryPoints: { main: inPackage('src/main.ts'), models: inPackage('src/models-main.ts') },
  outdir,
  bundle: true,
  platform: 'node',
  format: 'esm',
  target: 'node20',
  // Rarely needed dependencies (QR codes, Prometheus) are loaded on demand.
  splitting: true,
  chunkNames: 'chunks/[name]-[hash]',
  sourcemap: true,
  // The sources lie beside the build; without them the map takes 10 MB less of the process.
  sourcesContent: false,
  // Names stay as they are: they appear in logs. `keepNames` would cost each closure of the hot path.
  minifySyntax: true,
  minifyWhitespace: true,
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
// On their own: each is a thread or a process, and shares nothing with the program.
await build({
  entryPoints: {
    'decode-worker': inPackage('src/adapters/services/bodies/decode-worker.ts'),
    'check-process': fileURLToPath(import.meta.resolve('@ubii/recording/check-process')),
    'recorder-worker': fileURLToPath(import.meta.resolve('@ubii/recording/recorder-worker')),
    'replay-worker': inPackage('src/adapters/recording/replay-worker.ts'),
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
await buildNodeWorker(join(outdir, 'pm-worker.js'));
