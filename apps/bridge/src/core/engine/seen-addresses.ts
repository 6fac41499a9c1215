import type { ForeignSystem } from '../ports/foreign-system.ts';

/** Addresses that are remembered; beyond, the oldest is forgotten. */
const REMEMBERED = 2_000;

/** Addresses of the other system at which messages came, for previews of mappings. [BR-81] */
export class SeenAddresses {
  readonly #addresses = new Set<string>();

  /** The system, with each message noted that it hands over. */
  watch<P>(system: ForeignSystem<P>): ForeignSystem<P> {
    return {
      open: (events) =>
        system.open({
          handleMessage: (message) => {
            this.#note(message.address);
            events.handleMessage(message);
          },
          handleRefused: (reason) => events.handleRefused(reason),
          handleDropped: (mapping, reason) => events.handleDropped(mapping, reason),
          handleState: (state) => events.handleState(state),
          handleSettled: () => events.handleSettled(),
        }),
      setMappings: (mappings) => system.setMappings(mappings),
      send: (message) => system.send(message),
      setAvailable: (isAvailable) => system.setAvailable(isAvailable),
      close: () => system.close(),
    };
  }

  list(): readonly string[] {
    return [...this.#addresses];
  }

  #note(address: string): void {
    if (this.#addresses.has(address)) return;
    this.#addresses.add(address);
    if (this.#addresses.size <= REMEMBERED) return;
    const [oldest] = this.#addresses;
    if (oldest !== undefined) this.#addresses.delete(oldest);
  }
}
