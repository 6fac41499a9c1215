import { canRun } from '../../../sessions/words/node-words.ts';
import type { GraphNode } from '../../model/graph.ts';
import { draggedHost } from './drag-item.ts';

/** True while the node being dragged cannot run this module. */
export function isHostMisfit(node: GraphNode): boolean {
  const host = draggedHost.value;
  if (host === undefined) return false;
  return node.kind !== 'module' || !canRun(host, node.module);
}
