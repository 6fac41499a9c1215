import type { Client as ClientMessage, ServiceRequest } from '@ubii/proto';
import type { Core } from '../parts/core.ts';
import { selectByProfiles } from '../topics/profiles.ts';
import type { ServiceHandler } from './handler.ts';
import { requireProfiles } from './list-limits.ts';

/** `/services/client/deregistration` [CL-16] */
export const deregisterClient: ServiceHandler = ({ clients }, request) => {
  const client = clients.require(request.client!.id, 'client.id');
  clients.handleEvent(client, 'deregistered');
  return { success: { title: 'Success', message: 'The client is deregistered.' } };
};

/** `/services/client/get_list` [CL-20] */
export const listClients: ServiceHandler = (core, request) => {
  const profiles = requireProfiles(core, request.clientList?.elements ?? []);
  return { clientList: { elements: selectByProfiles(messages(core), profiles) } };
};

/** `/services/latency_clients_list` */
export const listLatencies: ServiceHandler = (core) => ({
  clientList: {
    elements: [...core.clients.values()].map(({ id, latencyMs }) => ({ id, latency: latencyMs })),
  },
});

/** The id of the client that sends a request, as far as the request says it [CL-11]. */
export function callerId(request: ServiceRequest): string {
  return (
    request.topicSubscription?.clientId ||
    request.device?.clientId ||
    request.client?.id ||
    request.clientRenameRequest?.clientId ||
    request.clientDisconnectRequest?.clientId ||
    request.clientThrottleRequest?.clientId ||
    request.accessGrantCreateRequest?.clientId ||
    request.accessGrantRevokeRequest?.clientId ||
    ''
  );
}

function messages({ clients }: Core): Omit<ClientMessage, 'extension'>[] {
  return [...clients.values()].map((client) => client.toMessage());
}
