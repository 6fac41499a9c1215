import { type CuttablePort, openCuttablePort } from '@ubii/harness';

import type { ClusterNetwork } from './cluster-network.ts';

/** Loopback, with a port for each master through which it reaches NATS. Clients still reach all masters. */
export class LoopbackNetwork implements ClusterNetwork {
  readonly about = 'on loopback: a partition cuts a master off from NATS, not from clients';
  readonly natsHost = '127.0.0.1';
  readonly listenFlags = ['--host', '127.0.0.1'];
  readonly #count: number;
  readonly #links: CuttablePort[] = [];

  /** @param count number of masters */
  constructor(count: number) {
    this.#count = count;
  }

  async openLinks(natsPort: number): Promise<void> {
    while (this.#links.length < this.#count) this.#links.push(await openCuttablePort(natsPort));
  }

  natsUrl(index: number): string {
    return `nats://127.0.0.1:${this.#links[index]!.port}`;
  }

  within(): readonly string[] {
    return [];
  }

  hostOf(): string {
    return '127.0.0.1';
  }

  cut(index: number): void {
    this.#links[index]!.cut();
  }

  heal(index: number): void {
    this.#links[index]!.heal();
  }

  async close(): Promise<void> {
    await Promise.all(this.#links.map((link) => link.close()));
  }
}
