import { expect, it } from 'vitest';
import type { LoadedAssets } from '../assets/asset-store.ts';
import { openSandbox, type SandboxInit } from '../testing/sandbox-fixture.ts';
import type { WorkerKind } from '../worker/protocol.ts';
import type { PoolPlatform } from './worker-link.ts';
import { createPooledSandboxes } from './worker-pool.ts';

const MODEL: LoadedAssets = { name: 'model', key: 'model', library: undefined, files: {} };

/** Opens instances in a pool with one worker of each sort. @returns the kinds of the workers that were started */
function workersFor(...instances: (SandboxInit & { readonly isTrusted: boolean })[]): WorkerKind[] {
  const started: WorkerKind[] = [];
  const platform: PoolPlatform = {
    startWorker({ kind }) {
      started.push(kind);
      return {
        post: () => undefined,
        progress: () => ({ received: 0, running: 0, sequence: 0 }),
        setActive: () => undefined,
        terminate: () => undefined,
      };
    },
    every: () => () => undefined,
    atEndOfTurn: () => undefined,
  };
  const memory = { limitBytes: 1, ownerLimitBytes: 1, parts: 1 };
  const options = { libraries: {}, hostLibraries: {}, maxWorkers: 1, memory };
  const factory = createPooledSandboxes(platform, options);
  for (const init of instances) {
    void openSandbox(factory, init, init.isTrusted).sandbox.create();
  }
  return started;
}

it('[PM-50] keeps modules with asset sets apart from those that are quick', () => {
  const quick = { isTrusted: true };
  const detector = { isTrusted: true, assets: [MODEL] };
  expect(workersFor(quick, detector, quick, detector)).toEqual(['trusted', 'trusted']);
  expect(workersFor(quick, quick)).toEqual(['trusted']);
  expect(workersFor({ isTrusted: false }, quick)).toEqual(['sandboxed', 'trusted']);
});
