import { fileURLToPath } from 'node:url';
import { buildMaster, MasterProcess } from '@ubii/harness';

const folder = fileURLToPath(new URL('../.cache', import.meta.url));

/** Builds the master from its sources, away from where others build it, and starts it. */
export function startOwnMaster(): Promise<MasterProcess> {
  return MasterProcess.start({ program: buildMaster(folder) });
}
