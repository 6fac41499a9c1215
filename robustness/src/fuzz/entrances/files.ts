import { existsSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import type { Entrance } from '../entrance.ts';
import { mutateBytes } from '../mutate-bytes.ts';
import { mutateJson } from '../mutate-json.ts';

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
      // Storing another document makes the master look at the folder now, not when the system tells it.
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
