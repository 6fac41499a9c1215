import { EXAMPLE_SESSIONS, moduleLibrary } from '@ubii/modules';
import { toJson, type Init, type Session } from '@ubii/proto';

import { completeExample } from '../../../../apps/frontend/src/sessions/examples/complete-example.ts';
import { readSessionFile } from '../../../../apps/frontend/src/sessions/file/read-session-file.ts';
import { sessionSpec } from '../../../../apps/frontend/src/sessions/text/session-spec.ts';
import { exportSession } from '../../../../apps/frontend/src/sessions/file/session-file.ts';
import type { Entrance } from '../entrance.ts';
import { mutateBytes } from '../mutate-bytes.ts';
import { mutateJson } from '../mutate-json.ts';

const GATE_CASES = 60;

const LIBRARY = moduleLibrary();
const EXAMPLES = Object.values<Init<Session>>(EXAMPLE_SESSIONS);

/** Files that a page opens as a session, or shows as an example. */
export const sessionFiles: Entrance = {
  name: 'session-files',
  about: 'session and example files that a page opens, in this process',
  kind: 'parser',
  gateCases: GATE_CASES,
  seeds: () =>
    EXAMPLES.map((spec) => Buffer.from(JSON.stringify(toJson('ubii.sessions.Session', spec)))),
  mutate(random, seed, other) {
    if (random.oneIn(3)) return mutateBytes(random, seed, other);
    const text = JSON.stringify(mutateJson(random, JSON.parse(Buffer.from(seed).toString())));
    return new Uint8Array(Buffer.from(text ?? 'null'));
  },
  async deliver(input) {
    await Promise.resolve();
    const read = readSessionFile({ name: 'fuzz.session', text: Buffer.from(input).toString() });
    if (read.kind === 'broken') {
      if (read.message === '') throw new Error('A refusal has no reason.');
      return;
    }
    completeExample(read.session, LIBRARY);
    const { processingModules, ioMappings } = read.session;
    // A file without either is no session.
    if (processingModules.length + ioMappings.length === 0) return;
    const again = readSessionFile(exportSession(sessionSpec(read.session)));
    if (again.kind === 'broken') throw new Error(`An export cannot be read: ${again.message}`);
  },
};
