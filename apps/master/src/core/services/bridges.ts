import { ADMINS, READERS } from '../access/roles.ts';
import { nameOfCaller } from './by-caller.ts';
import { definer } from './define-service.ts';

const define = definer<'bridgeMappings' | 'clients'>();

/** Services on the mappings of bridges. What passes between two systems is an admin's to decide. */
export const BRIDGE_SERVICES = [
  // [BR-80]
  define('bridgeMappingsGet', {
    roles: READERS,
    target: ({ targetId }) => ({ clientId: targetId }),
    handle: ({ bridgeMappings }, { targetId }) => bridgeMappings.get(targetId),
  }),
  // [BR-81]
  define('bridgeMappingsCheck', {
    roles: ADMINS,
    subject: ({ clientId }) => clientId,
    target: ({ targetId }) => ({ clientId: targetId }),
    handle: ({ bridgeMappings }, change) => bridgeMappings.check(change),
  }),
  // [BR-82]
  define('bridgeMappingsSet', {
    roles: ADMINS,
    subject: ({ clientId }) => clientId,
    target: ({ targetId }) => ({ clientId: targetId }),
    auditObject: ({ clients }, { targetId }) => clients.get(targetId)?.label ?? targetId,
    handle: (core, change) => core.bridgeMappings.set(change, nameOfCaller(core, change.clientId)),
  }),
];
