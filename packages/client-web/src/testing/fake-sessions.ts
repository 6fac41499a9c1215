import { INFO_TOPICS, ServiceError, SERVICES, SessionState, decode, encode } from '@ubii/proto';
import type { Init, ProcessingModule, ServiceReply, Session } from '@ubii/proto';
import type { FakeMaster } from './fake-master.ts';

const ACTIVE: readonly SessionState[] = [
  SessionState.SESSION_STARTING,
  SessionState.SESSION_RUNNING,
  SessionState.SESSION_DEGRADED,
  SessionState.SESSION_PAUSED,
];

/** Sessions of a fake master: announces them as it is told to, and remembers what nodes report. */
export class FakeSessions {
  /** Everything nodes reported, in order: `add` or `remove` with the modules of one request. */
  readonly reports: { readonly kind: 'add' | 'remove'; readonly modules: ProcessingModule[] }[] =
    [];
  readonly #master: FakeMaster;
  readonly #sessions = new Map<string, Session>();

  constructor(master: FakeMaster) {
    this.#master = master;
    master.services.set(SERVICES.sessionRuntimeGetList.topic, () => ({
      sessionList: { elements: [...this.#sessions.values()] },
    }));
    const { processingModuleRuntimeAdd, processingModuleRuntimeRemove } = SERVICES;
    master.services.set(processingModuleRuntimeAdd.topic, ({ processingModuleList }) =>
      this.#report('add', processingModuleList?.elements ?? []),
    );
    master.services.set(processingModuleRuntimeRemove.topic, ({ processingModuleList }) =>
      this.#report('remove', processingModuleList?.elements ?? []),
    );
  }

  /** Ids of the modules reported, such as `add m1`, in order. */
  get told(): string[] {
    return this.reports.flatMap(({ kind, modules }) => modules.map(({ id }) => `${kind} ${id}`));
  }

  /** Announces the start of a session. */
  start(session: Init<Session>): void {
    this.#announce(INFO_TOPICS.startSession, session, SessionState.SESSION_STARTING);
  }

  /** Announces a change, in whatever state. */
  change(session: Init<Session>, state: SessionState = SessionState.SESSION_RUNNING): void {
    this.#announce(INFO_TOPICS.changeSession, session, state);
  }

  /** Announces the end of a session as masters do: with its id only. */
  stop(id: string): void {
    const known = this.#sessions.get(id);
    if (known !== undefined) this.put(known, SessionState.SESSION_STOPPED);
    this.#master.publish({ topic: INFO_TOPICS.stopSession, format: 'session', value: { id } });
  }

  /** Puts a session into the list silently. */
  put(init: Init<Session>, state: SessionState): Session {
    const bytes = encode('ubii.sessions.Session', {
      ...init,
      extension: { ...init.extension, state },
    });
    const session = decode('ubii.sessions.Session', bytes);
    this.#sessions.set(session.id, session);
    return session;
  }

  /** Forgets a session silently. */
  forget(id: string): void {
    this.#sessions.delete(id);
  }

  #announce(topic: string, init: Init<Session>, state: SessionState): void {
    const value = this.put(init, state);
    this.#master.publish({ topic, format: 'session', value });
  }

  #report(kind: 'add' | 'remove', modules: ProcessingModule[]): Init<ServiceReply> {
    this.reports.push({ kind, modules });
    const known = [...this.#sessions.values()]
      .filter(({ extension }) => kind === 'remove' || ACTIVE.includes(extension!.state))
      .flatMap(({ processingModules }) => processingModules.map(({ id }) => id));
    const unknown = modules.filter(({ id }) => !known.includes(id));
    if (unknown.length === 0) return { success: { title: 'Success' } };
    throw new ServiceError('not_found', unknown.map(({ id }) => id).join(', '));
  }
}
