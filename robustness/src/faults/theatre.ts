import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { MasterProcess, type MasterStart } from '@ubii/harness';

import { pause } from '../pause.ts';
import type { Random } from '../random.ts';
import { Ledger, type Ask } from './ledger.ts';
import { Pulse } from './pulse.ts';
import { Scribe } from './scribe.ts';
import type { Outcome } from './story.ts';

/** Something is there to lose, however soon the fault comes. */
const TURNS_BEFORE = 20;

/** A master that is started again on the same port and data, with a workload that goes on meanwhile. */
export class Theatre {
  readonly ledger = new Ledger();
  readonly scribe: Scribe;
  readonly #folder: string;
  readonly master: MasterProcess;
  #pulse: Pulse | undefined;

  private constructor(folder: string, master: MasterProcess, random: Random, textLength?: number) {
    this.#folder = folder;
    this.master = master;
    this.scribe = new Scribe(random, this.ledger, this.ask, textLength);
  }

  static async open(
    start: MasterStart,
    random: Random,
    { textLength }: { textLength?: number } = {},
  ): Promise<Theatre> {
    const folder = mkdtempSync(join(tmpdir(), 'ubii-faults-'));
    const dataDir = start.dataDir ?? join(folder, 'data');
    const master = await MasterProcess.start({ ...start, dataDir });
    return new Theatre(folder, master, random, textLength);
  }

  /** Clients that publish and receive all the time. @param url where, when not at the master itself */
  async pulse(url = this.master.endpoints.url): Promise<Pulse> {
    return (this.#pulse ??= await Pulse.open(url));
  }

  readonly ask: Ask = (request) => this.master.ask(request);

  /** Lets the workload go on. @param ms milliseconds */
  async workFor(ms: number): Promise<void> {
    const endMs = performance.now() + ms;
    while (performance.now() < endMs) await this.scribe.turn();
  }

  /** Ends the master at a random moment of the workload, without a warning. */
  async killDuringWork(random: Random, withinMs: number): Promise<void> {
    for (let turns = 0; turns < TURNS_BEFORE; turns++) await this.scribe.turn();
    const killed = pause(random.below(withinMs)).then(() => this.master.kill());
    while (this.master.isRunning) await this.scribe.turn();
    await killed;
  }

  /** Changes that the master acknowledged and has lost, in words. */
  async findLosses(): Promise<string[]> {
    return [...(await this.ledger.findLosses(this.ask)), ...(this.#pulse?.findLosses() ?? [])];
  }

  outcome(
    losses: readonly string[],
    backMs: readonly number[],
    notes: readonly string[] = [],
  ): Outcome {
    const { acknowledged, refused } = this.scribe;
    return { acknowledged, refused, losses, backMs, notes };
  }

  async close(): Promise<void> {
    await this.#pulse?.close();
    await this.master.dispose();
    rmSync(this.#folder, { recursive: true, force: true });
  }
}
