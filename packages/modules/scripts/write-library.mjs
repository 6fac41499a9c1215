// Writes src/generated/library.ts. Run: pnpm --filter @ubii/modules generate
// With --check it only reports whether the file is up to date.
import { readFileSync, writeFileSync } from 'node:fs';
import { librarySource } from './library-source.mjs';

const file = new URL('../src/generated/library.ts', import.meta.url);
const text = await librarySource();
if (!process.argv.includes('--check')) {
  writeFileSync(file, text);
} else if (readFileSync(file, 'utf8') !== text) {
  process.stderr.write(
    'The generated library is out of date. Run pnpm --filter @ubii/modules generate\n',
  );
  process.exitCode = 1;
}
