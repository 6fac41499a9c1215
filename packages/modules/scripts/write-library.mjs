// Writes src/generated/library.ts. Run: pnpm --filter @ubii/modules generate
// With --check it only says whether that would change anything.
import { readFileSync, writeFileSync } from 'node:fs';
import { librarySource } from './library-source.mjs';

const file = new URL('../src/generated/library.ts', import.meta.url);
const text = await librarySource();
if (!process.argv.includes('--check')) {
  writeFileSync(file, text);
} else if (readFileSync(file, 'utf8') !== text) {
  process.stderr.write(
    'The library is older than its modules: pnpm --filter @ubii/modules generate\n',
  );
  process.exitCode = 1;
}
