/** Addresses that are remembered; the oldest ones are forgotten. */
const MAX_ADDRESSES = 256;

/** Addresses of all masters that this one has received a hello from since it started, also of lost ones. [CU-90] */
export class ClusterAddresses {
  readonly #addresses = new Set<string>();

  add(addresses: readonly string[]): void {
    for (const address of addresses) {
      this.#addresses.delete(address);
      this.#addresses.add(address);
    }
    for (const oldest of this.#addresses) {
      if (this.#addresses.size <= MAX_ADDRESSES) return;
      this.#addresses.delete(oldest);
    }
  }

  list(): string[] {
    return [...this.#addresses];
  }
}
