import { encode, SessionStatus, type Session as SessionMessage } from '@ubii/proto';
import { toGrantIds, type GrantId } from '../access/grant.ts';
import type { LifeContext } from './life-context.ts';
import { Session, type SessionMove } from './session.ts';
import type { SessionLibrary } from './session-library.ts';
import { startSession } from './session-life.ts';
import { completeRequest, type RequestContext } from './session-request.ts';
import type { SessionTable } from './session-table.ts';

/** Sessions that run while the master ends [SE-24]. Names are as their makers wrote them. */
export interface SessionsAtStop {
  /** Names of the sessions that start with the next master. */
  readonly startAgain: readonly string[];
  readonly end: readonly string[];
}

/** Results of the sessions that this master had to restart [SE-24]. */
export interface RestoreReport {
  /** Names of those whose modules all run. */
  readonly running: readonly string[];
  readonly others: readonly { readonly name: string; readonly reason: string }[];
}

/** Dependencies of restored sessions. */
export interface RestoreContext {
  readonly table: SessionTable;
  readonly requests: RequestContext;
  readonly life: LifeContext;
  readonly library: SessionLibrary;
  /** Updates the warnings of a session, without an announcement. */
  readonly recheck: (session: Session) => void;
}

/** Tells whether clients that joined with a grant still have access. */
export type HasAccess = (grantId: GrantId) => boolean;

const NO_REASON = 'One of its modules does not run. Open the session to see which one.';
const ACCESS_ENDED =
  'The invitation of the client that created or changed it has ended. Start it to run it again.';

/** Opens sessions that come back without a request, and reports how starting them went. */
export class RestoredSessions {
  readonly #context: RestoreContext;
  readonly #sessions: { readonly session: Session; readonly refusal: string | undefined }[] = [];
  #waiting: (() => void)[] = [];

  constructor(context: RestoreContext) {
    this.#context = context;
  }

  /** Starts the sessions that ran when the master ended [SE-24], except those of grants that have ended since. */
  restore(hasAccess: HasAccess): void {
    for (const message of this.#context.library.interrupted()) {
      const session = this.#reopen(message);
      this.#context.life.news.announceNew(session);
      this.#start(session, hasAccess);
    }
  }

  /**
   * Continues a session of a lost master, which this master owns now: starts it if it ran. [CU-32]
   *
   * @returns undefined when nothing is stored of it
   */
  takeOver(sessionId: string, hasAccess: HasAccess, move: SessionMove): Session | undefined {
    const { library, life, recheck } = this.#context;
    const message = library.interrupted().find(({ id }) => id === sessionId);
    if (message === undefined) return undefined;
    const session = this.#reopen(message, move);
    if (message.status === SessionStatus.RUNNING) this.#start(session, hasAccess);
    else {
      recheck(session);
      life.onModules.emit(session);
    }
    life.news.announceChange(session);
    return session;
  }

  #reopen(message: SessionMessage, move?: SessionMove): Session {
    const { library, requests, table } = this.#context;
    const session = new Session({
      id: message.id,
      masterId: table.masterId,
      move,
      message,
      modules: completeRequest(requests, message).modules,
      byteLength: encode('ubii.sessions.Session', message).byteLength,
      grantIds: toGrantIds(message.extension?.grantIds),
      isStored: library.get(message.name) !== undefined,
      revision: (message.extension?.revision ?? 0) + 1,
    });
    table.add(session);
    return session;
  }

  #start(session: Session, hasAccess: HasAccess): void {
    const { life, recheck } = this.#context;
    recheck(session);
    const mayRun = [...session.grantIds].every((grantId) => hasAccess(grantId));
    if (session.modules.length > 0 && mayRun) {
      session.markRestored();
      this.#sessions.push({ session, refusal: undefined });
      startSession(life, session);
      return;
    }
    this.#sessions.push({ session, refusal: mayRun ? 'It has no modules.' : ACCESS_ENDED });
    life.onModules.emit(session);
  }

  /** The state of a session changed. */
  handleLife(): void {
    if (this.#isUndecided) return;
    for (const resolve of this.#waiting) resolve();
    this.#waiting = [];
  }

  /** Settles when none of them is starting any more, at the latest after `startTimeoutMs` [SE-12]. */
  async report(): Promise<RestoreReport> {
    if (this.#isUndecided) await new Promise<void>((resolve) => this.#waiting.push(resolve));
    const running: string[] = [];
    const others: { name: string; reason: string }[] = [];
    for (const { session, refusal } of this.#sessions) {
      const isRunning = session.life === 'running' || session.life === 'paused';
      const reason = refusal ?? session.problems()[0]?.message ?? NO_REASON;
      if (isRunning) running.push(session.label);
      else others.push({ name: session.label, reason });
    }
    return { running, others };
  }

  get #isUndecided(): boolean {
    return this.#sessions.some(({ session }) => session.life === 'starting');
  }
}
