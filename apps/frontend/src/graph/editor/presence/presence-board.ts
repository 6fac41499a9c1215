import { clientOfPresence } from '../../../topics/names/presence-topic.ts';
import { parsePresence, type PresenceRecord } from './presence-record.ts';

/** Another user who has the session open. */
export interface Present extends PresenceRecord {
  readonly clientId: string;
  /** Time of the newest record, milliseconds of a monotonic clock. */
  readonly heardMs: number;
}

/** A user without a record for this time has left, milliseconds. [EX-49] */
export const PRESENCE_AGE_MS = 45_000;

/** Difference in the set of present users. */
export interface BoardChange {
  readonly arrived: readonly string[];
  readonly left: readonly string[];
}

const NOTHING: BoardChange = { arrived: [], left: [] };

/** Other users who have a session open, from the presence records of their editors. [EX-49] */
export class PresenceBoard {
  readonly #sessionId: string;
  readonly #ownId: () => string;
  readonly #present = new Map<string, Present>();

  constructor(sessionId: string, ownId: () => string) {
    this.#sessionId = sessionId;
    this.#ownId = ownId;
  }

  /** In the order of arrival. */
  get list(): readonly Present[] {
    return [...this.#present.values()];
  }

  /** Handles a record published on a topic. */
  hear(topic: string, text: string, nowMs: number): BoardChange {
    const clientId = clientOfPresence(topic);
    if (clientId === undefined || clientId === this.#ownId()) return NOTHING;
    const record = parsePresence(text);
    if (record?.session !== this.#sessionId) return this.drop(clientId);
    const isNew = !this.#present.has(clientId);
    this.#present.set(clientId, { ...record, clientId, heardMs: nowMs });
    return isNew ? { arrived: [clientId], left: [] } : NOTHING;
  }

  /** Removes clients that disconnected or closed the session. */
  drop(...clientIds: readonly string[]): BoardChange {
    const left = clientIds.filter((id) => this.#present.delete(id));
    return left.length === 0 ? NOTHING : { arrived: [], left };
  }

  /** Removes users without a recent record; hidden pages send none, and stay. */
  expire(nowMs: number): BoardChange {
    const silent = this.list.filter(
      ({ isHidden, heardMs }) => !isHidden && nowMs - heardMs > PRESENCE_AGE_MS,
    );
    return this.drop(...silent.map(({ clientId }) => clientId));
  }

  clear(): void {
    this.#present.clear();
  }
}
