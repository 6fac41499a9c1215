import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { createClient, type UbiiClient } from '@ubii/client-web/node';
import { MasterProcess, type MasterStart } from '@ubii/harness';

import { pause } from '../pause.ts';
import type { Random } from '../random.ts';
import { ExpectedState, type Ask } from './expected-state.ts';
import { Workload } from './workload.ts';

/** Parameters of a scenario. */
export interface ScenarioOptions {
  /** Main file of a built master, and of a built node. */
  readonly program: string;
  readonly node: string;
  readonly random: Random;
  /** Number of faults; longer runs have more. */
  readonly times: number;
}

/** Result of a scenario. */
export interface Outcome {
  /** Requests that the master acknowledged, and that it refused or did not answer. */
  readonly acknowledged: number;
  readonly refused: number;
  /** Acknowledged changes that the master lost, in words; there may be none. */
  readonly losses: readonly string[];
  /** Time until everything was back, for each fault, milliseconds. */
  readonly backMs: readonly number[];
  /** Further observations. */
  readonly notes: readonly string[];
}

/** One kind of fault, injected several times during a workload. */
export interface Scenario {
  /** For `--only`. */
  readonly name: string;
  readonly about: string;
  /** Why it cannot be tried here; undefined: it can. */
  reasonAgainst?(): string | undefined;
  run(stage: ScenarioOptions): Promise<Outcome>;
}

const PERIOD_MS = 20;
const TIMEOUT_MS = 60_000;

/**
 * One client that publishes numbers all the time, and one that receives them. Numbers may be lost while there is no
 * master, and may never arrive out of order.
 */
class Heartbeat {
  readonly #publisher: UbiiClient;
  readonly #subscriber: UbiiClient;
  readonly #timer: NodeJS.Timeout;
  readonly #ids: readonly (string | undefined)[];
  #sent = 0;
  #received = 0;
  #disorder = 0;

  private constructor(publisher: UbiiClient, subscriber: UbiiClient, topic: string) {
    this.#publisher = publisher;
    this.#subscriber = subscriber;
    this.#ids = [publisher.id, subscriber.id];
    this.#timer = setInterval(() => publisher.publish(topic, 'double', ++this.#sent), PERIOD_MS);
  }

  static async open(url: string): Promise<Heartbeat> {
    const publisher = createClient({ url, name: 'heartbeat, publisher', publishIntervalMs: 0 });
    const subscriber = createClient({ url, name: 'heartbeat, subscriber' });
    await Promise.all([publisher.connect(), subscriber.connect()]);
    const topic = `/${publisher.id}/heartbeat`;
    const heartbeat = new Heartbeat(publisher, subscriber, topic);
    const subscription = subscriber.subscribe(topic, { format: 'double' });
    // The retained record comes again after a reconnect: the same number is no disorder, an older one is.
    subscription.onRecord(({ value }) => {
      if (value < heartbeat.#received) heartbeat.#disorder++;
      heartbeat.#received = Math.max(heartbeat.#received, value);
    });
    await subscription.ready;
    await heartbeat.beat();
    return heartbeat;
  }

  /** Waits for a number that is published from now on. @returns how long it took, ms @throws Error after a minute */
  async beat(): Promise<number> {
    const begunMs = performance.now();
    const after = this.#sent;
    while (this.#received <= after) {
      if (performance.now() - begunMs > TIMEOUT_MS) {
        throw new Error('Records of the clients did not come back within a minute.');
      }
      await pause(5);
    }
    return performance.now() - begunMs;
  }

  /** Lost records and disorder, in words. */
  findLosses(): readonly string[] {
    const losses: string[] = [];
    if (this.#disorder > 0) losses.push(`${this.#disorder} records came after newer ones`);
    const ids = [this.#publisher.id, this.#subscriber.id];
    if (ids.some((id, index) => id !== this.#ids[index])) {
      losses.push('a client reconnected with another id');
    }
    return losses;
  }

  async close(): Promise<void> {
    clearInterval(this.#timer);
    await Promise.allSettled([this.#publisher.close(), this.#subscriber.close()]);
  }
}

/** Requests before a fault, so that there is state to lose. */
const STEPS_BEFORE = 20;

/** A master under faults, with a workload, the state that it must keep, and clients that publish all the time. */
export class FaultRun {
  readonly expected = new ExpectedState();
  readonly workload: Workload;
  readonly #folder: string;
  readonly master: MasterProcess;
  #heartbeat: Heartbeat | undefined;

  private constructor(folder: string, master: MasterProcess, random: Random, textLength?: number) {
    this.#folder = folder;
    this.master = master;
    this.workload = new Workload(random, this.expected, this.ask, textLength);
  }

  static async open(
    start: MasterStart,
    random: Random,
    { textLength }: { textLength?: number } = {},
  ): Promise<FaultRun> {
    const folder = mkdtempSync(join(tmpdir(), 'ubii-faults-'));
    const dataDir = start.dataDir ?? join(folder, 'data');
    const master = await MasterProcess.start({ ...start, dataDir });
    return new FaultRun(folder, master, random, textLength);
  }

  /** Starts the clients that publish and receive all the time. @param url where, when not at the master itself */
  async heartbeat(url = this.master.endpoints.url): Promise<Heartbeat> {
    return (this.#heartbeat ??= await Heartbeat.open(url));
  }

  readonly ask: Ask = (request) => this.master.ask(request);

  /** Runs the workload. @param ms milliseconds */
  async workFor(ms: number): Promise<void> {
    const endMs = performance.now() + ms;
    while (performance.now() < endMs) await this.workload.step();
  }

  /** Ends the master at a random moment of the workload, without a warning. */
  async killDuringWork(random: Random, withinMs: number): Promise<void> {
    for (let steps = 0; steps < STEPS_BEFORE; steps++) await this.workload.step();
    const killed = pause(random.below(withinMs)).then(() => this.master.kill());
    while (this.master.isRunning) await this.workload.step();
    await killed;
  }

  /** Changes that the master acknowledged and has lost, in words. */
  async findLosses(): Promise<string[]> {
    return [
      ...(await this.expected.findLosses(this.ask)),
      ...(this.#heartbeat?.findLosses() ?? []),
    ];
  }

  outcome(
    losses: readonly string[],
    backMs: readonly number[],
    notes: readonly string[] = [],
  ): Outcome {
    const { acknowledged, refused } = this.workload;
    return { acknowledged, refused, losses, backMs, notes };
  }

  async close(): Promise<void> {
    await this.#heartbeat?.close();
    await this.master.dispose();
    rmSync(this.#folder, { recursive: true, force: true });
  }
}
