import type { UbiiClient } from '@ubii/client-web';
import { crowderOf, isFull, type Room } from '../../sim/index.ts';

/** New clients in one question to the master: more than there are places. Others are refused. */
const MAX_ASKING = 128;

export interface CrowdingOptions {
  readonly client: UbiiClient;
  readonly room: () => Room;
  /** Takes the place of a person. */
  remove(key: string): void;
}

/** Divides seats and places to watch between addresses: one person can take all of them with many clients. */
export class Crowding {
  readonly #options: CrowdingOptions;
  #asking = new Set<string>();
  #last: Promise<unknown> = Promise.resolve();
  #next: Promise<ReadonlyMap<string, string>> | undefined;

  constructor(options: CrowdingOptions) {
    this.#options = options;
  }

  /** Frees a place for a new client, if all are taken and one address has more than its share. @returns whether one is free */
  async makeRoom(key: string, as: 'join' | 'watch'): Promise<boolean> {
    const { room, remove } = this.#options;
    if (!isFull(room(), as)) return false;
    const addresses = await this.#addressesWith(key);
    // The room may be another one now
    if (!isFull(room(), as)) return true;
    const { players, spectators } = room();
    const crowder = crowderOf(as === 'join' ? players : spectators, key, addresses);
    if (crowder === undefined) return false;
    remove(crowder);
    return true;
  }

  /** One question at a time: new clients that ask meanwhile share the next. */
  #addressesWith(key: string): Promise<ReadonlyMap<string, string>> {
    if (this.#asking.size >= MAX_ASKING) return Promise.resolve(new Map());
    this.#asking.add(key);
    if (this.#next === undefined) {
      this.#next = this.#last.then(() => this.#ask());
      this.#last = this.#next;
    }
    return this.#next;
  }

  /** @returns what clients of one address share, by key (EX-99) */
  async #ask(): Promise<ReadonlyMap<string, string>> {
    const { players, spectators } = this.#options.room();
    const people = [...players, ...spectators].flatMap(({ key }) => key ?? []);
    const clientIds = [...this.#asking, ...people];
    this.#asking = new Set();
    this.#next = undefined;
    try {
      const { clients } = await this.#options.client.call('clientReport', { clientIds });
      return new Map(
        clients
          .filter(({ addressGroup }) => addressGroup !== '')
          .map(({ clientId, addressGroup }) => [clientId, addressGroup]),
      );
    } catch {
      return new Map(); // Not connected, or not allowed: no client gives its place
    }
  }
}
