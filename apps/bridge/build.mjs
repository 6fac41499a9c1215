import { rmSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const inPackage = (path) => fileURLToPath(new URL(path, import.meta.url));

// One level below the package, whatever its name: the program finds its version by a relative path.
const outdir = inPackage(process.argv[2] ?? 'dist');
rmSync(outdir, { recursive: true, force: true });
await build({
  entryPoints: { main: inPackage('src/main.ts') },
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
  legalComments: 'linked',
  // Native helpers that `ws` looks for and does without.
  external: ['bufferutil', 'utf-8-validate'],
  // Dependencies written as CommonJS ask for Node's modules by `require`.
  banner: {
    js: "import { createRequire } from 'node:module'; const require = createRequire(import.meta.url);",
  },
  logLevel: 'warning',
});
