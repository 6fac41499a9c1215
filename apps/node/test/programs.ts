import { RunningProgram, startMaster as startProgram } from '@ubii/program/testing';
import type { MasterArgs, StartedMaster } from '@ubii/program/testing';
import { masterProgram, nodeProgram } from './build-programs.ts';

export { recordingsProgram } from './build-programs.ts';

/** Starts a master, as `startProgram` does. */
export const startMaster = (...args: MasterArgs): Promise<StartedMaster> =>
  startProgram(masterProgram, ...args);

/** Starts a node. */
export function startNode(
  flags: readonly string[],
  options?: { withChannel?: boolean; env?: Record<string, string> },
): RunningProgram {
  return new RunningProgram(nodeProgram, flags, options);
}
