import { encode, INFO_TOPICS, type ClusterSessionNews, type Init, type Session } from '@ubii/proto';
import type { MasterPublisher } from '../info/master-publisher.ts';
import type { OwnerStore } from '../ports/owner-store.ts';
import type { ForeignSessions } from '../sessions/foreign-sessions.ts';
import type { SessionTable } from '../sessions/session-table.ts';
import { areEqual } from '../topics/equal-bytes.ts';

/** Dependencies of the sessions of other masters. */
export interface MirrorContext {
  readonly publisher: Pick<MasterPublisher, 'publish'>;
  readonly foreignSessions: ForeignSessions;
  readonly sessionTable: SessionTable;
  readonly owners: OwnerStore;
  /** True while the master is reachable. */
  readonly isReachable: (masterId: string) => boolean;
}

const NEWS_TOPICS = new Set<string>(Object.values(INFO_TOPICS));

/** Topic that announces the state of a session in a new stream to clients; undefined when they have this state already. */
function topicOfState(known: Session | undefined, session: Session): string | undefined {
  if (known === undefined) return INFO_TOPICS.newSession;
  const isSame = areEqual(
    encode('ubii.sessions.Session', known),
    encode('ubii.sessions.Session', session),
  );
  return isSame ? undefined : INFO_TOPICS.changeSession;
}

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

  /** Applies the announcement of a session of another master, and passes it on to clients of this one. */
  handleNews(masterId: string, { topic, session }: ClusterSessionNews): void {
    const { foreignSessions, sessionTable, publisher } = this.#context;
    if (session === undefined || session.id === '') return;
    if (!this.#mayBeOf(masterId, session.id)) return;
    const newsTopic = topic === '' ? topicOfState(foreignSessions.get(session.id), session) : topic;
    if (topic === INFO_TOPICS.deleteSession) foreignSessions.delete(masterId, session.id);
    else foreignSessions.set(masterId, session);
    // Two run it after they were apart: who owns it decides. [CU-34]
    if (sessionTable.get(session.id) !== undefined) return;
    if (newsTopic !== undefined && NEWS_TOPICS.has(newsTopic)) {
      publisher.publish(newsTopic, { session });
    }
  }

  /** A master that was disconnected may announce a session that another one has taken over. */
  #mayBeOf(masterId: string, sessionId: string): boolean {
    const { owners, isReachable } = this.#context;
    const ownerId = owners.owners().get(sessionId);
    return ownerId === undefined || ownerId === masterId || !isReachable(ownerId);
  }

  /** It was removed without an announcement. */
  delete(masterId: string, id: string): void {
    const { foreignSessions, publisher } = this.#context;
    const session = foreignSessions.list().find((one) => one.id === id);
    foreignSessions.delete(masterId, id);
    if (session !== undefined) publisher.publish(INFO_TOPICS.deleteSession, { session });
  }
}
