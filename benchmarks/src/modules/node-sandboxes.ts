import { Worker } from 'node:worker_threads';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import type { SandboxFactory } from '@ubii/pm-sandbox';
import { buildNodeWorker } from '@ubii/pm-sandbox/build';
import { createNodeSandboxes } from '@ubii/pm-sandbox/node';

/** A worker that answers one message at a time, see bare-worker.mjs. */
interface BareWorker {
  call(message: unknown, transfer: readonly ArrayBuffer[]): Promise<unknown>;
  stop(): Promise<void>;
}

export function startBareWorker(): Promise<BareWorker> {
  const worker = new Worker(new URL('./bare-worker.mjs', import.meta.url), { execArgv: [] });
  let settle: { resolve(answer: unknown): void; reject(error: Error): void } | undefined;
  worker.on('message', (answer) => settle?.resolve(answer));
  worker.on('error', (error: Error) => settle?.reject(error));
  const bare: BareWorker = {
    call: (message, transfer) =>
      new Promise((resolve, reject) => {
        settle = { resolve, reject };
        worker.postMessage(message, transfer);
      }),
    stop: async () => void (await worker.terminate()),
  };
  return new Promise((resolve, reject) => {
    worker.once('error', reject);
    worker.once('online', () => {
      worker.off('error', reject);
      resolve(bare);
    });
  });
}

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
