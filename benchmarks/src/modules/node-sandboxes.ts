import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import { buildNodeWorker } from '@ubii/pm-sandbox/build';
import { createNodeSandboxes } from '@ubii/pm-sandbox/node';

/** The sandboxes of Node, in this process, with a worker built for them. */
export interface BuiltSandboxes {
  readonly sandboxes: SandboxFactory;
  stop(): Promise<void>;
}

export async function startNodeSandboxes(): Promise<BuiltSandboxes> {
  const folder = await mkdtemp(join(tmpdir(), 'ubii-bench-worker-'));
  const workerFile = join(folder, 'worker.mjs');
  await buildNodeWorker(workerFile);
  const sandboxes = createNodeSandboxes({ workerFile });
  return {
    sandboxes,
    stop: async () => {
      await sandboxes.close();
      await rm(folder, { recursive: true, force: true });
    },
  };
}
