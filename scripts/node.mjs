import { requireNode } from './lib/node-version.mjs';

requireNode();
const { nodeProgram } = await import('./lib/builds.mjs');
const { runProgram } = await import('./lib/run-program.mjs');

// Folders in the flags are meant from where the person stands, which npm tells.
await runProgram(nodeProgram, ['node'], process.env.INIT_CWD);
