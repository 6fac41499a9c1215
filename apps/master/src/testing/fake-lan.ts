import type { Lan } from '../core/ports/lan.ts';

/** A local network that is turned on in memory. */
export class FakeLan implements Lan {
  isOpen = false;
  /** Why it cannot be turned on; undefined: it can. */
  problem: string | undefined;

  open(): Promise<void> {
    if (this.problem !== undefined) return Promise.reject(new Error(this.problem));
    this.isOpen = true;
    return Promise.resolve();
  }
}
