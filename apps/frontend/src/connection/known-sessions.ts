import { INFO_TOPICS, type Session } from '@ubii/proto';
import { Recency } from './recency.ts';

/** Most sessions requested by id; above, the list is requested. */
const MAX_SINGLE = 8;

/** Request to make: the whole list, or these sessions. */
export type SessionQuestion = 'list' | readonly string[];

interface Announcement {
  readonly topic: string;
  readonly session: Session;
  /**
   * True for the first announcement on its topic since the connection: it may be an old, retained one. The list,
   * requested after the subscription, is newer.
   */
  readonly isDoubtful: boolean;
}

const revisionOf = (session: Session | undefined): number => session?.extension?.revision ?? 0;

/** Sessions known from lists, announcements and replies, and the requests needed to complete them. */
export class KnownSessions {
  #known = new Map<string, Session>();
  #hasList = false;
  /** True when the list was received on the current connection. */
  #isCurrent = false;
  /** Topics with an announcement since the connection. */
  readonly #heard = new Set<string>();
  /** Doubtful announcements received before the list. */
  #early: Announcement[] = [];
  readonly #recency = new Recency();
  readonly #asked = new Set<string>();
  #wantsList = false;

  /** In the order of the master's list; `undefined` until the first list arrives. */
  get list(): readonly Session[] | undefined {
    return this.#hasList ? [...this.#known.values()] : undefined;
  }

  find(id: string): Session | undefined {
    return this.#known.get(id);
  }

  /** The connection was lost: retained announcements will be received again. */
  handleDisconnected(): void {
    this.#isCurrent = false;
    this.#heard.clear();
    this.#early = [];
  }

  /** Stores the newest state of a session, or its removal: from a reply, or an announcement in order. */
  set(id: string, session: Session | undefined): void {
    this.answerOne(id, session, this.now());
    this.#asked.delete(id);
  }

  /**
   * Handles the reply of a service. Replies and announcements use different channels, so a newer announcement may have
   * arrived before: the session is requested once more.
   */
  takeReply(session: Session): void {
    this.set(session.id, session);
    this.#asked.add(session.id);
  }

  announce(topic: string, session: Session): void {
    const isDoubtful = !this.#heard.has(topic);
    this.#heard.add(topic);
    if (session.id === '') return;
    if (isDoubtful && !this.#isCurrent) this.#early.push({ topic, session, isDoubtful });
    else this.#handle({ topic, session, isDoubtful });
  }

  /** Time of a request. */
  now(): number {
    return this.#recency.now();
  }

  /** Returns the request to make now, once; `undefined` for none. */
  takeQuestion(): SessionQuestion | undefined {
    const ids = [...this.#asked];
    const isList = this.#wantsList || ids.length > MAX_SINGLE;
    this.#asked.clear();
    this.#wantsList = false;
    if (isList) return 'list';
    return ids.length > 0 ? ids : undefined;
  }

  /** Takes back a question that got no reply. */
  putBack(question: SessionQuestion): void {
    if (question === 'list') this.#wantsList = true;
    else for (const id of question) this.#asked.add(id);
  }

  /** @param turn time of the request */
  answerList(elements: readonly Session[], turn: number): void {
    const next = new Map<string, Session>();
    for (const element of elements) {
      const newest = this.#recency.accepts(element.id, turn) ? element : this.find(element.id);
      if (newest !== undefined) next.set(element.id, newest);
    }
    for (const [id, session] of this.#known) {
      if (!next.has(id) && !this.#recency.accepts(id, turn)) next.set(id, session);
    }
    this.#known = next;
    this.#hasList = true;
    this.#isCurrent = true;
    for (const announcement of this.#early.splice(0)) this.#handle(announcement);
  }

  /** @param turn time of the request */
  answerOne(id: string, session: Session | undefined, turn: number): void {
    if (!this.#recency.accepts(id, turn)) return;
    if (session === undefined) this.#known.delete(id);
    else this.#known.set(id, session);
  }

  #handle({ topic, session, isDoubtful }: Announcement): void {
    const known = this.find(session.id);
    switch (topic) {
      case INFO_TOPICS.newSession:
      case INFO_TOPICS.changeSession:
      case INFO_TOPICS.runningSession:
        if (isDoubtful) this.#doubt(topic, session.id);
        // Ignore an announcement that arrives after the reply of the request that caused it.
        else if (!this.#isCurrent || revisionOf(session) >= revisionOf(known)) {
          this.set(session.id, session);
        }
        break;
      case INFO_TOPICS.deleteSession:
        if (!isDoubtful) this.set(session.id, undefined);
        else if (known !== undefined) this.#wantsList = true;
        break;
      default:
        // Announcements while starting and stopping may contain only the modules of one node. [SE-33]
        if (known !== undefined) this.#asked.add(session.id);
    }
  }

  /** Requests a listed session by id; for unlisted ones the list, because the session may be stored and not open. */
  #doubt(topic: string, id: string): void {
    if (this.find(id) !== undefined) this.#asked.add(id);
    else if (topic === INFO_TOPICS.newSession) this.#wantsList = true;
  }
}
