import { networkInterfaces } from 'node:os';
import type { NetworkInterfaceInfo } from 'node:os';

/** Asking the system takes longer than a request: what it said counts for so long, milliseconds. */
const FRESH_MS = 1_000;

/** The addresses of this computer, cached for a short time: networks change, and there are thousands of requests. */
export class OwnAddresses {
  readonly #nowMs: () => number;
  readonly #interfaces: () => NodeJS.Dict<NetworkInterfaceInfo[]>;
  #askedMs = Number.NEGATIVE_INFINITY;
  #addresses: ReadonlySet<string> = new Set();

  /** @param nowMs monotonic */
  constructor(nowMs = () => performance.now(), interfaces = networkInterfaces) {
    this.#nowMs = nowMs;
    this.#interfaces = interfaces;
  }

  /**
   * Whether a connection from this address comes from this machine. IPv6 link-local addresses are left
   * out: another machine may have the same one on another of our networks, and be answered there.
   *
   * @param address as `plainAddress` gives it
   */
  has(address: string): boolean {
    const nowMs = this.#nowMs();
    if (nowMs - this.#askedMs >= FRESH_MS) {
      this.#askedMs = nowMs;
      const all = Object.values(this.#interfaces()).flatMap((of = []) => of);
      this.#addresses = new Set(
        all.map(({ address: own }) => own).filter((own) => !/^fe[89ab][0-9a-f]:/i.test(own)),
      );
    }
    return this.#addresses.has(address);
  }
}
