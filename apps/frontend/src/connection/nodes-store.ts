import type { UbiiClient } from '@ubii/client-web';
import { fromJson, type NodeInfo } from '@ubii/proto';
import { computed, shallowRef, type Ref, type ShallowRef } from 'vue';
import { createInterest } from './interest.ts';
import { usePoll } from './poll.ts';
import { tryRequest } from './useAttempt.ts';

/** The nodes; requested only while there are viewers. [PM-61] */
export interface NodesStore {
  /** The master first; `undefined` until the first list. */
  readonly list: Readonly<ShallowRef<readonly NodeInfo[] | undefined>>;
  /** By id; includes disconnected nodes and other masters, so that their modules keep a node name. */
  find(id: string): NodeInfo | undefined;
  /** Requests the list at this interval while the calling component or scope is active, milliseconds. */
  watch(intervalMs: number): void;
  /** Requests at once. */
  refresh(): Promise<void>;
}

/** @param nameOfMaster returns the name of another master of the cluster */
export function createNodesStore(
  client: UbiiClient,
  isConnected: Ref<boolean>,
  nameOfMaster: (id: string) => string | undefined = () => undefined,
): NodesStore {
  const list = shallowRef<readonly NodeInfo[]>();
  const known = new Map<string, NodeInfo>();
  const interest = createInterest();

  async function refresh(): Promise<void> {
    // An original master has no such list; a lost connection is shown elsewhere.
    const reply = await tryRequest(() => client.call('nodeList'));
    if (reply === undefined) return;
    for (const node of reply.elements) known.set(node.clientId, node);
    list.value = reply.elements;
  }

  /** Other masters run modules of their sessions, but are not among the nodes of this one. */
  function otherMaster(clientId: string): NodeInfo | undefined {
    const name = nameOfMaster(clientId);
    return name === undefined
      ? undefined
      : fromJson('ubii.extension.NodeInfo', { clientId, name, available: true });
  }

  usePoll(
    refresh,
    () => interest.intervalMs.value ?? 0,
    computed(() => isConnected.value && interest.intervalMs.value !== undefined),
  );

  return {
    list,
    find: (id) =>
      list.value?.find(({ clientId }) => clientId === id) ?? known.get(id) ?? otherMaster(id),
    watch: (intervalMs) => interest.express(intervalMs),
    refresh,
  };
}
