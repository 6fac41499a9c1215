import {
  encode,
  ModuleVersionOrigin,
  ServiceError,
  type NodeInfo,
  type ProcessingModule,
  type Session as SessionMessage,
  type SessionProblem,
} from '@ubii/proto';
import { isSame, type ModuleHistory } from '../library/module-history.ts';
import type { SessionLibrary } from '../library/session-library.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { LimitWatch } from '../status/limit-watch.ts';
import { quote } from '../topics/topic-names.ts';
import { checkSession, checkSurroundings, SURROUNDINGS } from './checks/check-session.ts';
import { completeDraft, draftOf, makeDraft, type DraftContext } from './draft-maker.ts';
import type { SessionDraft } from './draft.ts';
import type { LifeContext } from './life-context.ts';
import { assignNode } from './place-module.ts';
import { Session } from './session.ts';
import { pauseSession, resumeSession, startSession, stopSession } from './session-life.ts';
import type { SessionModule } from './session-module.ts';
import type { SessionTable } from './session-table.ts';
import { updateSession } from './update-session.ts';

/** What sessions are made with. */
export interface SessionsContext {
  readonly ids: IdSource;
  readonly limits: LimitWatch;
  readonly table: SessionTable;
  readonly drafts: DraftContext;
  readonly life: LifeContext;
  readonly library: SessionLibrary;
  readonly history: ModuleHistory;
}

/** Everything that can be done with sessions. Requests are checked before anything is changed. */
export class Sessions {
  readonly #context: SessionsContext;

  constructor(context: SessionsContext) {
    this.#context = context;
  }

  list(): Session[] {
    return [...this.#context.table.values()];
  }

  /** @throws ServiceError when there is none of this id. */
  require(id: string): Session {
    const session = this.#context.table.get(id);
    if (session !== undefined) return session;
    throw id === ''
      ? new ServiceError('invalid_argument', 'The request has no session.id; name the session.')
      : new ServiceError('not_found', `No session has the id ${quote(id)}.`);
  }

  /** The module of this id in any session. */
  findModule(id: string): { session: Session; module: SessionModule } | undefined {
    return this.#context.table.findModule(id);
  }

  /** Nodes with what they run now [PM-61]. */
  nodes(): NodeInfo[] {
    const { nodes, loadOf } = this.#context.life;
    return nodes.toMessages(loadOf);
  }

  /** Modules of sessions that live, as they are now. */
  runningModules(): ProcessingModule[] {
    return this.list()
      .filter(({ isLive }) => isLive)
      .flatMap((session) => session.toMessage().processingModules);
  }

  /** Creates a session, from a request or from the stored one of its name [SE-1]. */
  async add(message: SessionMessage): Promise<Session> {
    const { library } = this.#context;
    const stored = message.processingModules.length === 0 ? library.get(message.name) : undefined;
    return this.#create(stored ?? message, stored !== undefined);
  }

  /** Starts a session that is there, a stored one, or one that is created for it [SE-11]. */
  async start(message: SessionMessage): Promise<Session> {
    const session = await this.#toStart(message);
    startSession(this.#context.life, session);
    return session;
  }

  stop(session: Session): void {
    stopSession(this.#context.life, session);
  }

  pause(session: Session): void {
    pauseSession(this.#context.life, session);
  }

  resume(session: Session): void {
    resumeSession(this.#context.life, session);
  }

  /** [SE-15] */
  async update(session: Session, message: SessionMessage): Promise<void> {
    this.#requireNewest(session, message);
    const byteLength = this.#requireSpace(message, session);
    const { draft, warnings } = await makeDraft(this.#context.drafts, message, session);
    // Others may have been faster while the code was looked at.
    this.require(session.id);
    this.#requireNewest(session, message);
    const before = new Map(session.modules.map(({ id, spec }) => [id, spec]));
    updateSession(this.#context.life, session, draft);
    this.#recordVersions(session, before);
    session.byteLength = byteLength;
    session.warnings = this.#warningsOf(draft, warnings);
    this.#context.life.news.announceChange(session);
    this.#context.table.reindex(session);
    this.#context.life.onModules(session);
  }

  /** [EX-41] */
  #recordVersions(session: Session, before: ReadonlyMap<string, ProcessingModule>): void {
    for (const { id, spec } of session.modules) {
      const old = before.get(id);
      if (old === undefined || isSame(old, spec)) continue;
      void this.#context.history.record(`instance ${id}`, old, spec, ModuleVersionOrigin.SAVED);
    }
  }

  /** [SE-16] */
  remove(session: Session): void {
    const { life, table } = this.#context;
    stopSession(life, session);
    table.delete(session);
    life.onLife(session);
    life.news.announceGone(session);
  }

  /** Starts again what ran when the master ended [SE-24]. */
  restore(): void {
    const { library, drafts, table, life } = this.#context;
    for (const message of library.interrupted()) {
      const { draft } = completeDraft(drafts, message);
      const session = new Session(message.id, draft, library.get(message.name) !== undefined);
      session.byteLength = encode('ubii.sessions.Session', message).byteLength;
      table.add(session);
      life.news.announceNew(session);
      this.recheck(session, false);
      if (session.modules.length > 0) startSession(life, session);
    }
  }

  /** Looks anew at what is doubtful about its surroundings, and tells if that has changed [SE-5]. */
  recheck(session: Session, isToTell = true): void {
    const { drafts, life } = this.#context;
    const { modules } = draftOf(session);
    const warnings = [
      ...session.warnings.filter(({ code }) => !SURROUNDINGS.has(code)),
      ...checkSurroundings(modules, {
        ...drafts.checks,
        // Of one that lives, its modules say so.
        ...(session.isLive && { nodeProblem: () => undefined }),
      }),
    ];
    if (JSON.stringify(warnings) === JSON.stringify(session.warnings)) return;
    session.warnings = warnings;
    if (isToTell) life.news.announceChange(session);
  }

  /** A session became stored, or is no longer [SE-21]. */
  setStored(session: Session, isStored: boolean): void {
    if (session.isStored === isStored) return;
    session.isStored = isStored;
    this.#context.life.news.announceChange(session);
  }

  async #toStart(message: SessionMessage): Promise<Session> {
    const { table, library } = this.#context;
    if (message.id !== '') {
      const known = table.get(message.id);
      if (known !== undefined) return known;
      // Clients of the original send an id of their own with a new session.
      if (message.processingModules.length === 0 && library.get(message.name) === undefined) {
        return this.require(message.id);
      }
    }
    if (message.processingModules.length > 0) return this.#create(message, false);
    const stored = library.get(message.name);
    if (stored === undefined) return this.#create(message, false);
    const known = this.list().find(
      ({ isStored, isLive, life, description }) =>
        isStored && !isLive && life !== 'stopping' && description.name === message.name,
    );
    return known ?? this.#create(stored, true);
  }

  async #create(message: SessionMessage, isStored: boolean): Promise<Session> {
    const { ids, table, life, drafts } = this.#context;
    this.#requireRoom();
    const { draft, warnings } = await makeDraft(drafts, message);
    this.#requireRoom();
    const byteLength = this.#requireSpace(message);
    const session = new Session(ids.uuid(), draft, isStored);
    session.byteLength = byteLength;
    session.warnings = this.#warningsOf(draft, warnings);
    table.add(session);
    for (const module of session.modules) assignNode(life, module);
    life.news.announceNew(session);
    return session;
  }

  /** Mappings of a session stand in the order of its modules, which those of a request need not. */
  #warningsOf(draft: SessionDraft, found: readonly SessionProblem[]): SessionProblem[] {
    const isInOrder = draft.modules.every(
      ({ mappingPath }, index) => mappingPath === `ioMappings[${index}]`,
    );
    if (isInOrder) return [...found];
    const modules = draft.modules.map((module, index) => ({
      ...module,
      mappingPath: `ioMappings[${index}]`,
    }));
    const others = found.filter(({ code }) => code === 'not_checked');
    return [...checkSession(modules, this.#context.drafts.checks), ...others];
  }

  /** [SE-7] */
  #requireRoom(): void {
    const { table, limits } = this.#context;
    const { sessions } = limits.limits;
    if (table.size >= sessions) throw limits.refusal('sessions', `more than ${sessions} sessions`);
  }

  /** [SE-7] */
  #requireSpace(message: SessionMessage, before?: Session): number {
    const { table, limits } = this.#context;
    const { sessionBytes, sessionsBytes } = limits.limits;
    const { byteLength } = encode('ubii.sessions.Session', message);
    if (byteLength > sessionBytes) {
      throw limits.refusal('sessionBytes', `more than ${sessionBytes} bytes of one session`);
    }
    if (table.byteLength - (before?.byteLength ?? 0) + byteLength > sessionsBytes) {
      throw limits.refusal('sessionsBytes', `more than ${sessionsBytes} bytes of all sessions`);
    }
    return byteLength;
  }

  #requireNewest(session: Session, message: SessionMessage): void {
    const revision = message.extension?.revision ?? 0;
    if (revision === 0 || revision === session.revision) return;
    throw new ServiceError(
      'failed_precondition',
      `The update is made from revision ${revision} of the session ${quote(session.label)}, but somebody changed it since: it is at revision ${session.revision}; get it, and make the change again.`,
    );
  }
}
