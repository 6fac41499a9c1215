import { ClientState, type Client } from '@ubii/proto';
import { computed, shallowRef, watch, type ComputedRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';

/** A client that joined while the list was shown. */
export interface JoinedClient {
  readonly client: Client;
  /** This computer's clock, epoch milliseconds. */
  readonly joinedMs: number;
}

/** Clients that were connected before. */
const BEFORE_MS = 0;

/** Returns the clients that joined since this was called, in any way, the newest first. */
export function useJoined(): ComputedRef<readonly JoinedClient[]> {
  const { client: own, clients } = useConnection();
  const joinedMs = shallowRef<ReadonlyMap<string, number>>();
  const present = computed(() =>
    clients.list.value?.filter(({ state }) => state === ClientState.ACTIVE),
  );
  watch(
    present,
    (list) => {
      if (list === undefined) return;
      const now = joinedMs.value === undefined ? BEFORE_MS : Date.now();
      const fresh = list.filter(({ id }) => joinedMs.value?.has(id) !== true);
      if (joinedMs.value !== undefined && fresh.length === 0) return;
      joinedMs.value = new Map([
        ...(joinedMs.value ?? []),
        ...fresh.map(({ id }) => [id, now] as const),
      ]);
    },
    { immediate: true },
  );
  return computed(() =>
    (present.value ?? [])
      .map((client) => ({ client, joinedMs: joinedMs.value?.get(client.id) ?? BEFORE_MS }))
      .filter(({ client, joinedMs: atMs }) => atMs !== BEFORE_MS && client.id !== own.id)
      .sort((a, b) => b.joinedMs - a.joinedMs),
  );
}
