import { fileURLToPath } from 'node:url';
import type { MasterProcess } from '@ubii/harness';
import { startBrokerProcess } from '../brokers/broker-process.ts';

/** A node in a process of its own, see lockstep-node-main.ts. */
export interface LockstepNode {
  readonly name: string;
  /** Id of its client. */
  readonly id: string;
  readonly pid: number;
  stop(): Promise<void>;
}

export async function startLockstepNode(
  name: string,
  master: MasterProcess,
  workerFile: string,
  profileDir: string | undefined,
): Promise<LockstepNode> {
  const main = fileURLToPath(new URL('./lockstep-node-main.ts', import.meta.url));
  const process = await startBrokerProcess({
    name,
    args: ['--import', import.meta.resolve('tsx'), main, master.url, name, workerFile],
    profileDir,
  });
  return {
    name,
    id: String(process.endpoints['id']),
    pid: process.pid,
    stop: () => process.stop(),
  };
}
