import { fork, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';

import { dialLoopback, hasFlag, MasterProcess, Outsider, type MasterStart } from '@ubii/harness';
import type { AccessRole, AccessGrantCreated, AccessGrantCreateRequest, Init } from '@ubii/proto';

import { MASTER_V4, MASTER_V6, OUTSIDE_V4, OUTSIDE_V6, type Dialer } from './attack-network.ts';

const program = fileURLToPath(new URL('gap-process.ts', import.meta.url));
/** Time in which delayed records arrive. */
const CALM_MS = 1_500;

/** Publishes at 100 Hz in a process of its own, through the master, and measures the longest time without a record. */
class GapMeter {
  readonly #child: ChildProcess;

  private constructor(child: ChildProcess) {
    this.#child = child;
  }

  static async open(url: string): Promise<GapMeter> {
    const child = fork(program, [url], { execArgv: ['--import', import.meta.resolve('tsx')] });
    await once(child, 'message');
    return new GapMeter(child);
  }

  /** The longest time without a record, beyond the 10 ms between two, while something is done and shortly after. */
  async during(action: () => Promise<unknown>): Promise<number> {
    await this.#ask('begin');
    await action();
    await new Promise((resolve) => setTimeout(resolve, CALM_MS));
    return this.#ask('read');
  }

  close(): void {
    this.#child.kill('SIGKILL');
  }

  async #ask(word: string): Promise<number> {
    const answer = once(this.#child, 'message');
    this.#child.send(word);
    return (await answer)[0] as number;
  }
}

/** A build of the master, and callers at different addresses. Closes everything that it opened. */
export class AttackEnvironment {
  readonly program: string;
  /** Whether there is a second network namespace. Without one, callers come through a proxy on this machine. */
  readonly hasNetwork: boolean;
  readonly #dialer: Dialer;
  readonly #open: (() => Promise<void> | void)[] = [];

  constructor(program: string, dialer: Dialer, hasNetwork: boolean) {
    this.program = program;
    this.hasNetwork = hasNetwork;
    this.#dialer = dialer;
  }

  /** Starts a master that others can reach. */
  async startMaster(start: Partial<MasterStart> = {}): Promise<MasterProcess> {
    const master = await MasterProcess.start({ program: this.program, network: [], ...start });
    this.closeLater(() => master.dispose());
    return master;
  }

  knowsFlag(flag: string): boolean {
    return hasFlag(this.program, flag);
  }

  /** A caller of the network. @param index of the address; modulo their number */
  outsider({ port }: MasterProcess, index = 0, family: 4 | 6 = 4): Outsider {
    const addresses = family === 4 ? OUTSIDE_V4 : OUTSIDE_V6;
    const from = addresses[index % addresses.length]!;
    const host = family === 4 ? MASTER_V4 : MASTER_V6;
    if (this.hasNetwork) {
      return new Outsider({
        host,
        port,
        from,
        headers: {},
        dial: () => this.#dialer.dial(host, port, from),
      });
    }
    return new Outsider({
      host: '127.0.0.1',
      port,
      from,
      headers: { 'X-Forwarded-For': from },
      dial: () => this.#dialer.dial('127.0.0.1', port, from),
    });
  }

  /** A program or page of the operator's own machine. */
  insider({ port }: MasterProcess, headers: Readonly<Record<string, string>> = {}): Outsider {
    return new Outsider({
      host: 'localhost',
      port,
      from: '127.0.0.1',
      headers,
      dial: () => dialLoopback(port),
    });
  }

  async gapMeter({ endpoints }: MasterProcess): Promise<GapMeter> {
    const meter = await GapMeter.open(endpoints.url);
    this.closeLater(() => meter.close());
    return meter;
  }

  /** Makes an invitation, as the operator. */
  async invite(
    master: MasterProcess,
    role: AccessRole,
    wanted: Init<AccessGrantCreateRequest> = {},
  ): Promise<AccessGrantCreated> {
    const { accessGrantCreated } = await master.call({
      topic: '/services/ubii/access_grant_create',
      accessGrantCreateRequest: { role, ...wanted },
    });
    return accessGrantCreated!;
  }

  /** Registers a function that runs when the attack has ended. */
  closeLater(close: () => Promise<void> | void): void {
    this.#open.push(close);
  }

  /** Closes everything that the attack opened. */
  async clear(): Promise<void> {
    for (const close of this.#open.splice(0).reverse()) await close();
  }
}
