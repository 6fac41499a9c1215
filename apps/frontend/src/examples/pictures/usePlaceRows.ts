import { NodeExtensionKind } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import type { ModulePlace } from '../../sessions/own/planned-session.ts';
import { canRun, nodeHint, nodeName } from '../../sessions/words/node-words.ts';

/** A place that can run modules. */
export interface PlaceRow {
  readonly id: ModulePlace;
  readonly name: string;
  readonly hint: string;
}

const NODES_INTERVAL_MS = 2000;

/** Returns this tab, and every node that can run all modules now. */
export function usePlaceRows(
  modules: () => readonly string[],
  chosen: () => ModulePlace,
): ComputedRef<readonly PlaceRow[]> {
  const { client, nodes } = useConnection();
  nodes.watch(NODES_INTERVAL_MS);

  return computed(() => {
    const able = (nodes.list.value ?? []).filter(
      (node) =>
        node.clientId !== client.id &&
        modules().every((name) => canRun(node, { name, onProcessingStringified: '' })),
    );
    const name = (id: string): string => nodeName(id, (other) => nodes.find(other), client.id);
    const rows = [
      { id: 'tab', name: 'This tab', hint: 'in a worker of this page' },
      ...able.map((node) => ({
        id: node.node?.kind === NodeExtensionKind.MASTER ? 'master' : node.clientId,
        name: name(node.clientId),
        hint: nodeHint(node).replace(/^master/, 'a worker of the master'),
      })),
    ];
    if (rows.some(({ id }) => id === chosen())) return rows;
    return [...rows, { id: chosen(), name: name(chosen()), hint: 'not connected' }];
  });
}
