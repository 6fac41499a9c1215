import { connect, createServer, type AddressInfo, type Server, type Socket } from 'node:net';

import { pause } from '../../pause.ts';
import type { Random } from '../../random.ts';
import { FaultRun, type Scenario } from '../fault-run.ts';

const WAITS_MS = [0, 0, 0, 5, 20, 80, 300];

/**
 * A relay to the master that behaves like a slow and lossy network: bytes are late and uneven (lost packets are sent
 * again), nothing passes for a while, or connections break.
 */
class RoughRelay {
  readonly #server: Server;
  readonly #sockets = new Set<Socket>();
  readonly #random: Random;
  #isSilent = false;

  private constructor(port: number, random: Random) {
    this.#random = random;
    this.#server = createServer((near) => {
      const far = connect(port, '127.0.0.1');
      this.#pass(near, far);
      this.#pass(far, near);
    });
  }

  static async open(port: number, random: Random): Promise<RoughRelay> {
    const relay = new RoughRelay(port, random);
    await new Promise<void>((resolve) => relay.#server.listen(0, '127.0.0.1', resolve));
    return relay;
  }

  get url(): string {
    return `http://localhost:${(this.#server.address() as AddressInfo).port}`;
  }

  /** While true nothing passes, and connections stay open. */
  set isSilent(isSilent: boolean) {
    this.#isSilent = isSilent;
  }

  /** Every connection breaks. */
  breakAll(): void {
    for (const socket of this.#sockets) socket.resetAndDestroy();
  }

  close(): void {
    this.#server.close();
    this.breakAll();
  }

  #pass(from: Socket, to: Socket): void {
    this.#sockets.add(from);
    let last = Promise.resolve();
    from.on('data', (chunk) => {
      // As on a network, what is late delays what comes after it, but delays do not add up.
      const dueMs = performance.now() + this.#random.pick(WAITS_MS);
      last = last.then(async () => {
        await this.#waitUntil(dueMs);
        if (!to.destroyed) to.write(chunk);
      });
    });
    from.on('end', () => void last.then(() => to.end()));
    from.on('error', () => to.destroy());
    from.on('close', () => {
      this.#sockets.delete(from);
      void last.then(() => to.destroy());
    });
  }

  async #waitUntil(dueMs: number): Promise<void> {
    for (;;) {
      const ms = this.#isSilent ? 20 : dueMs - performance.now();
      if (ms <= 0) return;
      await pause(ms);
    }
  }
}

const SILENCES_MS = [1_000, 4_000, 12_000];

export const roughNetwork: Scenario = {
  name: 'rough-network',
  about: 'clients behind a way that is late by up to 300 ms, goes silent, and breaks',
  async run({ program, random, times }) {
    const faultRun = await FaultRun.open({ program }, random);
    const relay = await RoughRelay.open(faultRun.master.port, random);
    const losses: string[] = [];
    const backMs: number[] = [];
    try {
      const heartbeat = await faultRun.heartbeat(relay.url);
      for (let index = 0; index < times; index++) {
        await faultRun.workFor(500);
        if (index % 2 === 0) {
          relay.isSilent = true;
          await pause(SILENCES_MS[(index / 2) % SILENCES_MS.length]!);
          relay.isSilent = false;
        } else relay.breakAll();
        backMs.push(await heartbeat.beat());
        losses.push(...(await faultRun.findLosses()));
      }
      return faultRun.outcome(losses, backMs);
    } finally {
      relay.close();
      await faultRun.close();
    }
  },
};
