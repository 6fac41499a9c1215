// Writes sessions/*.session from src/examples. Run: pnpm --filter @ubii/modules generate
import { writeFileSync } from 'node:fs';
import { EXAMPLE_SESSIONS } from '../src/index.ts';
import { sessionFile } from './session-file.ts';

for (const [id, session] of Object.entries(EXAMPLE_SESSIONS)) {
  writeFileSync(new URL(`../sessions/${id}.session`, import.meta.url), sessionFile(session));
}
