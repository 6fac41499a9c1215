import { ClientRegistry } from '../clients/client-registry.ts';
import { Dismissals } from '../clients/dismissals.ts';
import { Liveness } from '../clients/liveness.ts';
import { DeviceRegistry } from '../devices/device-registry.ts';
import { InfoTopics } from '../info/info-topics.ts';
import type { Foundation } from './foundation.ts';
import type { MasterPorts } from './settings.ts';
import type { TopicArea } from './topics.ts';

/** Clients and their devices. */
export type ClientArea = ReturnType<typeof createClients>;

export type ClientAreaContext = Pick<
  MasterPorts,
  'clock' | 'ids' | 'tokens' | 'patterns' | 'cluster'
> &
  Pick<Foundation, 'id' | 'limits' | 'limitWatch' | 'events' | 'onClose'> &
  Pick<TopicArea, 'accounts' | 'topics' | 'kept' | 'patternTable' | 'subscriptions'> &
  Pick<TopicArea, 'createSubscriber' | 'publisher'>;

export function createClients(context: ClientAreaContext) {
  const { clock, limits, limitWatch, accounts, kept, patternTable } = context;
  const masterId = context.cluster && context.id;
  const info = new InfoTopics(context.publisher, clock, limits, masterId);
  const shared = { ...context, limits: limitWatch, info };
  const devices = new DeviceRegistry(shared);
  const dismissals = new Dismissals();
  const clients = new ClientRegistry({ ...shared, devices, dismissals });
  const liveness = new Liveness(clock, clients, limits, kept);

  accounts.onShortage.add((shortage, hasRoom) => clients.makeRoom(shortage, hasRoom));
  patternTable.onOverdrawn.add(({ clientId }) => {
    const text = `Matching the regular expressions of this client took more than ${limits.patternMatchMs} ms (limit patternMatchMs), so they were ended. Subscribe with simpler expressions.`;
    clients.get(clientId)?.socket?.sendError('resource_exhausted', text);
  });
  context.onClose.add(() => {
    liveness.close();
    info.close();
    for (const { socket } of clients.values()) socket?.close('master is closing');
  });
  return { info, devices, dismissals, clients };
}
