import { requireNode } from './lib/node-version.mjs';

requireNode();
const { modelsProgram } = await import('./lib/builds.mjs');
const { runProgram } = await import('./lib/run-program.mjs');

await runProgram(modelsProgram, ['master', 'vision']);
