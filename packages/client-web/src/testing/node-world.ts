import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import type { Init, ProcessingModule, Session } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { settle, type FakeClock } from '@ubii/timing/testing';
import { createTestClient } from './create-test-client.ts';
import { FakeMaster } from './fake-master.ts';
import { FakeSessions } from './fake-sessions.ts';
import { createProcessingNode } from '../processing/create-processing-node.ts';
import type { ProcessingNodeOptions } from '../processing/processing-node.ts';

/** A started node of a connected client, with fakes around it: for tests. */
export async function createNodeWorld(
  options: Partial<ProcessingNodeOptions> = {},
  master = new FakeMaster(),
  clientOptions: Parameters<typeof createTestClient>[1] = {},
) {
  const sessions = new FakeSessions(master);
  const test = createTestClient(master, clientOptions);
  const node = createProcessingNode(test.client, {
    kind: 'node',
    sandboxes: createInlineSandboxes(),
    clock: processingClockOf(test.clock),
    ...options,
  });
  await test.client.connect();
  await node.start();
  await rest();
  return { master, sessions, node, ...test };
}

/** Work in a sandbox takes some turns. */
export async function rest(): Promise<void> {
  for (let i = 0; i < 5; i++) await settle();
}

function processingClockOf(clock: FakeClock): Clock {
  return {
    nowMs: () => clock.nowMs(),
    monotonicMs: () => clock.monotonicMs(),
    every: (intervalMs, fn) => clock.every(intervalMs, fn),
    after: (delayMs, fn) => clock.after(delayMs, fn),
    atEndOfTurn: (fn) => queueMicrotask(fn),
  };
}

/** A module that publishes ten times what it takes, whenever it comes. */
export function timesTen(nodeId: string, id = 'm1'): Init<ProcessingModule> {
  return {
    id,
    nodeId,
    name: 'times-ten',
    processingMode: { triggerOnInput: {} },
    inputs: [{ internalName: 'in', messageFormat: 'double' }],
    outputs: [{ internalName: 'out', messageFormat: 'double' }],
    onProcessingStringified:
      '(dt, { in: x }, state) => { state.runs = (state.runs ?? 0) + 1; if (x) return { outputs: { out: { double: x.double * 10 } } } }',
  };
}

/** A session that maps `in` and `out` of each module to topics under its id. */
export function sessionOf(...modules: Init<ProcessingModule>[]): Init<Session> {
  return {
    id: 's1',
    name: 'lesson',
    processingModules: modules,
    ioMappings: modules.map(({ id, name }) => ({
      processingModuleId: id,
      processingModuleName: name,
      inputMappings: [{ inputName: 'in', topic: `/${id}/in` }],
      outputMappings: [{ outputName: 'out', topic: `/${id}/out` }],
    })),
  };
}
