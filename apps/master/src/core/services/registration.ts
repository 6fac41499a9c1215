import { ServiceError, type Client as ClientMessage, type Init } from '@ubii/proto';
import { isUsedUp, usedRefusal } from '../access/access.ts';
import { accessOf, type Caller } from '../access/caller.ts';
import { requireNodeRights } from '../access/device-rights.ts';
import type { Grant } from '../access/grant.ts';
import { wireRole } from '../access/roles.ts';
import type { Client } from '../clients/client.ts';
import type { Core } from '../areas/core.ts';
import type { TopicEntry } from '../topics/topic-entry.ts';
import { definer } from './define-service.ts';
import { replayAfterReply, type AfterReplyContext } from './replay-after-reply.ts';

/** A credential that a registration gives, and what for [AC-13]. */
interface Given {
  readonly grant: Grant;
  readonly expiresMs: number;
  /** Another client has joined [AC-18]. */
  readonly hasJoined: boolean;
}

type Context = AfterReplyContext &
  Pick<Core, 'id' | 'clients' | 'devices' | 'info' | 'access' | 'tokens' | 'settings' | 'masters'>;

/** Says itself whom it admits, and as whom. [CL-1] [AC-13] [AC-23] */
export const clientRegistration = definer<keyof Context>()('clientRegistration', {
  roles: 'anyone',
  subject: ({ id }) => id,
  mayNameOthers: true,
  isSignOfLife: false,
  async handle(core, payload, call) {
    const { caller } = call;
    const message = asClientOf(caller, payload);
    const { clients, devices, info, access } = core;
    const given = give(core, caller, message);
    const clientAccess = accessOf(caller, given?.expiresMs ?? Number.POSITIVE_INFINITY);
    requireNodeRights(clientAccess.role, message);
    const { client, isResumed, isKnown } = clients.register(message, clientAccess);
    const replays: TopicEntry[] = [];
    try {
      for (const device of message.devices) {
        for (const entry of devices.register(client, device).replays) replays.push(entry); // [CL-5]
      }
      if (given !== undefined) {
        await access.grants.count(given.grant, given.expiresMs, given.hasJoined);
        // An admin revoked the invitation while it was written.
        if (client.status === 'removed') throw removedMeanwhile();
      }
    } catch (error) {
      // Half a registration is none, unless the client was there before.
      if (!isKnown) clients.handleEvent(client, 'deregistered');
      throw error;
    }
    info.announceClient(client); // [CL-31]
    replayAfterReply(core, call, client, replays);
    return replyOf(core, client, isResumed);
  },
});

/** A caller with a credential can only resume the client of the credential [AC-23]. */
function asClientOf(caller: Caller, message: ClientMessage): ClientMessage {
  if (caller.kind !== 'client' || caller.clientId === message.id) return message;
  return { ...message, id: '' };
}

/** The credential this caller is to be given; undefined for those that need none. */
function give(
  { access, clients }: Context,
  caller: Caller,
  message: ClientMessage,
): Given | undefined {
  if (caller.kind === 'stranger') throw caller.refusal;
  if (caller.kind !== 'client' && caller.kind !== 'joining') return undefined;
  const { grant } = caller;
  if (message.extension === undefined) {
    throw new ServiceError(
      'failed_precondition', // [AC-13]
      'A client that joins with a token registers with Client.extension; existing clients are admitted with --allow-legacy.',
    );
  }
  const before = clients.get(clients.provenId(message) ?? '');
  const hasJoined = caller.kind === 'joining' && before?.access.grant !== grant;
  if (hasJoined && isUsedUp(grant)) throw usedRefusal();
  return { grant, expiresMs: access.credentialEndMs(grant), hasJoined };
}

function removedMeanwhile(): ServiceError {
  return new ServiceError(
    'unavailable',
    'The client was removed while it registered. Send the request again.',
  );
}

/** Facts about itself for a client; legacy clients do not receive extension fields [EX-1]. */
function replyOf(
  { id, tokens, settings, access, masters }: Context,
  client: Client,
  isResumed: boolean,
): Init<ClientMessage> {
  const message = client.toMessage();
  if (!client.isExtension) return message;
  const { role } = client.access;
  return {
    ...message,
    extension: {
      recordLists: client.takesRecordLists,
      resumeToken: tokens.issue(client.id), // [EX-3]
      resumed: isResumed,
      masterVersion: settings.version,
      tellsTime: true, // [TS-1]
      masters: masters?.addresses() ?? [], // [CU-26]
      masterId: masters === undefined ? '' : id, // [CU-80]
      role: wireRole(role), // [AC-20]
      mark: client.mark, // [EX-100]
      ...access.credentialOf(client.id, client.access), // [AC-13]
    },
  };
}
