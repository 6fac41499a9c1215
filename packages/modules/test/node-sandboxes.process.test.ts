import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import { buildNodeWorker } from '@ubii/pm-sandbox/build';
import { createNodeSandboxes } from '@ubii/pm-sandbox/node';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { httpPoller, loadGenerator } from '../src/index.ts';
import { PLAIN_MODULES } from './plain-modules.ts';
import { driveDirectly, type DrivenModule } from './drive-module.ts';
import { driveIn } from './drive-sandboxed.ts';
import { HostileInputs } from './hostile-inputs.ts';

/** Bundling the worker takes its time on a busy machine. */
const SETUP_TIMEOUT_MS = 30_000;

/** Files that the node provides for its modules. */
const http = {
  get(url: unknown): Promise<{ status: number; text: string }> {
    if (!String(url).startsWith('http://thing.local/')) {
      return Promise.reject(new Error(`Reading from ${String(url)} is not allowed`));
    }
    const status = String(url).endsWith('/missing') ? 404 : 200;
    return Promise.resolve({ status, text: '{"sensors":[{"celsius":21.5}]}' });
  },
};
let folder: string;
let sandboxes: SandboxFactory;

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'ubii-modules-'));
  const workerFile = join(folder, 'worker.mjs');
  await buildNodeWorker(workerFile);
  sandboxes = createNodeSandboxes({
    workerFile,
    hostLibraries: { http },
    maxWorkers: 1,
  });
}, SETUP_TIMEOUT_MS);

afterAll(async () => {
  await sandboxes.close();
  rmSync(folder, { recursive: true });
});

describe.each([
  ['trusted', true],
  ['sandboxed', false],
])('on a %s thread of Node', (_kind, isTrusted) => {
  const drive = driveIn(() => sandboxes, isTrusted);

  // The load generator takes too long in a slower engine, and there is no server for requests.
  const compared = PLAIN_MODULES.filter(
    (module) => module !== loadGenerator && module !== httpPoller,
  );
  it.each(compared.map((module) => [module.name, module] as const))(
    '%s gives what it gives when called directly',
    async (_name, module) => {
      const inputs = new HostileInputs(5);
      const there = await drive(module);
      const here = await driveDirectly(module);
      for (let run = 0; run < 30; run++) {
        const values = inputs.inputs(module.inputs);
        const given = await there.run(20, values);
        expectClose(given, await here.run(20, values));
      }
    },
  );

  it('load-generator works and tells how long', async () => {
    const module = await drive(loadGenerator);
    const outputs = await module.run(0, { iterations: 10_000 });
    expect(outputs.durationMs).toBeGreaterThanOrEqual(0);
    const here = await driveDirectly(loadGenerator);
    expect(outputs.result).toBe((await here.run(0, { iterations: 10_000 })).result);
  });

  it('http-poller reads through a library of the node [PM-4]', async () => {
    const module = await drive(httpPoller);
    await module.run(0, { url: 'http://thing.local/', path: 'sensors[0].celsius' });
    expect(await firstOutputs(module)).toEqual({ number: 21.5, text: '21.5', status: 200 });
    await module.run(1000, { url: 'http://thing.local/missing' });
    expect(await firstOutputs(module)).toEqual({
      status: 404,
      error: 'The service responded with status 404.',
    });
  });

  it('http-poller says what the library of the node refuses', async () => {
    const module = await drive(httpPoller);
    await module.run(0, { url: 'http://other.local/' });
    expect(await firstOutputs(module)).toEqual({
      error: 'The request failed: Reading from http://other.local/ is not allowed',
    });
  });
});

/** Runs until something is put out: each run is a message there and back. */
async function firstOutputs(module: DrivenModule): Promise<{ [name: string]: unknown }> {
  for (;;) {
    const outputs = await module.run(0);
    if (Object.keys(outputs).length > 0) return outputs;
  }
}

/** Expects the same, but for the last digits of numbers: engines do not agree on those. */
function expectClose(actual: unknown, expected: unknown): void {
  if (typeof expected === 'number') {
    const tolerance = 1e-9 * Math.max(1, Math.abs(expected));
    expect(Math.abs((actual as number) - expected)).toBeLessThanOrEqual(tolerance);
  } else if (expected instanceof Uint8Array) {
    // Comparing 100 000 pixels one by one takes seconds.
    expect(Buffer.compare(actual as Uint8Array, expected)).toBe(0);
  } else if (typeof expected === 'object' && expected !== null) {
    expect(Object.keys(actual as object).sort()).toEqual(Object.keys(expected).sort());
    for (const [name, value] of Object.entries(expected)) {
      expectClose((actual as { [name: string]: unknown })[name], value);
    }
  } else expect(actual).toEqual(expected);
}
