import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import { buildNodeWorker } from '@ubii/pm-sandbox/build';
import { createNodeSandboxes } from '@ubii/pm-sandbox/node';

/** The worker of the sandboxes, built for this run. */
export interface WorkerFile {
  readonly path: string;
  stop(): Promise<void>;
}

export async function buildWorkerFile(): Promise<WorkerFile> {
  const folder = await mkdtemp(join(tmpdir(), 'ubii-bench-worker-'));
  const path = join(folder, 'worker.mjs');
  await buildNodeWorker(path);
  return { path, stop: () => rm(folder, { recursive: true, force: true }) };
}

/** The sandboxes of Node, in this process. */
export interface BuiltSandboxes {
  readonly sandboxes: SandboxFactory;
  stop(): Promise<void>;
}

export async function startNodeSandboxes(): Promise<BuiltSandboxes> {
  const worker = await buildWorkerFile();
  const sandboxes = createNodeSandboxes({ workerFile: worker.path });
  return {
    sandboxes,
    stop: async () => {
      await sandboxes.close();
      await worker.stop();
    },
  };
}
