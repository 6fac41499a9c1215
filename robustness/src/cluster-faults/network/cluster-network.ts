import { openCuttablePort, type CuttablePort } from '@ubii/harness';

/** Network between the masters of a run, whose links can be cut. */
export interface ClusterNetwork {
  /** In words, for the report. */
  readonly about: string;
  /** Address on which NATS listens. */
  readonly natsHost: string;
  /** Opens the links to NATS; called before `natsUrl`. */
  openLinks(natsPort: number): Promise<void>;
  /** NATS as a master reaches it. @param index of the master */
  natsUrl(index: number): string;
  /** Command that starts a program on the machine of this master. */
  within(index: number): readonly string[];
  /** Address by which clients reach a master. */
  hostOf(index: number): string;
  /** Flags of a master that say where it listens. */
  readonly listenFlags: readonly string[];
  /** Cuts a master, with the clients of its machine, off from NATS and the other masters. */
  cut(index: number): void;
  heal(index: number): void;
  close(): Promise<void>;
}

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
