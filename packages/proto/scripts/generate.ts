/** Writes src/generated/*. Run by `pnpm --filter @ubii/proto generate`. */
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { generatedFiles } from './generator/generated-files.ts';

const packageFolder = dirname(dirname(fileURLToPath(import.meta.url)));

for (const [path, source] of generatedFiles(packageFolder)) {
  const target = join(packageFolder, path);
  mkdirSync(dirname(target), { recursive: true });
  writeFileSync(target, source);
}
