import { MasterProcess } from '@ubii/harness';
import { ownMaster } from './build-package.ts';

/** Starts the master that was built for these tests. */
export function startOwnMaster(): Promise<MasterProcess> {
  return MasterProcess.start({ program: ownMaster });
}
