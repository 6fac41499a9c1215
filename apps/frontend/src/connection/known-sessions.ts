import { INFO_TOPICS, type Session } from '@ubii/proto';
import { Recency } from './recency.ts';

/** More sessions than these are not asked for one by one. */
const MAX_SINGLE = 8;

/** What has to be asked: the whole list, or these sessions. */
export type SessionQuestion = 'list' | readonly string[];

interface Announcement {
  readonly topic: string;
  readonly session: Session;
  /**
   * The first one on its topic since the link is up: the master may have retained it for long. The list, which is
   * asked for after the subscription, is then newer.
   */
  readonly isDoubtful: boolean;
}

const revisionOf = (session: Session | undefined): number => session?.extension?.revision ?? 0;

/** The sessions as lists, announcements and replies tell, and what has to be asked to know the rest. */
export class KnownSessions {
  #known = new Map<string, Session>();
  #hasList = false;
  /** The list is of the link that is up now. */
  #isCurrent = false;
  /** Topics on which something was announced since the link is up. */
  readonly #heard = new Set<string>();
  /** Doubtful ones that came before the list. */
  #early: Announcement[] = [];
  readonly #recency = new Recency();
  readonly #asked = new Set<string>();
  #wantsList = false;

  /** In the order in which the master lists them; `undefined` until the first list. */
  get list(): readonly Session[] | undefined {
    return this.#hasList ? [...this.#known.values()] : undefined;
  }

  find(id: string): Session | undefined {
    return this.#known.get(id);
  }

  /** The link is gone: what is retained will be announced again. */
  handleDisconnected(): void {
    this.#isCurrent = false;
    this.#heard.clear();
    this.#early = [];
  }

  /** Makes this the newest of its session, or the session gone: a reply, or an announcement in its order. */
  set(id: string, session: Session | undefined): void {
    this.answerOne(id, session, this.now());
    this.#asked.delete(id);
  }

  /**
   * Takes the reply of a service. Replies and announcements travel on different channels: an announcement that is
   * newer may have come before, so the session is asked for once more.
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

  /** The moment of a question. */
  now(): number {
    return this.#recency.now();
  }

  /** What is to be asked now, once; `undefined` for nothing. */
  takeQuestion(): SessionQuestion | undefined {
    const ids = [...this.#asked];
    const isList = this.#wantsList || ids.length > MAX_SINGLE;
    this.#asked.clear();
    this.#wantsList = false;
    if (isList) return 'list';
    return ids.length > 0 ? ids : undefined;
  }

  /** @param turn when it was asked */
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

  /** @param turn when it was asked */
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
        // One that is overtaken by the reply that caused it
        else if (!this.#isCurrent || revisionOf(session) >= revisionOf(known)) {
          this.set(session.id, session);
        }
        break;
      case INFO_TOPICS.deleteSession:
        if (!isDoubtful) this.set(session.id, undefined);
        else if (known !== undefined) this.#wantsList = true;
        break;
      default:
        // What starts and stops may be told with the modules of one node alone [SE-33].
        if (known !== undefined) this.#asked.add(session.id);
    }
  }

  /** Of a session that the list has, that one is asked for; it may also be stored and not open, so of others the list. */
  #doubt(topic: string, id: string): void {
    if (this.find(id) !== undefined) this.#asked.add(id);
    else if (topic === INFO_TOPICS.newSession) this.#wantsList = true;
  }
}
