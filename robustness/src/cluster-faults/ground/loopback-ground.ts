import { type CuttablePort, openCuttablePort } from '@ubii/harness';

import type { Ground } from './ground.ts';

/** All on loopback, with a port for each master that its way to NATS goes through. Clients still reach all masters. */
export class LoopbackGround implements Ground {
  readonly about = 'on loopback: a partition cuts a master off from NATS, not from clients';
  readonly natsHost = '127.0.0.1';
  readonly network = ['--host', '127.0.0.1'];
  readonly #count: number;
  readonly #ways: CuttablePort[] = [];

  /** @param count number of masters */
  constructor(count: number) {
    this.#count = count;
  }

  async openWays(natsPort: number): Promise<void> {
    while (this.#ways.length < this.#count) this.#ways.push(await openCuttablePort(natsPort));
  }

  natsUrl(index: number): string {
    return `nats://127.0.0.1:${this.#ways[index]!.port}`;
  }

  within(): readonly string[] {
    return [];
  }

  hostOf(): string {
    return '127.0.0.1';
  }

  cut(index: number): void {
    this.#ways[index]!.cut();
  }

  heal(index: number): void {
    this.#ways[index]!.heal();
  }

  async close(): Promise<void> {
    await Promise.all(this.#ways.map((way) => way.close()));
  }
}
