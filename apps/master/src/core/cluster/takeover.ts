import { INFO_TOPICS, StatusEventKind } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { Grants } from '../access/grants.ts';
import type { EventLog } from '../counters/event-log.ts';
import type { MasterPublisher } from '../info/master-publisher.ts';
import type { Log } from '../ports/log.ts';
import type { OwnerStore } from '../ports/owner-store.ts';
import type { ForeignSessions } from '../sessions/foreign-sessions.ts';
import type { SessionClaims } from '../sessions/session-claims.ts';
import type { SessionLibrary } from '../sessions/session-library.ts';
import type { SessionTable } from '../sessions/session-table.ts';
import type { Sessions } from '../sessions/sessions.ts';
import { quote } from '../texts/quote.ts';
import { LOST_MS, type Members } from './members.ts';

/** Time by which each further candidate waits for the one before it, milliseconds. */
const STAGGER_MS = 300;
/** Time in which what is stored of an owned session has to be found, milliseconds. */
const MISSING_MS = 10_000;
/** Interval at which what could not be stored or claimed is tried again, milliseconds. */
const RETRY_MS = 2_000;

/** Dependencies of taking over. */
export interface TakeoverContext {
  readonly id: string;
  readonly clock: Clock;
  readonly log: Log;
  readonly owners: OwnerStore;
  readonly claims: SessionClaims;
  readonly sessions: Sessions;
  readonly sessionTable: SessionTable;
  readonly sessionLibrary: Pick<SessionLibrary, 'rememberUnsaved'>;
  readonly foreignSessions: ForeignSessions;
  readonly events: EventLog;
  readonly grants: Pick<Grants, 'isValid'>;
  readonly publisher: Pick<MasterPublisher, 'publish'>;
}

/** Sessions continue at another master when theirs is lost. [CU-32] */
export class Takeover {
  readonly #context: TakeoverContext;
  readonly #members: Members;
  /** Silent owners, with the time since when; monotonic milliseconds. */
  readonly #silent = new Map<string, number>();
  /** Names of masters that own sessions, or did. */
  readonly #names = new Map<string, string>();
  readonly #claiming = new Set<string>();
  /** Owned sessions of which nothing is stored, with the time since when. */
  readonly #missing = new Map<string, number>();
  #reachableSinceMs: number | undefined = undefined;
  #retriedMs = Number.NEGATIVE_INFINITY;

  constructor(context: TakeoverContext, members: Members) {
    this.#context = context;
    this.#members = members;
    members.onJoined.add(({ id, name }) => {
      this.#names.set(id, name);
      this.#silent.delete(id);
    });
    context.owners.onChange((keys) => {
      for (const key of keys) this.#giveUpIfLost(key);
    });
  }

  handleReach(isReachable: boolean): void {
    this.#reachableSinceMs = isReachable ? this.#context.clock.monotonicMs() : undefined;
    this.#silent.clear();
    if (!isReachable) return;
    for (const key of this.#context.owners.owners().keys()) this.#giveUpIfLost(key);
  }

  /** A master ended, or was silent for long enough to count as down. */
  handleLost(masterId: string): void {
    this.#silent.set(masterId, this.#context.clock.monotonicMs() - LOST_MS);
    this.look();
  }

  /** Takes over sessions without an owner, and applies changes of the store to own sessions. To be called about twice a second. */
  look(): void {
    const { clock, owners, id: ownId } = this.#context;
    const nowMs = clock.monotonicMs();
    // A master that was cut off first learns which masters are there.
    if (this.#reachableSinceMs === undefined || nowMs - this.#reachableSinceMs < LOST_MS) return;
    const ownerIds = new Set<string>();
    for (const [key, ownerId] of owners.owners()) {
      ownerIds.add(ownerId);
      if (ownerId === ownId) this.#continueIfIdle(key, nowMs);
      else if (this.#members.get(ownerId) === undefined) this.#claimIfDue(key, ownerId, nowMs);
    }
    this.#forgetOthers(ownerIds);
    this.#endUnowned();
    if (nowMs - this.#retriedMs < RETRY_MS) return;
    this.#retriedMs = nowMs;
    this.#retry();
  }

  #claimIfDue(key: string, ownerId: string, nowMs: number): void {
    const sinceMs = this.#silent.get(ownerId) ?? nowMs;
    this.#silent.set(ownerId, sinceMs);
    const waitMs = LOST_MS + STAGGER_MS * this.#rankFor(key);
    if (nowMs - sinceMs >= waitMs && !this.#claiming.has(key)) void this.#claim(key, ownerId);
  }

  async #claim(key: string, from: string): Promise<void> {
    const { owners, id, log } = this.#context;
    this.#claiming.add(key);
    try {
      if (await owners.claim(key, id, from)) this.#continue(key, from);
    } catch (error) {
      // If it was taken anyway, `look` finds it.
      log.warn('a session could not be taken over', { session: key, reason: String(error) });
    } finally {
      this.#claiming.delete(key);
    }
  }

  /** A session that is this master's and that it does not run, after a claim whose answer was lost. */
  #continueIfIdle(key: string, nowMs: number): void {
    const { sessionTable, claims } = this.#context;
    if (sessionTable.get(key) !== undefined || claims.isReleasing(key)) {
      this.#missing.delete(key);
      return;
    }
    const sinceMs = this.#missing.get(key) ?? nowMs;
    this.#missing.set(key, sinceMs);
    // One that is being opened is there in a moment.
    if (nowMs - sinceMs < LOST_MS || this.#continue(key, '')) return;
    if (nowMs - sinceMs < MISSING_MS) return;
    this.#missing.delete(key);
    claims.release(key);
  }

  /** @returns false when nothing is stored of it, or not yet */
  #continue(sessionId: string, from: string): boolean {
    const { clock, sessions, foreignSessions, grants, events } = this.#context;
    const name = this.#names.get(from);
    const move = { from: name, atMs: clock.nowMs() };
    const session = sessions.restored.takeOver(
      sessionId,
      (grantId) => grants.isValid(grantId),
      move,
    );
    if (session === undefined) return false;
    foreignSessions.forget(sessionId);
    this.#missing.delete(sessionId);
    const whose = name === undefined ? 'its master' : `its master ${quote(name)}`;
    events.add(
      StatusEventKind.SESSION_MOVED,
      `The session ${quote(session.label)} continues here: ${whose} is lost`,
    );
    return true;
  }

  /** Another master took a session over while this one was not reachable. [CU-34] */
  #giveUpIfLost(sessionId: string): void {
    const { sessionTable, sessions, owners, events, foreignSessions, publisher, id } =
      this.#context;
    const session = sessionTable.get(sessionId);
    const ownerId = owners.owners().get(sessionId);
    if (session === undefined || ownerId === undefined || ownerId === id) return;
    sessions.giveUp(session);
    const known = foreignSessions.get(sessionId);
    if (known !== undefined) publisher.publish(INFO_TOPICS.changeSession, { session: known });
    const name = this.#names.get(ownerId) ?? ownerId;
    events.add(
      StatusEventKind.SESSION_MOVED,
      `The session ${quote(session.label)} ended here: the master ${quote(name)} took it over while this one could not be reached`,
    );
  }

  /** Removes sessions that a lost master announced and that have no owner. */
  #endUnowned(): void {
    const { foreignSessions, owners, publisher } = this.#context;
    for (const [id, masterId] of foreignSessions.masters()) {
      if (this.#members.get(masterId) !== undefined || owners.owners().has(id)) continue;
      const session = foreignSessions.get(id)!;
      foreignSessions.forget(id);
      publisher.publish(INFO_TOPICS.deleteSession, { session });
    }
  }

  #retry(): void {
    const { claims, sessionTable, sessionLibrary } = this.#context;
    sessionLibrary.rememberUnsaved();
    claims.retry([...sessionTable.values()].map(({ id }) => id));
    for (const { id } of [...sessionTable.values()]) this.#giveUpIfLost(id);
  }

  /** Masters that own nothing any more need not be remembered. */
  #forgetOthers(ownerIds: ReadonlySet<string>): void {
    for (const id of this.#silent.keys()) if (!ownerIds.has(id)) this.#silent.delete(id);
    for (const id of this.#names.keys()) {
      if (!ownerIds.has(id) && this.#members.get(id) === undefined) this.#names.delete(id);
    }
  }

  /** Place of this master among those that may take a session: each session has another order. */
  #rankFor(key: string): number {
    const { id } = this.#context;
    const own = weight(key, id);
    return this.#members.list().filter((member) => weight(key, member.id) > own).length;
  }
}

/** A number that is spread evenly over pairs of texts (FNV-1a). */
function weight(key: string, masterId: string): number {
  let hash = 0x811c9dc5;
  for (const character of key + masterId) {
    hash = Math.imul(hash ^ character.codePointAt(0)!, 0x01000193) >>> 0;
  }
  return hash;
}
