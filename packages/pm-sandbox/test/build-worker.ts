import { fileURLToPath } from 'node:url';
import { buildNodeWorker } from '../build/index.mjs';

/** The worker all tests of this package run. */
export const WORKER_FILE = fileURLToPath(
  new URL('../node_modules/.cache/pm-sandbox/pm-worker.mjs', import.meta.url),
);

/** Builds it once, before any test. */
export async function setup(): Promise<void> {
  await buildNodeWorker(WORKER_FILE);
}
