import type { GraphCommand } from './graph-command.ts';
import type { ModuleNode } from '../graph.ts';

/** Assigns a module to a node. @param nodeId empty: the master chooses */
export function placeCommand(node: ModuleNode, nodeId: string): GraphCommand {
  const { extension } = node.module;
  return {
    kind: 'setModule',
    node: node.id,
    changes: { nodeId, extension: extension && { ...extension, replaceable: false } },
  };
}
