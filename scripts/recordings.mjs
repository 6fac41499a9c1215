import { requireNode } from './lib/node-version.mjs';

requireNode();
const { recordingsProgram } = await import('./lib/builds.mjs');
const { runProgram } = await import('./lib/run-program.mjs');

// The first argument is the program: record, play, info, export or import. Paths are meant from where the person stands, which npm tells.
await runProgram(recordingsProgram, ['node'], process.env.INIT_CWD);
