import { MasterProcess, type MasterStart } from '@ubii/harness';
import { RunningProgram } from '@ubii/program/testing';
import { onTestFinished } from 'vitest';
import { masterProgram, nodeProgram } from './build-programs.ts';

export { recordingsProgram } from './build-programs.ts';

/** Starts a master, which ends with the test. */
export async function startMaster(start: MasterStart = {}): Promise<MasterProcess> {
  const master = await MasterProcess.start({ program: masterProgram, ...start });
  onTestFinished(() => master.dispose());
  return master;
}

/** Starts a node. */
export function startNode(
  flags: readonly string[],
  options?: { withChannel?: boolean; env?: Record<string, string> },
): RunningProgram {
  return new RunningProgram(nodeProgram, flags, options);
}
