import { existsSync } from 'node:fs';

import { runNode } from './commands.mjs';
import { fingerprint, readStamp, writeStamp } from './fingerprint.mjs';
import { precompress } from './precompress.mjs';
import { inRoot, programFile } from './repository.mjs';
import { expectSuccess, step } from './steps.mjs';

const everywhere = [
  'pnpm-lock.yaml',
  'tsconfig.base.json',
  'packages/proto',
  'packages/patterns',
  'packages/pictures',
  'packages/words',
  'packages/worker-rpc',
  'packages/timing',
  'packages/recording',
  'packages/pm-sandbox',
  'packages/modules',
  'demos/ubi-party',
  'scripts/lib/builds.mjs',
];

/** The builds with their outputs and inputs. */
const builds = {
  master: {
    output: 'apps/master/dist/main.js',
    inputs: [...everywhere, 'packages/discovery', 'packages/program', 'apps/master'],
    build: async () => expectSuccess(await runNode(inRoot('apps/master/build.mjs'), [])),
  },
  client: {
    output: 'packages/client-web/dist/sdk/ubii-client.js',
    inputs: [
      ...everywhere,
      'LICENSE',
      'packages/client-web',
      'docs/guides/a-program.md',
      'packages/program',
      ...['scripts/lib/licences.mjs', 'scripts/lib/precompress.mjs'],
    ],
    build: async () => expectSuccess(await runNode(inRoot('packages/client-web/build.mjs'), [])),
  },
  frontend: {
    output: 'apps/frontend/dist/index.html',
    inputs: [
      ...everywhere,
      'packages/client-web',
      'apps/frontend',
      'scripts/lib/precompress.mjs',
      // The list of licences has what the programs are built from
      ...[
        'scripts/lib/licences.mjs',
        'LICENSE',
        'apps/master/package.json',
        'apps/node/package.json',
        'apps/bridge/package.json',
        'packages/vision/package.json',
      ],
    ],
    build: async () => {
      const vite = programFile('apps/frontend', 'vite');
      expectSuccess(await runNode(vite, ['build'], { cwd: inRoot('apps/frontend') }));
      await precompress(inRoot('apps/frontend/dist'));
    },
  },
  vision: {
    output: 'packages/vision/dist/vision.js',
    inputs: [
      'pnpm-lock.yaml',
      'tsconfig.base.json',
      'packages/pictures',
      'packages/vision',
      'scripts/lib/builds.mjs',
    ],
    build: async () =>
      expectSuccess(await runNode(inRoot('packages/vision/scripts/build.mjs'), [])),
  },
  party: {
    output: 'demos/ubi-party/dist/party.js',
    inputs: ['pnpm-lock.yaml', 'demos/ubi-party', 'packages/pm-sandbox', 'scripts/lib/builds.mjs'],
    build: async () =>
      expectSuccess(await runNode(inRoot('demos/ubi-party/scripts/build.mjs'), [])),
  },
  node: {
    output: 'apps/node/dist/main.js',
    inputs: [
      ...everywhere,
      'packages/client-program',
      'packages/client-web',
      'packages/discovery',
      'packages/program',
      'apps/node',
    ],
    build: async () => expectSuccess(await runNode(inRoot('apps/node/build.mjs'), [])),
  },
  bridge: {
    output: 'apps/bridge/dist/main.js',
    inputs: [
      ...everywhere,
      ...['packages/client-program', 'packages/client-web', 'packages/discovery'],
      ...['packages/program', 'apps/bridge'],
    ],
    build: async () => expectSuccess(await runNode(inRoot('apps/bridge/build.mjs'), [])),
  },
};

/** Path of the built node, relative to the root. */
export const nodeProgram = builds.node.output;

/** Path of the built bridge, relative to the root. */
export const bridgeProgram = builds.bridge.output;

/** Path of the built programs for recordings, relative to the root. */
export const recordingsProgram = 'apps/node/dist/recordings.js';

/** Path of the built program that downloads models, relative to the root. */
export const modelsProgram = 'apps/master/dist/models.js';

/** Path of the built master, relative to the root. */
export const masterProgram = builds.master.output;

/**
 * Builds what is missing or made from other inputs than those that are there now.
 *
 * @param {readonly string[]} [names] default: everything
 */
export async function ensureBuilt(names = Object.keys(builds)) {
  for (const name of names) {
    const { output, inputs, build } = builds[name];
    const stamp = fingerprint(inputs);
    if (existsSync(inRoot(output)) && readStamp(name) === stamp) continue;
    await step(`build the ${name}`, async () => {
      writeStamp(name, undefined);
      await build();
      writeStamp(name, stamp);
    });
  }
}
