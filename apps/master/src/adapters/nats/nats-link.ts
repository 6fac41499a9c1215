import {
  type Authenticator,
  type NodeConnectionOptions,
  connect,
  type NatsConnection,
} from '@nats-io/transport-node';
import type { Cancel, Clock } from '@ubii/timing';
import type { ClusterAddress } from '../config/cluster-address.ts';
import type { Log } from '../../core/ports/index.ts';
import { explainStart } from './explain-nats-error.ts';

/** Where a master finds its cluster, and what it calls itself there. */
interface NatsSettings {
  readonly address: ClusterAddress;
  readonly authenticator: Authenticator | undefined;
  /** Certificates that those of the servers are checked with, PEM. Default: those of the system */
  readonly authorities: string | undefined;
  /** Name that the servers show for this connection. */
  readonly clientName: string;
}

/** A server that does not finish its greeting in this time counts as away, milliseconds. */
const CONNECT_MS = 3_000;
/**
 * A dead line is noticed within `PING_MS * (MAX_PINGS_OUT + 1)`: before other masters take over what a cut-off master
 * owns.
 */
const PING_MS = 1_000;
const MAX_PINGS_OUT = 2;

/** Options of the library: it never gives up, and never shows a message to its own sender. */
function connectOptions(
  { address, authenticator, authorities, clientName }: NatsSettings,
  reconnectDelayMs: () => number,
): NodeConnectionOptions {
  const isEncrypted = address.isEncrypted || authorities !== undefined;
  return {
    servers: address.servers.map((server) => server.replace(/^\w+:\/\//, '')),
    name: clientName,
    noEcho: true,
    maxReconnectAttempts: -1,
    ignoreAuthErrorAbort: true,
    reconnectDelayHandler: reconnectDelayMs,
    timeout: CONNECT_MS,
    pingInterval: PING_MS,
    maxPingOut: MAX_PINGS_OUT,
    noAsyncTraces: true,
    ...(authenticator && { authenticator }),
    ...(isEncrypted && { tls: authorities === undefined ? {} : { ca: authorities } }),
  };
}

/** Delays before a connection is tried again, milliseconds: each twice the one before. */
const FIRST_MS = 50;
const MAX_MS = 2_000;

/** How long to wait before a lost connection is tried again: longer each time, and never all masters at once. */
export class ReconnectPace {
  readonly #random: () => number;
  #attempts = 0;

  /** @param random from 0 to 1. Default: `Math.random` */
  constructor(random: () => number = Math.random) {
    this.#random = random;
  }

  handleAttempt(): void {
    this.#attempts += 1;
  }

  handleSuccess(): void {
    this.#attempts = 0;
  }

  delayMs(): number {
    const longest = Math.min(MAX_MS, FIRST_MS * 2 ** Math.min(this.#attempts, 16));
    return Math.round(longest * (0.5 + this.#random() / 2));
  }
}

/** Time between two attempts at the start, milliseconds. */
const RETRY_MS = 250;
/** Long enough for machines that start NATS and masters together, short enough for a person who waits, milliseconds. */
const START_MS = 10_000;

/** What a link needs besides its settings. */
interface NatsLinkContext {
  readonly settings: NatsSettings;
  readonly clock: Clock;
  readonly log: Log;
  /** How long the start waits for a server, milliseconds. Default: 10 000 */
  readonly startMs?: number;
}

/** A connection to the NATS servers of a cluster, which comes back whenever it is lost. [CU-60] */
export class NatsLink {
  readonly connection: NatsConnection;
  readonly clock: Clock;
  readonly log: Log;
  /** How long a start waits for NATS, milliseconds. */
  readonly startMs: number;
  readonly #pace: ReconnectPace;
  readonly #listeners = new Set<(isConnected: boolean) => void>();
  #isConnected = true;
  #isClosed = false;

  private constructor(connection: NatsConnection, pace: ReconnectPace, context: NatsLinkContext) {
    this.connection = connection;
    this.clock = context.clock;
    this.log = context.log;
    this.startMs = context.startMs ?? START_MS;
    this.#pace = pace;
    void this.#watch();
  }

  /**
   * Connects to one of the servers, and waits for one for a while.
   *
   * @throws ConfigError when none could be reached, or refuses this master
   */
  static async open(context: NatsLinkContext): Promise<NatsLink> {
    const { clock, log, settings, startMs = START_MS } = context;
    const pace = new ReconnectPace();
    const options = connectOptions(settings, () => pace.delayMs());
    const endMs = clock.monotonicMs() + startMs;
    for (let attempt = 1; ; attempt += 1) {
      try {
        const link = new NatsLink(await connect(options), pace, context);
        log.info('connected to NATS', { server: link.connection.getServer() });
        return link;
      } catch (error) {
        const failure = explainStart(error, settings.address.servers);
        if (failure.isFinal || clock.monotonicMs() >= endMs) throw failure.error;
        if (attempt === 1) {
          log.warn(`no NATS server answers yet; waiting up to ${startMs / 1000} s`, {
            servers: settings.address.servers.join(', '),
          });
        }
        await new Promise<void>((resolve) => clock.after(RETRY_MS, resolve));
      }
    }
  }

  /** Whether a server can be reached, as far as is known by now. */
  get isConnected(): boolean {
    return this.#isConnected;
  }

  /** Bytes that one message may have at most; 0 while no server is connected. */
  get maxPayloadBytes(): number {
    return this.connection.info?.max_payload ?? 0;
  }

  /** Calls `fn` whenever a server can be reached again, or no longer. */
  onReach(fn: (isConnected: boolean) => void): Cancel {
    this.#listeners.add(fn);
    return () => this.#listeners.delete(fn);
  }

  /** Closes the connection. What was not flushed is lost. */
  async close(): Promise<void> {
    this.#isClosed = true;
    this.#isConnected = false;
    this.#listeners.clear();
    await this.connection.close();
  }

  async #watch(): Promise<void> {
    for await (const status of this.connection.status()) {
      switch (status.type) {
        case 'disconnect':
          this.#setConnected(false);
          break;
        case 'reconnecting':
          this.#pace.handleAttempt();
          break;
        case 'reconnect':
          this.#pace.handleSuccess();
          this.#setConnected(true);
          break;
        case 'error':
          this.log.error('NATS refused something', { reason: status.error.message });
          break;
        default:
      }
    }
  }

  #setConnected(isConnected: boolean): void {
    if (this.#isClosed || isConnected === this.#isConnected) return;
    this.#isConnected = isConnected;
    if (isConnected) this.log.info('NATS is back', { server: this.connection.getServer() });
    else this.log.warn('lost the connection to NATS; connecting again');
    for (const listener of [...this.#listeners]) listener(isConnected);
  }
}
