import { ClientState } from '@ubii/proto';
import { computed } from 'vue';
import { isClientId, unnamedClient } from '../../connection/display-names.ts';
import { useMasters } from '../../connection/useMasters.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { isGone } from '../../connection/masters.ts';
import type { FindPublisher } from './publisher.ts';

/** Returns clients by id; also disconnected ones, while their topics are shown. */
export function useFindPublisher(): FindPublisher {
  const { clients, masterId } = useConnection();
  const masters = useMasters();
  const present = computed(() => new Set(clients.list.value?.map(({ id }) => id)));
  return (clientId) => {
    // Always read it, so that the caller is updated when an unknown client appears.
    const isPresent = present.value.has(clientId);
    const client = clients.find(clientId);
    if (client === undefined && clientId !== '') {
      // Masters publish outputs of their modules.
      const named = masters.list.value.find(({ master }) => master.id === clientId);
      if (named !== undefined && masters.areSeveral.value) {
        return { name: named.label, isAway: isGone(named.master) };
      }
      if (clientId === masterId.value) return { name: 'Master', isAway: false };
    }
    if (client === undefined) {
      // The client left before this page was opened; its name is unknown.
      if (clients.list.value === undefined || !isClientId(clientId)) return undefined;
      return { name: unnamedClient(clientId), isAway: true };
    }
    const isAway = client.state !== ClientState.ACTIVE || !isPresent;
    const master = masters.labelOf(client.extension?.masterId);
    return { name: client.name, isAway, isClient: isPresent, master };
  };
}
