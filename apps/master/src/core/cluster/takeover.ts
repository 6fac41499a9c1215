import { StatusEventKind } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { Grants } from '../access/grants.ts';
import type { EventLog } from '../counters/event-log.ts';
import type { Log } from '../ports/log.ts';
import type { OwnerStore } from '../ports/owner-store.ts';
import type { ForeignSessions } from '../sessions/foreign-sessions.ts';
import type { SessionTable } from '../sessions/session-table.ts';
import type { Sessions } from '../sessions/sessions.ts';
import { quote } from '../texts/quote.ts';
import { LOST_MS, type Members } from './members.ts';

/** Time by which each further candidate waits for the one before it, milliseconds. */
const STAGGER_MS = 300;

/** Dependencies of taking over. */
export interface TakeoverContext {
  readonly id: string;
  readonly clock: Clock;
  readonly log: Log;
  readonly owners: OwnerStore;
  readonly sessions: Sessions;
  readonly sessionTable: SessionTable;
  readonly foreignSessions: ForeignSessions;
  readonly events: EventLog;
  readonly grants: Pick<Grants, 'isGood'>;
}

/** Sessions go on at another master when theirs is lost. [CU-32] */
export class Takeover {
  readonly #context: TakeoverContext;
  readonly #members: Members;
  /** Owners that are not heard, with the time since when; monotonic milliseconds. */
  readonly #silent = new Map<string, number>();
  /** Names of masters that were heard once. */
  readonly #names = new Map<string, string>();
  readonly #claiming = new Set<string>();
  #reachableSinceMs: number | undefined = undefined;

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

  /** A master ended, or was not heard for long enough: it is known to be gone. */
  handleLost(masterId: string): void {
    this.#silent.set(masterId, this.#context.clock.monotonicMs() - LOST_MS);
    this.look();
  }

  /** Takes over what nobody runs. To be called about twice a second. */
  look(): void {
    const { clock, owners, id: ownId } = this.#context;
    const nowMs = clock.monotonicMs();
    // Who was apart first hears who is there.
    if (this.#reachableSinceMs === undefined || nowMs - this.#reachableSinceMs < LOST_MS) return;
    for (const [key, ownerId] of owners.owners()) {
      if (ownerId === ownId || this.#members.get(ownerId) !== undefined) continue;
      const sinceMs = this.#silent.get(ownerId) ?? nowMs;
      this.#silent.set(ownerId, sinceMs);
      const waitMs = LOST_MS + STAGGER_MS * this.#rankFor(key);
      if (nowMs - sinceMs >= waitMs && !this.#claiming.has(key)) void this.#claim(key, ownerId);
    }
  }

  async #claim(key: string, from: string): Promise<void> {
    const { owners, id, log } = this.#context;
    this.#claiming.add(key);
    try {
      if (await owners.claim(key, id, from)) this.#goOn(key, from);
    } catch (error) {
      log.warn('a session could not be taken over', { session: key, reason: String(error) });
    } finally {
      this.#claiming.delete(key);
    }
  }

  #goOn(sessionId: string, from: string): void {
    const { sessions, foreignSessions, grants, events, owners, id, log } = this.#context;
    foreignSessions.delete(from, sessionId);
    const session = sessions.takeOver(sessionId, (grantId) => grants.isGood(grantId));
    if (session === undefined) {
      // It was removed while its master ended.
      owners.release(sessionId, id).catch((error: unknown) => {
        log.warn('a session could not be given up', { session: sessionId, reason: String(error) });
      });
      return;
    }
    const name = this.#names.get(from);
    const whose = name === undefined ? 'its master' : `its master ${quote(name)}`;
    events.add(
      StatusEventKind.SESSION_MOVED,
      `The session ${quote(session.label)} goes on here: ${whose} is lost`,
    );
  }

  /** Another master took a session over while this one could not be heard. [CU-34] */
  #giveUpIfLost(sessionId: string): void {
    const { sessionTable, sessions, owners, events, id } = this.#context;
    const session = sessionTable.get(sessionId);
    const ownerId = owners.owners().get(sessionId);
    if (session === undefined || ownerId === undefined || ownerId === id) return;
    sessions.giveUp(session);
    const name = this.#names.get(ownerId) ?? ownerId;
    events.add(
      StatusEventKind.SESSION_MOVED,
      `The session ${quote(session.label)} ended here: the master ${quote(name)} took it over while this one could not be reached`,
    );
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
