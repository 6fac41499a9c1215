import type { Member } from './members.ts';

/** Time for which a lost master is remembered, milliseconds: as long as events. [EX-17] */
const KEPT_MS = 10 * 60_000;
/** Most lost masters remembered. */
const MAX_LOST = 32;

/** A master that was there. */
export interface LostMaster {
  readonly member: Member;
  /** It announced its end. */
  readonly hasEnded: boolean;
  /** Since when it is not there, epoch milliseconds. */
  readonly sinceMs: number;
}

/** Masters that were there a short time ago. [CU-72] */
export class LostMasters {
  readonly #lost = new Map<string, LostMaster>();

  add(lost: LostMaster): void {
    this.#lost.set(lost.member.id, lost);
    const [oldest] = this.#lost.keys();
    if (this.#lost.size > MAX_LOST) this.#lost.delete(oldest!);
  }

  /** It is there again. */
  delete(masterId: string): void {
    this.#lost.delete(masterId);
  }

  has(masterId: string): boolean {
    return this.#lost.has(masterId);
  }

  /** Those lost last come first. @param nowMs epoch milliseconds */
  list(nowMs: number): LostMaster[] {
    for (const [id, { sinceMs }] of this.#lost) {
      if (nowMs - sinceMs >= KEPT_MS) this.#lost.delete(id);
    }
    return [...this.#lost.values()].reverse();
  }
}
