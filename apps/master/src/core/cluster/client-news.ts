import type { Cancel, Clock } from '@ubii/timing';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { Client } from '../clients/client.ts';

/** Time in which changes of clients are collected, milliseconds. */
const NEWS_MS = 20;

/** Dependencies of news of clients. */
export interface ClientNewsContext {
  readonly clock: Clock;
  readonly clients: ClientRegistry;
  readonly send: (changed: readonly Client[], goneIds: readonly string[]) => void;
}

/** Collects what became of clients of this master, for the others. [CU-20] */
export class ClientNews {
  readonly #context: ClientNewsContext;
  readonly #ids = new Set<string>();
  #cancel: Cancel | undefined = undefined;

  constructor(context: ClientNewsContext) {
    this.#context = context;
  }

  /** The client came, changed or left. */
  note(clientId: string): void {
    this.#ids.add(clientId);
    this.#cancel ??= this.#context.clock.after(NEWS_MS, () => this.#send());
  }

  close(): void {
    this.#cancel?.();
  }

  #send(): void {
    this.#cancel = undefined;
    const { clients, send } = this.#context;
    const changed: Client[] = [];
    const gone: string[] = [];
    for (const id of this.#ids) {
      const client = clients.get(id);
      if (client === undefined) gone.push(id);
      else if (client.home === undefined) changed.push(client);
    }
    this.#ids.clear();
    if (changed.length + gone.length > 0) send(changed, gone);
  }
}
