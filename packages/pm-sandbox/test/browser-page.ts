import { createBrowserSandboxes } from '../src/browser/index.ts';
import type { ModuleFault } from '../src/index.ts';
import { encodeRecord } from '@ubii/proto';
import { openSandbox, valuesOf, type SandboxInit } from '../src/testing/sandbox-fixture.ts';

/** Outcome of one module in the page. */
export interface PageOutcome {
  readonly values: Record<string, unknown>;
  readonly faults: readonly ModuleFault[];
  readonly lines: readonly string[];
  /** Rejection of `create` or of the run. */
  readonly fault: ModuleFault | undefined;
}

/** Script of a test's page: runs modules in the sandboxes of browsers when the test says so. */
const sandboxes = createBrowserSandboxes({ maxWorkers: 1 });

async function runModule(init: SandboxInit, isTrusted: boolean, runs = 1): Promise<PageOutcome> {
  const { sandbox, run, lines } = openSandbox(sandboxes, init, isTrusted);
  let values = {};
  let faults: readonly ModuleFault[] = [];
  let fault: ModuleFault | undefined;
  try {
    await sandbox.create();
    for (let i = 0; i < runs; i++) {
      const result = await run({ deltaTimeMs: i });
      values = { ...values, ...valuesOf(result.outputs) };
      faults = [...faults, ...result.faults];
    }
  } catch (thrown) {
    fault = thrown as ModuleFault;
  }
  sandbox.terminate();
  return { values, faults, lines, fault };
}

/** An image goes through a module; says whether the page still has its bytes. */
async function passImage(isTrusted: boolean): Promise<{ sum: unknown; isTransferred: boolean }> {
  const value = {
    width: 64,
    height: 64,
    dataFormat: 2,
    data: new Uint8Array(64 * 64 * 4).fill(1),
  } as const;
  const bytes = encodeRecord({ topic: '/image', format: 'image2D', value });
  const onProcessing =
    '(dt, { image }) => ({ outputs: { out: { string: String(image.image2D.data.reduce((a, b) => a + b, 0)) } } })';
  const { sandbox, run } = openSandbox(sandboxes, { onProcessing }, isTrusted);
  await sandbox.create();
  const result = await run({ inputs: [{ name: 'image', record: { bytes, isOwned: true } }] });
  sandbox.terminate();
  return { sum: valuesOf(result.outputs)['out'], isTransferred: bytes.byteLength === 0 };
}

/** Microseconds of a run with one small input and output, in the middle. */
async function measure(isTrusted: boolean, runs: number): Promise<number> {
  const onProcessing =
    '(dt, { p }) => ({ outputs: { out: { vector2: { x: 1 - p.vector2.x, y: p.vector2.y } } } })';
  const { sandbox, run } = openSandbox(
    sandboxes,
    { onProcessing, outputs: { out: 'vector2' } },
    isTrusted,
  );
  await sandbox.create();
  const bytes = encodeRecord({ topic: '/p', format: 'vector2', value: { x: 0.25, y: 0.5 } });
  const call = { inputs: [{ name: 'p', record: { bytes } }] };
  for (let i = 0; i < 500; i++) await run(call);
  const start = performance.now();
  for (let i = 0; i < runs; i++) await run(call);
  const spent = performance.now() - start;
  sandbox.terminate();
  return (spent / runs) * 1000;
}

const page = {
  runModule,
  passImage,
  measure,
  check: (onProcessing: string) => sandboxes.check({ onProcessing }),
};

/** Object at `window.sandboxPage` for tests. */
export type SandboxPage = typeof page;

Object.assign(globalThis, { sandboxPage: page });
