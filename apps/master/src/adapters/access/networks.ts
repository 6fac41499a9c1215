import { BlockList, isIP } from 'node:net';

/** Addresses and CIDR blocks, as options name them. [AC-4] [AC-41] */
export class Networks {
  readonly #list = new BlockList();

  /** @param networks as `parseNetworks` of the configuration lets them through */
  constructor(networks: readonly string[]) {
    for (const network of networks) {
      const [address = '', prefix] = network.split('/');
      const family = isIP(address) === 6 ? 'ipv6' : 'ipv4';
      if (prefix === undefined) this.#list.addAddress(address, family);
      else this.#list.addSubnet(address, Number(prefix), family);
    }
  }

  /** @param address as `plainAddress` gives it */
  has(address: string): boolean {
    const version = isIP(address);
    return version !== 0 && this.#list.check(address, version === 6 ? 'ipv6' : 'ipv4');
  }
}
