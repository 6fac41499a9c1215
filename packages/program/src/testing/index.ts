export { RunningProgram } from './running-program.ts';
export { startMaster, type MasterArgs, type StartedMaster } from './start-master.ts';
export { temporaryFolder } from './temporary-folder.ts';
