import { existsSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { EXAMPLE_SESSIONS, moduleLibrary } from '@ubii/modules';
import { toJson, type Init, type Session } from '@ubii/proto';

import { completeExample } from '../../../../apps/frontend/src/sessions/examples/complete-example.ts';
import { readSessionFile } from '../../../../apps/frontend/src/sessions/file/read-session-file.ts';
import { exportSession } from '../../../../apps/frontend/src/sessions/file/session-file.ts';
import { sessionSpec } from '../../../../apps/frontend/src/sessions/text/session-spec.ts';
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

/** Folders of the data directory that people may put files into, with an extension each. */
const PLACES = [
  ['sessions', '.session', '/services/session/database/get_list'],
  ['modules', '.pm', '/services/processing_module/database/get_list'],
] as const;

const MODULE = {
  name: 'from-a-file',
  authors: ['somebody'],
  tags: ['seed'],
  processingMode: { frequency: { hertz: 30 } },
  inputs: [{ internalName: 'in', messageFormat: 'double' }],
  outputs: [{ internalName: 'out', messageFormat: 'double' }],
  language: 'JS',
  onProcessingStringified: '(deltaTime, inputs) => ({ outputs: {} })',
};
const SESSION = {
  name: 'from-a-file',
  processingModules: [{ name: 'from-a-file', nodeId: 'master' }],
  ioMappings: [
    {
      processingModuleName: 'from-a-file',
      inputMappings: [{ inputName: 'in', topic: '/in' }],
      outputMappings: [{ outputName: 'out', topic: '/out' }],
    },
  ],
  extension: { startWithMaster: false, lockstepHertz: 10, editorJson: '{"nodes":[]}' },
};

/** Module and session files that appear in the data directory while the master runs. */
export const files: Entrance = {
  name: 'files',
  about: 'module and session files in the data directory of a running master',
  kind: 'running',
  seeds: () =>
    [MODULE, SESSION].map(
      (json) => new Uint8Array(Buffer.from(JSON.stringify(json, undefined, 2))),
    ),
  mutate(random, seed, other) {
    if (random.oneIn(3)) return mutateBytes(random, seed, other);
    const text = JSON.stringify(mutateJson(random, JSON.parse(Buffer.from(seed).toString())));
    return new Uint8Array(Buffer.from(text ?? 'null'));
  },
  async deliver(input, { master }) {
    for (const [folder, extension, service] of PLACES) {
      const file = join(master.dataDir, folder, `fuzz${extension}`);
      writeFileSync(file, input);
      // Storing another document makes the master look at the folder now, not when the system reports the change.
      await master.ask({
        topic: '/services/processing_module/database/save',
        processingModule: { ...MODULE, name: 'neighbour', language: 2 },
      });
      await master.ask({
        topic: '/services/session/database/save',
        session: { name: 'neighbour', processingModules: [{ name: 'neighbour' }] },
      });
      const reply = await master.ask({ topic: service });
      const list = reply.sessionList ?? reply.processingModuleList;
      if (list?.elements.some(({ name }) => name === 'neighbour') !== true) {
        throw new Error(
          `A damaged file in ${folder} hides the good one: ${reply.error?.message ?? 'no error'}`,
        );
      }
      if (existsSync(file)) rmSync(file);
    }
  },
};
