/** How near an address is: this machine, a private or link-local network, or any other. */
export type AddressKind = 'loopback' | 'private' | 'public';
