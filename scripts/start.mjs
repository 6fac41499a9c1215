import { requireNode } from './lib/node-version.mjs';

requireNode();
const { masterProgram } = await import('./lib/builds.mjs');
const { runProgram } = await import('./lib/run-program.mjs');

// Modules get their models and libraries from the master, programs the client library.
await runProgram(masterProgram, ['master', 'client', 'frontend', 'vision', 'party']);
