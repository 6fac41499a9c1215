/** Kind of an address: this computer, a private or link-local network, or any other. */
export type AddressKind = 'loopback' | 'private' | 'public';
