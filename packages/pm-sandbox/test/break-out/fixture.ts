import { afterAll } from 'vitest';
import { createNodeSandboxes } from '../../src/node/index.ts';
import type { ModuleFault, SandboxFactory } from '../../src/index.ts';
import {
  openSandbox,
  valuesOf,
  type OpenSandbox,
  type SandboxInit,
} from '../../src/testing/index.ts';
import { WORKER_FILE } from '../build-worker.ts';

/** Sandboxes as a node has them for code it does not know. */
export function untrustedSandboxes(): {
  readonly factory: SandboxFactory;
  create(init: SandboxInit): Promise<OpenSandbox>;
  /** Text of what a body returns, or the fault it ends in. */
  attempt(body: string, init?: SandboxInit): Promise<unknown>;
} {
  const factory = createNodeSandboxes({ workerFile: WORKER_FILE, maxWorkers: 1 });
  afterAll(() => factory.close());
  const create = async (init: SandboxInit): Promise<OpenSandbox> => {
    const opened = openSandbox(factory, init, false);
    await opened.sandbox.create();
    return opened;
  };
  return {
    factory,
    create,
    async attempt(body, init = {}) {
      const onProcessing = `async (dt, inputs, state) => {
        const result = await (async () => { ${body} })();
        return { outputs: { out: { string: String(result) } } };
      }`;
      const { sandbox, run } = await create({ ...init, onProcessing });
      try {
        const { outputs, faults } = await run();
        return faults[0] ?? valuesOf(outputs)['out'];
      } catch (fault) {
        return fault as ModuleFault;
      } finally {
        sandbox.terminate();
      }
    },
  };
}
