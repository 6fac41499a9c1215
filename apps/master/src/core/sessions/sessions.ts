import { hasSameCode } from '@ubii/pm-sandbox';
import {
  encode,
  isUuid,
  ModuleVersionOrigin,
  ServiceError,
  SessionStatus,
  type NodeInfo,
  type ProcessingModule,
  type Session as SessionMessage,
  type SessionProblem,
} from '@ubii/proto';
import { isSame, type ModuleHistory } from '../library/module-history.ts';
import type { SessionLibrary } from './session-library.ts';
import type { LocalTopics } from '../nodes/local-topics.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { quote } from '../texts/quote.ts';
import { checkSession, checkSurroundings, SURROUNDINGS } from './checks/check-session.ts';
import { completeDraft, draftOf, makeDraft, type DraftContext } from './draft-maker.ts';
import type { SessionDraft } from './draft.ts';
import type { LifeContext } from './life-context.ts';
import { memoryShortage } from './memory-room.ts';
import { assignNode } from './place-module.ts';
import { RestoredSessions, type SessionsAtStop } from './restored-sessions.ts';
import { Session, type SessionMove } from './session.ts';
import { pauseSession, resumeSession, startSession, stopSession } from './session-life.ts';
import type { SessionModule } from './session-module.ts';
import type { SessionClaims } from './session-claims.ts';
import type { SessionTable } from './session-table.ts';
import { StartPace } from './start-pace.ts';
import { updateSession } from './update-session.ts';

/** Dependencies of sessions. */
export interface SessionsContext {
  readonly ids: IdSource;
  readonly limits: LimitWatch;
  readonly table: SessionTable;
  readonly drafts: DraftContext;
  readonly life: LifeContext;
  readonly claims: SessionClaims;
  readonly library: SessionLibrary;
  readonly history: ModuleHistory;
  /** Topics of modules on the master. */
  readonly topics: Pick<LocalTopics, 'keepOnly' | 'endSession'>;
}

/** Everything that can be done with sessions. Requests are checked before anything is changed. */
export class Sessions {
  readonly #context: SessionsContext;
  readonly #startPace: StartPace;
  /** Those that the master was to start at startup [SE-24]. */
  readonly restored = new RestoredSessions();
  /** Stored sessions that are being opened, by id. */
  readonly #opening = new Map<string, Promise<Session>>();

  constructor(context: SessionsContext) {
    this.#context = context;
    this.#startPace = new StartPace(context.life.clock, context.limits);
  }

  list(): Session[] {
    return [...this.#context.table.values()];
  }

  isOpen(id: string): boolean {
    return this.#context.table.get(id) !== undefined;
  }

  /** @throws ServiceError when there is none of this id. */
  require(id: string): Session {
    const session = this.#context.table.get(id);
    if (session !== undefined) return session;
    throw id === ''
      ? new ServiceError(
          'invalid_argument',
          'The request has no session.id. Set it to the id of the session.',
        )
      : new ServiceError('not_found', `No session has the id ${quote(id)}.`);
  }

  /** The session of this id; a stored one is opened [SE-27]. @throws ServiceError when there is none of this id. */
  async find(id: string): Promise<Session> {
    return this.#context.table.get(id) ?? (await this.#open(id)) ?? this.require(id);
  }

  /** The module of this id in any session. */
  findModule(id: string): { session: Session; module: SessionModule } | undefined {
    return this.#context.table.findModule(id);
  }

  /** Nodes with what they run now [PM-61]. */
  nodes(): NodeInfo[] {
    const { nodes, loadOf } = this.#context.life;
    return nodes.toMessages(loadOf, (node) => this.memoryOn(node.id));
  }

  /** Memory of modules on a node, bytes [SE-64]. */
  memoryOn(nodeId: string): number {
    return this.#context.table.memoryOn(nodeId);
  }

  /** Modules of sessions that live, as they are now. */
  runningModules(): ProcessingModule[] {
    return this.list()
      .filter(({ isLive }) => isLive)
      .flatMap((session) => session.toMessage().processingModules);
  }

  /** Returns which running sessions would restart and which would end if the master stopped now [SE-24]. */
  atStop(): SessionsAtStop {
    const live = this.list().filter(({ isLive }) => isLive);
    const labels = (startsAgain: boolean): string[] =>
      live
        .filter(({ description }) => description.startWithMaster === startsAgain)
        .map(({ label }) => label);
    return { startAgain: labels(true), end: labels(false) };
  }

  /** Those that clients of a grant made or changed [AC-90]. */
  madeWith(grantId: string): Session[] {
    return this.list().filter(({ grantIds }) => grantIds.has(grantId));
  }

  /** It is the operator's from now on, and no longer that of a grant [AC-92]. */
  handOver(session: Session, grantId: string): void {
    if (!session.grantIds.delete(grantId)) return;
    const { life } = this.#context;
    life.onModules.emit(session);
    life.news.announceChange(session);
  }

  /**
   * Creates a session, or opens the stored one of its id or name when it has no modules [SE-1] [SE-27].
   * @param maker Grant of who asks for it; empty for who needs none [AC-90].
   */
  async add(message: SessionMessage, maker: string): Promise<Session> {
    if (message.processingModules.length === 0) {
      const stored = this.#context.library.find(message);
      if (stored !== undefined) return this.find(stored.id);
      // An id alone is to open what is stored, and nothing else.
      if (message.id !== '' && message.name === '') return this.require(message.id);
    }
    return this.#create(message, maker);
  }

  /**
   * The session that a stored one is made of: that of the id, else that of the name, else a new one, which
   * keeps the id when it is a UUID that no session has [SE-21].
   * @param maker as for `add`
   */
  async toStore(message: SessionMessage, maker: string): Promise<Session> {
    const { table, library } = this.#context;
    const stored = library.find(message);
    const known =
      table.get(message.id) ??
      this.list().find(
        ({ isStored, description }) => isStored && description.name === message.name,
      ) ??
      (stored && (await this.find(stored.id)));
    if (known === undefined) return this.#create(message, maker, message.id);
    // A name and an id alone mean the session as it is.
    if (message.processingModules.length > 0) {
      await this.update(known, message, maker, { isBeingStored: true });
    }
    return known;
  }

  /** Starts a session that is there, a stored one, or one that is created for it [SE-11]. */
  async start(message: SessionMessage, maker: string): Promise<Session> {
    const session = await this.#toStart(message, maker);
    this.#requireMemory(session);
    if (!session.isLive) this.#startPace.spend(session, maker);
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

  /**
   * [SE-15]
   * @param isBeingStored the session counts as stored under its new name already: otherwise clients would not delete its file
   */
  async update(
    session: Session,
    message: SessionMessage,
    maker: string,
    { isBeingStored = false } = {},
  ): Promise<void> {
    this.#requireNewest(session, message);
    const byteLength = this.#requireSpace(message, session);
    const { draft, warnings } = await makeDraft(this.#context.drafts, message, session);
    // Others may have been faster while the code was looked at.
    this.require(session.id);
    this.#requireNewest(session, message);
    const before = new Map(session.modules.map(({ id, spec }) => [id, spec]));
    this.#noteMakers(session, draft, maker);
    // Sessions are stored by name: a renamed one is not stored yet.
    if (!isBeingStored) session.isStored &&= draft.name === session.description.name;
    updateSession(this.#context.life, session, draft);
    this.#context.topics.keepOnly(session.id, session.outputTopics());
    this.#recordVersions(session, before);
    session.byteLength = byteLength;
    session.warnings = this.#warningsOf(draft, warnings);
    this.#context.life.news.announceChange(session);
    this.#context.table.reindex(session);
    this.#context.life.onModules.emit(session);
  }

  /**
   * Records the invitations behind the session's code: that of the client that changes it, and those of the clients
   * that stored its modules. [AC-90]
   */
  #noteMakers(session: Session, { modules }: SessionDraft, maker: string): void {
    if (maker !== '') session.grantIds.add(maker);
    const { stored } = this.#context.drafts.completion;
    for (const { spec } of modules) {
      const offer = stored(spec.name);
      if (offer === undefined || offer.isTrusted || !hasSameCode(spec, offer.module)) continue;
      for (const grantId of offer.module.extension?.grantIds ?? []) session.grantIds.add(grantId);
    }
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
    life.onLife.emit(session);
    this.#context.topics.endSession(session.id);
    this.#context.claims.release(session.id);
    life.news.announceGone(session);
  }

  /** Another master runs the session: here it ends without an announcement, because it goes on there. [CU-34] */
  giveUp(session: Session): void {
    const { life, table, topics } = this.#context;
    table.delete(session);
    session.isGivenUp = true;
    session.life = 'stopped';
    life.local.sync(session.id, []);
    topics.endSession(session.id);
    life.onLife.emit(session);
  }

  /**
   * Starts again what ran when the master ended [SE-24], but for what belongs to a grant that ended meanwhile.
   * @param isGood Whether those who joined with a grant may be here.
   */
  restore(isGood: (grantId: string) => boolean): void {
    for (const message of this.#context.library.interrupted()) {
      const session = this.#reopen(message);
      this.#context.life.news.announceNew(session);
      this.#startRestored(session, isGood);
    }
  }

  /**
   * Continues a session of a master that is lost, which this master owns now: what ran starts again. [CU-32]
   *
   * @param move whose it was
   * @returns undefined when nothing is known of it
   */
  takeOver(
    sessionId: string,
    isGood: (grantId: string) => boolean,
    move: SessionMove,
  ): Session | undefined {
    const { library, life } = this.#context;
    const message = library.interrupted().find(({ id }) => id === sessionId);
    if (message === undefined) return undefined;
    const session = this.#reopen(message);
    session.move = move;
    if (message.status === SessionStatus.RUNNING) this.#startRestored(session, isGood);
    else {
      this.recheck(session, false);
      life.onModules.emit(session);
    }
    life.news.announceChange(session);
    return session;
  }

  #reopen(message: SessionMessage): Session {
    const { library, drafts, table } = this.#context;
    const { draft } = completeDraft(drafts, message);
    const isStored = library.get(message.name) !== undefined;
    const session = new Session(message.id, draft, isStored, message.extension?.grantIds);
    session.revision = (message.extension?.revision ?? 0) + 1;
    session.byteLength = encode('ubii.sessions.Session', message).byteLength;
    table.add(session);
    return session;
  }

  #startRestored(session: Session, isGood: (grantId: string) => boolean): void {
    const { life } = this.#context;
    this.recheck(session, false);
    const mayRun = [...session.grantIds].every((grantId) => isGood(grantId));
    if (session.modules.length > 0 && mayRun) {
      session.isRestored = true;
      this.restored.note(session);
      startSession(life, session);
      return;
    }
    this.restored.note(
      session,
      mayRun
        ? 'It has no modules.'
        : 'The invitation of the client that created or changed it has ended. Start it to run it again.',
    );
    life.onModules.emit(session);
  }

  /** Looks again at what is doubtful about its surroundings, and tells if that has changed [SE-5]. */
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

  #requireMemory(session: Session): void {
    const { life, limits } = this.#context;
    const shortage = memoryShortage(life, session);
    if (shortage === undefined) return;
    if (shortage.limit !== undefined) limits.count(shortage.limit, life.nodes.masterId);
    throw new ServiceError('resource_exhausted', shortage.text, { details: shortage.details });
  }

  async #toStart(message: SessionMessage, maker: string): Promise<Session> {
    const { table, library } = this.#context;
    const known = table.get(message.id);
    if (known !== undefined) return known;
    // Clients of the original send an id of their own with a new session.
    if (message.processingModules.length > 0) return this.#create(message, maker);
    const stored = library.find(message);
    if (stored === undefined) {
      return message.id === '' ? this.#create(message, maker) : this.require(message.id);
    }
    const open = table.get(stored.id);
    if (open === undefined) return this.find(stored.id);
    const idle = this.list().find(
      ({ isStored, isLive, life, description }) =>
        isStored && !isLive && life !== 'stopping' && description.name === stored.name,
    );
    // It runs already: a second one beside it.
    return idle ?? this.#addStored(stored, '');
  }

  /** Opens a stored session once, however many ask for it at a time. */
  #open(id: string): Promise<Session> | undefined {
    const stored = this.#context.library.toOpen(id);
    if (stored === undefined) return undefined;
    const under = this.#opening.get(id);
    if (under !== undefined) return under;
    const opening = this.#addStored(stored, id).finally(() => this.#opening.delete(id));
    this.#opening.set(id, opening);
    return opening;
  }

  /** A stored session keeps the invitations of the clients that stored it. */
  async #addStored(stored: SessionMessage, id: string): Promise<Session> {
    const { grantIds = [], revision = 0 } = stored.extension ?? {};
    return this.#make(stored, { id, isStored: true, grantIds, revision });
  }

  /** @param id kept when it is a UUID that no session has */
  async #create(message: SessionMessage, maker: string, id = ''): Promise<Session> {
    const grantIds = maker === '' ? [] : [maker];
    return this.#make(message, { id, isStored: false, grantIds, revision: 0 });
  }

  async #make(
    message: SessionMessage,
    as: {
      readonly id: string;
      readonly isStored: boolean;
      readonly grantIds: readonly string[];
      readonly revision: number;
    },
  ): Promise<Session> {
    const { ids, table, life, drafts } = this.#context;
    this.#requireRoom();
    const { draft, warnings } = await makeDraft(drafts, message);
    this.#requireRoom();
    this.#requireSpace(message);
    const isFree = isUuid(as.id) && table.get(as.id) === undefined;
    const id = isFree ? as.id : ids.uuid();
    await this.#context.claims.claim(id);
    const byteLength = this.#requireClaimed(id, message);
    const session = new Session(id, draft, as.isStored, as.grantIds);
    session.revision = Math.max(1, as.revision);
    this.#noteMakers(session, draft, '');
    session.byteLength = byteLength;
    session.warnings = this.#warningsOf(draft, warnings);
    table.add(session);
    for (const module of session.modules) assignNode(life, module);
    life.news.announceNew(session);
    if (this.#context.claims.isShared) life.onModules.emit(session); // [CU-33]
    return session;
  }

  /** What was checked before a claim still holds. @returns bytes of the session @throws ServiceError */
  #requireClaimed(id: string, message: SessionMessage): number {
    const { claims, table } = this.#context;
    if (table.get(id) !== undefined) {
      throw new ServiceError(
        'unavailable',
        'This session was opened meanwhile. Send the request again.',
      );
    }
    try {
      this.#requireRoom();
      return this.#requireSpace(message);
    } catch (error) {
      claims.release(id);
      throw error;
    }
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
      `The update is made from revision ${revision} of the session ${quote(session.label)}, but the session changed since then: it is at revision ${session.revision}. Get it and make the change again.`,
    );
  }
}
