import type { UbiiClient } from '@ubii/client-web/node';
import { ClientState } from '@ubii/proto';
import type { OtherBridges } from '../../core/loop/other-bridges.ts';

const MAX_TEXT = 64;

/** Topic on which a bridge says which mappings it has, as a text that is the same where they are. [BR-24] */
function mappingsTopic(clientId: string): string {
  return `/${clientId}/bridge/mappings`;
}

/** Says which mappings the bridge has. */
export function announceMappings(client: UbiiClient, mappings: string): void {
  client.publish(mappingsTopic(client.id), 'string', mappings);
}

/** Follows which clients are bridges, and what they pass. Resolves when the master tells it. [BR-22] */
export async function watchBridges(client: UbiiClient, bridges: OtherBridges): Promise<void> {
  const askRoles = createRoleQuestion(client, bridges);
  const announcements = client.subscribe({ glob: '/ubii/client/*' }, { format: 'client' });
  announcements.onRecord(({ value: { id, tags, state, extension } }) => {
    bridges.handleClient({
      id,
      tags,
      masterId: extension?.masterId || undefined,
      isGone: state === ClientState.UNAVAILABLE,
      isConnected: state === ClientState.ACTIVE,
    });
    if (bridges.has(id)) askRoles();
  });
  const mappings = client.subscribe({ glob: mappingsTopic('*') }, { format: 'string' });
  mappings.onRecord(({ topic, value }) => {
    if (value.length <= MAX_TEXT) bridges.handleMappings(topic.split('/')[1] ?? '', value);
  });
  await Promise.all([announcements.ready, mappings.ready]);
}

/** Asks the master what the bridges may do: announcements do not say it. One question at a time, and the last one after the last call. */
function createRoleQuestion(client: UbiiClient, bridges: OtherBridges): () => void {
  let isAsking = false;
  let isOutdated = false;
  const ask = async (): Promise<void> => {
    isAsking = true;
    do {
      isOutdated = false;
      const { clients } = await client.call('clientReport', { clientIds: [...bridges.ids] });
      bridges.handleRoles(clients);
    } while (isOutdated);
  };
  return () => {
    isOutdated = true;
    if (isAsking) return;
    // Where it may not ask, every bridge passes its mappings.
    ask()
      .catch(() => undefined)
      .finally(() => (isAsking = false));
  };
}
