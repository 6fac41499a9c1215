/** Writes the generated part of docs/security.md. Run by `npm run generate`. */
import { readFileSync, writeFileSync } from 'node:fs';
import { withRights } from './rights-page.ts';

const page = new URL('../../../docs/security.md', import.meta.url);
writeFileSync(page, withRights(readFileSync(page, 'utf8')));
