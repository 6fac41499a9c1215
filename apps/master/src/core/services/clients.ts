import type { Client as ClientMessage, Init, ServiceRequest } from '@ubii/proto';
import type { Client } from '../clients/client.ts';
import type { Core } from '../core.ts';
import { selectByProfiles } from '../devices/profiles.ts';
import type { TopicEntry } from '../topics/topic-entry.ts';
import type { ServiceHandler } from './handler.ts';
import { requireProfiles } from './list-limits.ts';
import { replayAfterReply } from './replay-after-reply.ts';

/** `/services/client/registration` [CL-1] */
export const registerClient: ServiceHandler = (core, request, call) => {
  const message = request.client!;
  const { clients, devices, info } = core;
  const { client, isResumed, isKnown } = clients.register(message);
  const owed: TopicEntry[] = [];
  try {
    for (const device of message.devices) {
      for (const entry of devices.register(client, device).owed) owed.push(entry); // [CL-5]
    }
  } catch (error) {
    // Half a registration is none, unless the client was there before.
    if (!isKnown) clients.handleEvent(client, 'deregistered');
    throw error;
  }
  info.announceClient(client); // [CL-31]
  replayAfterReply(core, call, client, owed);
  return { client: replyOf(core, client, isResumed) };
};

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
    ''
  );
}

function messages({ clients }: Core): Omit<ClientMessage, 'extension'>[] {
  return [...clients.values()].map((client) => client.toMessage());
}

/** What a client is told about itself; those who did not ask for it see nothing of ours [EX-1]. */
function replyOf(
  { tokens, settings }: Core,
  client: Client,
  isResumed: boolean,
): Init<ClientMessage> {
  const message = client.toMessage();
  if (!client.isExtension) return message;
  return {
    ...message,
    extension: {
      recordLists: client.takesRecordLists,
      resumeToken: tokens.issue(client.id), // [EX-3]
      resumed: isResumed,
      masterVersion: settings.version,
      tellsTime: true, // [TS-1]
    },
  };
}
