import { endForeign } from '../topics/foreign-records.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import type { Directory } from './directory.ts';
import type { SessionMirror } from './session-mirror.ts';

/** Looks from the end of the first part of a stream until values that are missing in it are deleted. */
const VALUES_LOOKS = 4;

/** What is known of other masters. */
export interface ResyncContext {
  readonly topics: TopicTable;
  readonly directory: Pick<Directory, 'idsOf' | 'delete'>;
  readonly mirror: Pick<SessionMirror, 'idsOf' | 'delete'>;
}

/** What a new stream has announced so far, by id or key. */
interface Announced {
  readonly clients: Set<string>;
  readonly interests: Set<string>;
  readonly sessions: Set<string>;
}

/** Interests of the other master, by key. */
interface Interests {
  readonly keys: Iterable<string>;
  end(key: string): void;
}

/**
 * Brings what is known of another master up to date with a new stream of it: when the stream has announced all, everything
 * else that is known of the master is deleted; values a little later. [CU-7]
 */
export class Resync {
  readonly #context: ResyncContext;
  readonly #masterId: string;
  #announced: Announced | undefined = {
    clients: new Set(),
    interests: new Set(),
    sessions: new Set(),
  };
  #topics: Set<string> | undefined = new Set();
  #valuesLooks = 0;

  constructor(context: ResyncContext, masterId: string) {
    this.#context = context;
    this.#masterId = masterId;
  }

  /** The stream has announced all that there was when it began. */
  get isComplete(): boolean {
    return this.#announced === undefined;
  }

  /** Topics whose values or records came in this stream; undefined when the others have been ended. */
  get topics(): Set<string> | undefined {
    return this.#topics;
  }

  note(kind: keyof Announced, id: string): void {
    this.#announced?.[kind].add(id);
  }

  /** Deletes the clients, sessions and interests that were not announced. */
  complete(interests: Interests): void {
    const announced = this.#announced;
    if (announced === undefined) return;
    this.#announced = undefined;
    // It may learn only now what is wanted here, and has sent no value because of that.
    this.#valuesLooks = VALUES_LOOKS;
    const { directory, mirror } = this.#context;
    for (const id of directory.idsOf(this.#masterId)) {
      if (!announced.clients.has(id)) directory.delete(this.#masterId, id);
    }
    for (const id of mirror.idsOf(this.#masterId)) {
      if (!announced.sessions.has(id)) mirror.delete(this.#masterId, id);
    }
    for (const key of interests.keys) {
      if (!announced.interests.has(key)) interests.end(key);
    }
  }

  /** To be called about twice a second. */
  sweep(): void {
    if (this.#valuesLooks > 0 && --this.#valuesLooks === 0) this.#endOtherValues();
  }

  #endOtherValues(): void {
    const announced = this.#topics;
    this.#topics = undefined;
    const { topics } = this.#context;
    for (const entry of topics.values()) {
      if (announced?.has(entry.topic) === false) endForeign(topics, entry, this.#masterId);
    }
  }
}
