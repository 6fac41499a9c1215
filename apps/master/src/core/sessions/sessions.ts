import { hasSameCode } from '@ubii/pm-sandbox';
import {
  encode,
  isUuid,
  ModuleVersionOrigin,
  ServiceError,
  type NodeInfo,
  type ProcessingModule,
  type Session as SessionMessage,
} from '@ubii/proto';
import { toGrantIds, type GrantId } from '../access/grant.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { isSame, type ModuleHistory } from '../library/module-history.ts';
import type { LocalTopics } from '../nodes/local-topics.ts';
import type { IdSource } from '../ports/id-source.ts';
import { quote } from '../texts/quote.ts';
import type { DraftModule } from './complete-modules.ts';
import type { LifeContext } from './life-context.ts';
import { assignNode } from './place-module.ts';
import { RestoredSessions, type SessionsAtStop } from './restored-sessions.ts';
import { Session } from './session.ts';
import type { SessionClaims } from './session-claims.ts';
import type { SessionLibrary } from './session-library.ts';
import { pauseSession, resumeSession, startSession, stopSession } from './session-life.ts';
import type { SessionModule } from './session-module.ts';
import { checkRequest, recheckWarnings, type RequestContext } from './session-request.ts';
import type { SessionTable } from './session-table.ts';
import { StartLimits } from './start-limits.ts';
import { updateSession } from './update-session.ts';

/** Dependencies of sessions. */
export interface SessionsContext {
  readonly ids: IdSource;
  readonly limits: LimitWatch;
  readonly table: SessionTable;
  readonly requests: RequestContext;
  readonly life: LifeContext;
  readonly claims: SessionClaims;
  readonly library: SessionLibrary;
  readonly history: ModuleHistory;
  /** Topics of modules on the master. */
  readonly topics: Pick<LocalTopics, 'keepOnly' | 'endSession'>;
}

/** Operations on sessions. Requests are checked before anything changes. */
export class Sessions {
  readonly #context: SessionsContext;
  readonly #startLimits: StartLimits;
  /** Sessions that come back without a request: at startup [SE-24], and from lost masters [CU-32]. */
  readonly restored: RestoredSessions;
  /** Stored sessions that are being opened, by id. */
  readonly #opening = new Map<string, Promise<Session>>();

  constructor(context: SessionsContext) {
    this.#context = context;
    this.#startLimits = new StartLimits(context.life, context.limits);
    this.restored = new RestoredSessions({
      ...context,
      recheck: (session) => void this.#recheck(session),
    });
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

  /** Sessions that clients of a grant created or changed [AC-90]. */
  madeWith(grantId: GrantId): Session[] {
    return this.list().filter(({ grantIds }) => grantIds.has(grantId));
  }

  /** Removes a grant from a session, which belongs to the operator from now on [AC-92]. */
  handOver(session: Session, grantId: GrantId): void {
    if (!session.removeGrant(grantId)) return;
    const { life } = this.#context;
    life.onModules.emit(session);
    life.news.announceChange(session);
  }

  /**
   * Creates a session, or opens the stored one of its id or name when it has no modules [SE-1] [SE-27].
   *
   * @param maker grant of the client that asks; undefined for callers without one [AC-90]
   */
  async add(message: SessionMessage, maker: GrantId | undefined): Promise<Session> {
    if (message.processingModules.length === 0) {
      const stored = this.#context.library.find(message);
      if (stored !== undefined) return this.find(stored.id);
      // An id alone is to open what is stored, and nothing else.
      if (message.id !== '' && message.name === '') return this.require(message.id);
    }
    return this.#create(message, maker);
  }

  /**
   * Returns the session to be stored: by its id, else by its name, else a new one, which keeps the id when it is a UUID
   * that no session has [SE-21].
   *
   * @param maker as for `add`
   */
  async toStore(message: SessionMessage, maker: GrantId | undefined): Promise<Session> {
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

  /** Starts an open session, a stored one, or one that it creates [SE-11]. */
  async start(message: SessionMessage, maker: GrantId | undefined): Promise<Session> {
    const session = await this.#toStart(message, maker);
    this.#startLimits.spend(session, maker);
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
   *
   * @param isBeingStored the session counts as stored under its new name already: otherwise clients would not delete its file
   */
  async update(
    session: Session,
    message: SessionMessage,
    maker: GrantId | undefined,
    { isBeingStored = false } = {},
  ): Promise<void> {
    const { requests, life, topics, table } = this.#context;
    this.#requireNewest(session, message);
    const byteLength = this.#requireSpace(message, session);
    const { modules, warnings } = await checkRequest(requests, message, session);
    // Another request may have changed the session while the code was checked.
    this.require(session.id);
    this.#requireNewest(session, message);
    const before = new Map(session.modules.map(({ id, spec }) => [id, spec]));
    const grantIds = this.#grantsOf(modules, maker);
    const content = { message, modules, byteLength, warnings, grantIds };
    updateSession(life, session, content, isBeingStored);
    topics.keepOnly(session.id, session.outputTopics());
    this.#recordVersions(session, before);
    life.news.announceChange(session);
    table.reindex(session);
    life.onModules.emit(session);
  }

  /** Grants behind the code of modules: of the client that sends them, and of the clients that stored them. [AC-90] */
  #grantsOf(modules: readonly DraftModule[], maker: GrantId | undefined): Set<GrantId> {
    const grantIds = new Set(maker === undefined ? [] : [maker]);
    const { stored } = this.#context.requests.completion;
    for (const { spec } of modules) {
      const offer = stored(spec.name);
      if (offer === undefined || offer.isTrusted || !hasSameCode(spec, offer.module)) continue;
      for (const id of toGrantIds(offer.module.extension?.grantIds)) grantIds.add(id);
    }
    return grantIds;
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

  /** Ends a session that another master runs, without an announcement, because it continues there. [CU-34] */
  giveUp(session: Session): void {
    const { life, table, topics } = this.#context;
    table.delete(session);
    session.giveUp();
    life.local.sync(session.id, []);
    topics.endSession(session.id);
    life.onLife.emit(session);
  }

  /** Checks the surroundings of a session again, and announces changed warnings [SE-5]. */
  recheck(session: Session): void {
    if (this.#recheck(session)) this.#context.life.news.announceChange(session);
  }

  #recheck(session: Session): boolean {
    return session.setWarnings(recheckWarnings(this.#context.requests, session));
  }

  /** A session became stored, or is no longer [SE-21]. */
  setStored(session: Session, isStored: boolean): void {
    if (session.setStored(isStored)) this.#context.life.news.announceChange(session);
  }

  async #toStart(message: SessionMessage, maker: GrantId | undefined): Promise<Session> {
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
    return idle ?? this.#addStored(stored);
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
  #addStored(stored: SessionMessage, id?: string): Promise<Session> {
    const grantIds = toGrantIds(stored.extension?.grantIds);
    const revision = Math.max(1, stored.extension?.revision ?? 0);
    return this.#make(stored, { id, isStored: true, grantIds, revision });
  }

  /** @param id kept when it is a UUID that no session has */
  #create(message: SessionMessage, maker: GrantId | undefined, id?: string): Promise<Session> {
    const grantIds = maker === undefined ? [] : [maker];
    return this.#make(message, { id, isStored: false, grantIds, revision: 1 });
  }

  async #make(
    message: SessionMessage,
    as: {
      readonly id: string | undefined;
      readonly isStored: boolean;
      readonly grantIds: readonly GrantId[];
      readonly revision: number;
    },
  ): Promise<Session> {
    const { ids, table, life, claims, requests } = this.#context;
    this.#requireRoom();
    const { modules, warnings } = await checkRequest(requests, message);
    this.#requireRoom();
    this.#requireSpace(message);
    const isFree = as.id !== undefined && isUuid(as.id) && table.get(as.id) === undefined;
    const id = isFree ? as.id : ids.uuid();
    await claims.claim(id);
    const session = new Session({
      id,
      masterId: table.masterId,
      message,
      modules,
      byteLength: this.#requireClaimed(id, message),
      warnings,
      grantIds: [...as.grantIds, ...this.#grantsOf(modules, undefined)],
      isStored: as.isStored,
      revision: as.revision,
    });
    table.add(session);
    for (const module of session.modules) assignNode(life, module);
    life.news.announceNew(session);
    if (claims.isShared) life.onModules.emit(session); // [CU-33]
    return session;
  }

  /** Requires again, after a claim, what was required before it. @returns bytes of the session @throws ServiceError */
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
