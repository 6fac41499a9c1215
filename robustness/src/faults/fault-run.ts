import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { MasterProcess, type MasterStart } from '@ubii/harness';

import { pause } from '../pause.ts';
import type { Random } from '../random.ts';
import { ExpectedState, type Ask } from './expected-state.ts';
import { Heartbeat } from './heartbeat.ts';
import { Workload } from './workload.ts';
import type { Outcome } from './scenario.ts';

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
