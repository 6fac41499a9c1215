import { oneLine } from '@ubii/words';
import type { Access } from '../access/access.ts';
import type { CallerFacts } from '../ports/caller-facts.ts';
import type { ClientClaim, ConnectionPeer } from '../ports/connection-facts.ts';
import { RESOURCE } from '../shares/resources.ts';
import { limitOf } from '../shares/shortage.ts';
import type { ClientConnection } from '../ports/client-connection.ts';
import type { ClientEnding } from '../ports/close-reason.ts';
import type { ResumeTokens } from '../ports/resume-tokens.ts';
import type { SubscriptionTable } from '../topics/subscription-table.ts';
import type { Client } from './client.ts';
import type { ClientRegistry } from './client-registry.ts';
import type { Dismissal, Dismissals } from './dismissals.ts';
import { TopicDataSocket, type SocketContext } from './topic-data-socket.ts';

/** Dependencies of the admission of sockets. */
export interface AdmissionContext extends Omit<SocketContext, 'onClosed'> {
  readonly clients: ClientRegistry;
  readonly subscriptions: SubscriptionTable;
  readonly access: Access;
  readonly tokens: ResumeTokens;
  readonly dismissals: Dismissals;
}

const NOT_THIS_CLIENT: Dismissal = { reason: 'not this client' };
const OUTDATED: Dismissal = { reason: 'superseded' };
const UNKNOWN_CLIENT: Dismissal = { reason: 'unknown client' };

/** Assigns sockets to clients, and counts them. */
export class SocketAdmission {
  readonly #context: AdmissionContext;
  readonly #socketContext: SocketContext;
  #open = 0;

  constructor(context: AdmissionContext) {
    this.#context = context;
    this.#socketContext = {
      ...context,
      onClosed: (socket, ending) => this.#handleClosed(socket, ending),
    };
  }

  /** Open topic-data sockets. */
  get openCount(): number {
    return this.#open;
  }

  /** Returns the reason to refuse a socket [AC-27]. */
  refuse({ clientId = '', token = '' }: ClientClaim, caller: CallerFacts): string | undefined {
    return this.#context.access.refuseSocket(caller, clientId, token)?.message;
  }

  /** Makes this connection the socket of its client, or closes it and says why. */
  open(
    claim: ClientClaim,
    connection: ClientConnection,
    caller: CallerFacts,
    peer: ConnectionPeer = {},
  ): TopicDataSocket | undefined {
    const { access, clients, counters } = this.#context;
    const client = clients.get(claim.clientId ?? '');
    const isStranger = this.refuse(claim, caller) !== undefined;
    const refusal = isStranger ? NOT_THIS_CLIENT : this.#refusal(client, claim);
    if (client === undefined || refusal !== undefined) {
      const { reason, explanation } = refusal ?? UNKNOWN_CLIENT;
      counters.connectionsRefused++;
      connection.close(reason, explanation);
      return undefined;
    }
    client.socketSentMs = claim.sentMs;
    return this.#attach(client, connection, peer, access.addressGroup(caller));
  }

  /**
   * Makes a connection within the process the socket of its client.
   * @throws ServiceError when there would be too many sockets
   */
  attach(client: Client, connection: ClientConnection): TopicDataSocket {
    this.#context.accounts.require(client.account, RESOURCE.sockets, 1);
    return this.#attach(client, connection, {}, '');
  }

  #attach(
    client: Client,
    connection: ClientConnection,
    { program = '', addressKind }: ConnectionPeer,
    addressGroup: string,
  ): TopicDataSocket {
    const { clients, counters, topics, subscriptions } = this.#context;
    const before = client.socket;
    if (before === undefined) {
      this.#open++;
      client.account.add(RESOURCE.sockets, 1);
    } else before.supersede(); // [TD-7]
    counters.connectionsOpened++;
    const socket = new TopicDataSocket(this.#socketContext, client, connection);
    client.socket = socket;
    client.socketOpenedMs = this.#context.clock.nowMs();
    const { userAgentCharacters } = this.#context.limits;
    // [EX-25] [EX-99]
    client.peer = { program: oneLine(program, userAgentCharacters), addressKind, addressGroup };
    socket.setRecordLists(client.takesRecordLists); // [TD-3] [TD-4]
    const { outbox } = client.subscriber;
    if (client.heardSequence !== undefined) {
      // Records delivered after the client's last message may not have arrived. [TD-33]
      for (const entry of subscriptions.replayable(client.subscriber)) {
        if (entry.record !== undefined && entry.sequence > client.heardSequence)
          outbox.queueReplay(entry);
      }
    }
    client.heardSequence = topics.sequence;
    outbox.open(connection, topics.sequence);
    clients.handleSign(client);
    return socket;
  }

  /** A socket of ours is closed. */
  #handleClosed(socket: TopicDataSocket, ending: ClientEnding): void {
    const { client } = socket;
    this.#open--;
    client.account.add(RESOURCE.sockets, -1);
    client.socket = undefined;
    client.pingSentMs = undefined;
    client.subscriber.sampler.close();
    client.subscriber.outbox.close();
    client.lastSignMs = this.#context.clock.monotonicMs(); // [CL-13]
    // Existing clients know nothing of it. [EX-1]
    const isFarewell = ending === 'left' && client.isExtension;
    this.#context.clients.handleEvent(client, isFarewell ? 'deregistered' : 'socket closed');
  }

  #refusal(client: Client | undefined, claim: ClientClaim): Dismissal | undefined {
    const { tokens, limits, limitWatch, dismissals } = this.#context;
    const { clientId = '', token, sentMs } = claim;
    if (client === undefined || client.home !== undefined) {
      return dismissals.of(clientId) ?? UNKNOWN_CLIENT; // [EX-30] [AC-15] [TD-6] [CU-21]
    }
    if (client.isExtension && !tokens.verify(client.id, token ?? '')) return NOT_THIS_CLIENT; // [EX-4]
    if (client.socket !== undefined) {
      const { socketSentMs } = client;
      const isLate = sentMs !== undefined && socketSentMs !== undefined && sentMs < socketSentMs;
      return isLate ? OUTDATED : undefined; // [EX-51]
    }
    const { account } = client;
    const resource = RESOURCE.sockets;
    const level = account.shortage(resource, 1);
    if (level === undefined) return undefined;
    limitWatch.count(limitOf({ account, resource, level }, limits), client.id);
    return { reason: 'too many' };
  }
}
