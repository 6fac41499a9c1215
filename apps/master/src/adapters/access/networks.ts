import { BlockList, isIP } from 'node:net';

/** Addresses and CIDR blocks, as options name them. [AC-4] [AC-41] */
export class Networks {
  readonly #list = new BlockList();
  /** Most masters are given none, and ask for each request. */
  readonly #isEmpty: boolean;

  /** @param networks as `parseNetworks` of the configuration lets them through */
  constructor(networks: readonly string[]) {
    this.#isEmpty = networks.length === 0;
    for (const network of networks) {
      const [address = '', prefix] = network.split('/');
      const family = isIP(address) === 6 ? 'ipv6' : 'ipv4';
      if (prefix === undefined) this.#list.addAddress(address, family);
      else this.#list.addSubnet(address, Number(prefix), family);
    }
  }

  /** @param address as `plainAddress` gives it */
  has(address: string): boolean {
    if (this.#isEmpty) return false;
    const version = isIP(address);
    return version !== 0 && this.#list.check(address, version === 6 ? 'ipv6' : 'ipv4');
  }
}
