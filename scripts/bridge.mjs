import { requireNode } from './lib/node-version.mjs';

requireNode();
const { bridgeProgram } = await import('./lib/builds.mjs');
const { runProgram } = await import('./lib/run-program.mjs');

// Files in the flags are meant from where the person stands, which npm tells.
await runProgram(bridgeProgram, ['bridge'], process.env.INIT_CWD);
