import type { OwnerStore } from '../../src/core/ports/index.ts';

export class MemoryOwners implements OwnerStore {
  readonly #owners = new Map<string, string>();
  owners(): ReadonlyMap<string, string> {
    return this.#owners;
  }
  claim(key: string, owner: string, from: string | undefined): Promise<boolean> {
    if (this.#owners.get(key) !== from) return Promise.resolve(false);
    this.#owners.set(key, owner);
    return Promise.resolve(true);
  }
  release(key: string, owner: string): Promise<void> {
    if (this.#owners.get(key) === owner) this.#owners.delete(key);
    return Promise.resolve();
  }
  onChange(): () => void {
    return () => {};
  }
  close(): void {}
}
