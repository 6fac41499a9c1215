import { ClientState } from '@ubii/proto';
import { computed } from 'vue';
import { isClientId, unnamedClient } from '../../connection/display-names.ts';
import { useConnection } from '../../connection/useConnection.ts';
import type { FindPublisher } from './publisher.ts';

/** Returns clients by id; also disconnected ones, while their topics are shown. */
export function useFindPublisher(): FindPublisher {
  const { clients, masterId } = useConnection();
  const present = computed(() => new Set(clients.list.value?.map(({ id }) => id)));
  return (clientId) => {
    // Always read it, so that the caller is updated when an unknown client appears.
    const isPresent = present.value.has(clientId);
    const client = clients.find(clientId);
    if (client === undefined && clientId !== '' && clientId === masterId.value) {
      return { name: 'Master', isAway: false };
    }
    if (client === undefined) {
      // The client left before this page was opened; its name is unknown.
      if (clients.list.value === undefined || !isClientId(clientId)) return undefined;
      return { name: unnamedClient(clientId), isAway: true };
    }
    const isAway = client.state !== ClientState.ACTIVE || !isPresent;
    return { name: client.name, isAway };
  };
}
