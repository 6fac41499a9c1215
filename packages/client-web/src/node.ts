// The client for Node 20 and later.

export { createClient } from './create-node-client.ts';
export * from './exports.ts';
export { createIdentityFile, defaultIdentityFile } from './program/identity-file.ts';
export { PROGRAM_EXIT_CODES } from './program/program-ending.ts';
export { startProgram } from './program/start-program.ts';
export type { ProgramOptions } from './program/start-program.ts';
