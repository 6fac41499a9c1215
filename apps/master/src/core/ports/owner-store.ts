import type { Cancel } from '@ubii/timing';

/** Owners of sessions, decided in one place for all masters of a cluster. Kept when all masters end. */
export interface OwnerStore {
  /** Master ids by key, as far as this master knows by now. */
  owners(): ReadonlyMap<string, string>;
  /**
   * Takes a key for `owner`, if it is still owned as `from` says; undefined: without an owner.
   *
   * @returns false when another master was faster
   * @throws Error with the reason when the store cannot be reached
   */
  claim(key: string, owner: string, from: string | undefined): Promise<boolean>;
  /** Gives a key up that `owner` has. Does nothing when another master has it. @throws Error as `claim` */
  release(key: string, owner: string): Promise<void>;
  /** Calls `fn` with the keys whose owner changed, also by this master. */
  onChange(fn: (keys: readonly string[]) => void): Cancel;
  /** Ends the watching. */
  close(): void;
}
