import type { Cancel, Clock } from '@ubii/timing';
import type { Limits } from '../limits/index.ts';
import type { KeptValues } from '../topics/kept-values.ts';
import type { Client } from './client.ts';
import type { ClientRegistry } from './client-registry.ts';

/** Interval of liveness checks, milliseconds. [CL-12] */
export const SWEEP_INTERVAL_MS = 500;
/**
 * Silence after which a client is asked [CL-12], milliseconds. Longer than the interval at which clients of ours send PING
 * themselves [EX-6], and as much before `SILENT_AFTER_MS`: a page may be busy for two seconds.
 */
export const PING_AFTER_MS = 2_500;
/** Age at which a latency is measured again, however much the client says [CL-12], milliseconds. */
export const LATENCY_AGE_MS = 5_000;
/** Silence that makes a client inactive [CL-13], milliseconds. */
export const SILENT_AFTER_MS = 5_000;
/** Silence that makes a client unavailable [CL-13], milliseconds. */
export const LOST_AFTER_MS = 10_000;

/** Checks every client in turn: pings silent clients, and removes lost ones. */
export class Liveness {
  readonly #clock: Clock;
  readonly #clients: ClientRegistry;
  readonly #limits: Limits;
  readonly #kept: KeptValues;
  readonly #cancel: Cancel;

  constructor(clock: Clock, clients: ClientRegistry, limits: Limits, kept: KeptValues) {
    this.#clock = clock;
    this.#clients = clients;
    this.#limits = limits;
    this.#kept = kept;
    this.#cancel = clock.every(SWEEP_INTERVAL_MS, () => this.#sweep());
  }

  close(): void {
    this.#cancel();
  }

  #sweep(): void {
    const nowMs = this.#clock.monotonicMs();
    // A client may be removed on the way, which a Map takes well.
    for (const client of this.#clients.values()) this.#look(client, nowMs);
    this.#kept.sweep(); // [TD-43]
  }

  #look(client: Client, nowMs: number): void {
    if (client.home?.isLost === false) return; // [CU-20]
    const silentMs = nowMs - client.lastSignMs;
    if (silentMs >= LOST_AFTER_MS) this.#clients.handleEvent(client, 'lost');
    else if (silentMs >= SILENT_AFTER_MS) this.#clients.handleEvent(client, 'silent');
    const isExpired =
      client.status === 'unavailable' &&
      nowMs - client.statusSinceMs >= this.#limits.unavailableRetentionMs;
    if (isExpired) {
      this.#clients.handleEvent(client, 'expired'); // [CL-14]
      return;
    }
    const { socket } = client;
    if (socket === undefined) return;
    if (silentMs >= PING_AFTER_MS || nowMs - client.latencyMeasuredMs >= LATENCY_AGE_MS) {
      socket.sendPing();
    }
    socket.handleSweep();
  }
}
