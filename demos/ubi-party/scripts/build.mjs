import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { writeAssetSet } from '@ubii/pm-sandbox/build';
import { build } from 'esbuild';

const inPackage = (...path) => join(import.meta.dirname, '..', ...path);
const { version } = JSON.parse(readFileSync(inPackage('package.json'), 'utf8'));
const FILE = 'party.js';

// One script, whose value is what the modules of the games call.
const outfile = inPackage('dist', FILE);
await build({
  entryPoints: [inPackage('src', 'modules', 'library.ts')],
  outfile,
  bundle: true,
  minify: true,
  legalComments: 'eof',
  logLevel: 'warning',
  platform: 'neutral',
  format: 'iife',
  globalName: 'ubiiParty',
  target: 'es2022',
  banner: { js: '/*! Contains pure-rand, (c) Nicolas DUBIEN, MIT. */' },
  footer: { js: 'ubiiParty;' },
});
writeAssetSet(
  inPackage('dist', 'assets'),
  {
    name: 'party',
    version,
    licence: 'BSD-3-Clause AND MIT',
    source: 'Ubi-Interact, demos/ubi-party',
    library: FILE,
  },
  { [FILE]: new Uint8Array(readFileSync(outfile)) },
);
