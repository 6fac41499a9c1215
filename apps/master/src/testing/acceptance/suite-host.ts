import type { TimedPing } from '@ubii/proto/wire';
import type {
  CallerFacts,
  ClientClaim,
  ClientConnection,
  ClientEnding,
  ConnectionHandle,
  ConnectionHost,
  ConnectionPeer,
} from '../../core/ports/index.ts';
import { Inbox } from './inbox.ts';

/** What a transport told the master about one connection. */
export type Heard =
  | { readonly kind: 'topic data'; readonly bytes: Uint8Array }
  | { readonly kind: 'ping'; readonly timed?: TimedPing }
  | { readonly kind: 'pong' }
  | { readonly kind: 'drain' }
  | { readonly kind: 'protocol error'; readonly reason: string }
  | { readonly kind: 'close'; readonly ending: ClientEnding };

/** An open connection. */
export interface Opened {
  readonly claim: ClientClaim;
  readonly connection: ClientConnection;
  readonly caller: CallerFacts;
  readonly peer: ConnectionPeer | undefined;
  readonly heard: Inbox<Heard>;
}

/** Stands in for the master: keeps what a transport tells. */
export class SuiteHost implements ConnectionHost {
  /** The client whose connections are refused before they open. */
  static readonly REFUSED = 'refused';
  /** The client whose connections are closed as soon as they are open. */
  static readonly UNKNOWN = 'unknown';
  static readonly MAX_MESSAGE_BYTES = 1_000_000;
  readonly #opened = new Inbox<Opened>();
  openedCount = 0;

  nextOpened(): Promise<Opened> {
    return this.#opened.next();
  }

  provesLocalClient(): boolean {
    return false;
  }

  refuseConnection({ clientId }: ClientClaim): string | undefined {
    return clientId === SuiteHost.REFUSED ? 'This client is refused.' : undefined;
  }

  maxMessageBytes(): number {
    return SuiteHost.MAX_MESSAGE_BYTES;
  }

  openConnection(
    claim: ClientClaim,
    connection: ClientConnection,
    caller: CallerFacts,
    peer?: ConnectionPeer,
  ): ConnectionHandle | undefined {
    this.openedCount += 1;
    if (claim.clientId === SuiteHost.UNKNOWN) {
      connection.close('unknown client');
      return undefined;
    }
    const heard = new Inbox<Heard>();
    this.#opened.add({ claim, connection, caller, peer, heard });
    return {
      handleReadStart: () => undefined,
      handleReadEnd: () => undefined,
      handleTopicData: (bytes) => heard.add({ kind: 'topic data', bytes }),
      handlePing: (timed) => heard.add({ kind: 'ping', ...(timed && { timed }) }),
      handlePong: () => heard.add({ kind: 'pong' }),
      // A transport may say it more often than it has to.
      handleDrain() {
        if (heard.waiting.at(-1)?.kind !== 'drain') heard.add({ kind: 'drain' });
      },
      handleProtocolError: (reason) => heard.add({ kind: 'protocol error', reason }),
      handleClose: (ending) => heard.add({ kind: 'close', ending }),
    };
  }
}
