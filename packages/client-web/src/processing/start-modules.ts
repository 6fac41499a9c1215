import { createNodeSandboxes } from '@ubii/pm-sandbox/node';
import { moduleToWire } from '@ubii/pm-sandbox';
import type { AnyModuleDefinition } from '@ubii/pm-sandbox';
import type { UbiiClient } from '../core/client/ubii-client.ts';
import { createProcessingNode } from './create-processing-node.ts';
import type { ProcessingNode } from './processing-node.ts';

/**
 * Offers processing modules to the sessions of the master: they run in this program, on threads of their own.
 * @param client connected, or to be connected
 * @param modules whose code is this program's, and trusted
 */
export async function startModules(
  client: UbiiClient,
  modules: readonly AnyModuleDefinition[],
): Promise<ProcessingNode> {
  const workerFile = new URL('./module-worker.js', import.meta.url);
  const node = createProcessingNode(client, {
    kind: 'node',
    sandboxes: createNodeSandboxes({ workerFile }),
    modules: modules.map((module) => moduleToWire(module)),
  });
  await node.start();
  return node;
}
