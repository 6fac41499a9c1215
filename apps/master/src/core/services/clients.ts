import { selectByProfiles } from '@ubii/proto';
import { JOINED, READERS } from '../access/roles.ts';
import { definer, success } from './define-service.ts';
import { requireProfiles } from './list-limits.ts';
import { clientRegistration } from './registration.ts';

const define = definer<'clients' | 'info' | 'limitWatch'>();

/** Services on clients: registration and lists. */
export const CLIENT_SERVICES = [
  clientRegistration,
  // [CL-16]
  define('clientDeregistration', {
    roles: JOINED,
    subject: ({ id }) => id,
    isSignOfLife: false,
    handle({ clients }, { id }) {
      clients.handleEvent(clients.require(id, 'client.id'), 'deregistered');
      return success('The client is deregistered.');
    },
  }),
  // [CL-20]
  define('clientGetList', {
    roles: READERS,
    handle(core, list) {
      const profiles = requireProfiles(core, list?.elements ?? []);
      const clients = [...core.clients.values()].map((client) => core.info.describe(client));
      return { elements: selectByProfiles(clients, profiles) };
    },
  }),
  define('latencyClientsList', {
    roles: READERS,
    handle: ({ clients }) => ({
      elements: [...clients.values()]
        .filter(({ home }) => home === undefined)
        .map(({ id, latencyMs }) => ({ id, latency: latencyMs })),
    }),
    gather: ({ elements }, others) => ({
      elements: [...(elements ?? []), ...others.flatMap((other) => other.elements)],
    }),
  }),
];
