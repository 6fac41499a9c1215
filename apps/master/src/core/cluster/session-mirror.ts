import { INFO_TOPICS, type ClusterSessionNews, type Init } from '@ubii/proto';
import type { MasterPublisher } from '../info/master-publisher.ts';
import type { ForeignSessions } from '../sessions/foreign-sessions.ts';
import type { SessionTable } from '../sessions/session-table.ts';

/** Dependencies of the sessions of other masters. */
export interface MirrorContext {
  readonly publisher: Pick<MasterPublisher, 'publish'>;
  readonly foreignSessions: ForeignSessions;
  readonly sessionTable: SessionTable;
}

const NEWS_TOPICS = new Set<string>(Object.values(INFO_TOPICS));

/** Sessions of other masters, for clients of this one. [CU-30] */
export class SessionMirror {
  readonly #context: MirrorContext;

  constructor(context: MirrorContext) {
    this.#context = context;
  }

  /** Sessions of this master as they are now, for a master that begins to listen. */
  own(): Init<ClusterSessionNews>[] {
    const sessions = [...this.#context.sessionTable.values()];
    return sessions.map((session) => ({ topic: '', session: session.toMessage() }));
  }

  idsOf(masterId: string): string[] {
    return this.#context.foreignSessions.idsOf(masterId);
  }

  /** A master tells of one of its sessions: clients here are told the same. */
  handleNews(masterId: string, { topic, session }: ClusterSessionNews): void {
    const { foreignSessions, sessionTable, publisher } = this.#context;
    if (session === undefined || session.id === '') return;
    // Two run it after they were apart: who owns it decides. [CU-34]
    if (sessionTable.get(session.id) !== undefined) return;
    if (topic === INFO_TOPICS.deleteSession) foreignSessions.delete(masterId, session.id);
    else foreignSessions.set(masterId, session);
    if (NEWS_TOPICS.has(topic)) publisher.publish(topic, { session });
  }

  /** It is not there any more, although nobody told. */
  delete(masterId: string, id: string): void {
    const { foreignSessions, publisher } = this.#context;
    const session = foreignSessions.list().find((one) => one.id === id);
    foreignSessions.delete(masterId, id);
    if (session !== undefined) publisher.publish(INFO_TOPICS.deleteSession, { session });
  }
}
