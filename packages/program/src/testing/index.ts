export { RunningProgram } from './running-program.ts';
export { temporaryFolder } from './temporary-folder.ts';
