import { MasterProcess } from '@ubii/harness';

import { Witness } from '../fixtures/witness.ts';
import { Random } from '../random.ts';
import type { Find } from './corpus.ts';
import type { Entrance, FuzzTarget } from './entrance.ts';

/** A master with pages and ten thousand topics takes some 200 MiB; what grows with every input passes this soon. */
const MAX_RESIDENT_BYTES = 700 * 1024 * 1024;

/** A master under test with a witness: a client pair that must not notice what is delivered. */
export class MonitoredMaster {
  readonly master: MasterProcess;
  readonly witness: Witness;
  #target: FuzzTarget;

  private constructor(master: MasterProcess, witness: Witness, target: FuzzTarget) {
    this.master = master;
    this.witness = witness;
    this.#target = target;
  }

  static async open(program: string): Promise<MonitoredMaster> {
    const master = await MasterProcess.start({ program });
    try {
      const witness = await Witness.open(master.endpoints.url);
      return new MonitoredMaster(master, witness, await targetOf(master));
    } catch (error) {
      await master.dispose();
      throw error;
    }
  }

  /** Delivers an input; again with a new client when the master removed the fuzzer's own. */
  async deliver(entrance: Entrance, input: Uint8Array): Promise<void> {
    try {
      await entrance.deliver(input, this.#target);
    } catch {
      if (!this.master.isRunning) throw new Error(`The master has ended.\n${tail(this.master)}`);
      this.#target = await targetOf(this.master);
      await entrance.deliver(input, this.#target);
    }
  }

  /** Checks process, witness, health, log and memory. @throws Error that names the problem */
  async check(): Promise<void> {
    const { master, witness } = this;
    if (!master.isRunning) throw new Error(`The master has ended.\n${tail(master)}`);
    await witness.check();
    const { status } = await fetch(new URL('/health', master.endpoints.url));
    if (status !== 200) throw new Error(`/health answers with ${status}.`);
    if (master.failures.length > 0) {
      throw new Error(`The master logged:\n${master.failures.slice(0, 12).join('\n')}`);
    }
    const { residentBytes = 0 } = master.figures();
    if (residentBytes > MAX_RESIDENT_BYTES) {
      throw new Error(`The master has ${Math.round(residentBytes / 1024 / 1024)} MiB resident.`);
    }
  }

  async close(): Promise<void> {
    await this.witness.close();
    await this.master.dispose();
  }
}

async function targetOf(master: MasterProcess): Promise<FuzzTarget> {
  const { client } = await master.call({
    topic: '/services/client/registration',
    client: { name: 'fuzzer', extension: {} },
  });
  return {
    program: master.program,
    master,
    clientId: client!.id,
    resumeToken: client!.extension!.resumeToken,
  };
}

function tail(master: MasterProcess): string {
  return master.log.slice(-12).join('\n');
}

/** Number of inputs between two checks of the master. */
const BATCH = 24;
/** Number of inputs in parallel; a page may open no more sockets before it joins. */
const AT_ONCE = 6;
/**
 * Number of inputs for one master; a new one starts without the clients, topics and sessions that inputs may create.
 */
const NEW_MASTER_AFTER = 4_000;
/** Another kind of number for each case, so that cases do not depend on one another. */
const CASE_STEP = 0x9e3779b1;

export interface FuzzPlan {
  readonly program: string;
  readonly seed: number;
  /** The greatest number of inputs. */
  readonly maxCases: number;
  /** Whether there is time for more. */
  readonly goesOn: () => boolean;
  readonly onFind: (find: Find) => void;
}

export interface FuzzResult {
  readonly entrance: string;
  readonly cases: number;
  readonly finds: number;
  /** Longest round trip of the witness, milliseconds; 0 without one. */
  readonly longestMs: number;
}

/** The input of a number: the same for the same seed, whatever came before. */
export function caseOf(
  entrance: Entrance,
  seeds: readonly Uint8Array[],
  seed: number,
  index: number,
): Uint8Array {
  const random = new Random(seed + Math.imul(index + 1, CASE_STEP));
  return entrance.mutate(random, random.pick(seeds), random.pick(seeds));
}

/** Delivers mutated inputs to one entrance until there is no time left. */
export async function fuzzEntrance(entrance: Entrance, plan: FuzzPlan): Promise<FuzzResult> {
  const run = { cases: 0, finds: 0, longestMs: 0 };
  const seeds = entrance.seeds();
  const found = (reason: unknown, inputs: readonly Uint8Array[]): void => {
    run.finds += 1;
    plan.onFind({
      entrance: entrance.name,
      reason: reason instanceof Error ? reason.message : String(reason),
      inputs: inputs.map((input) => Buffer.from(input).toString('base64')),
    });
  };
  const hasMore = (): boolean => run.cases < plan.maxCases && plan.goesOn();
  const nextCase = (): Uint8Array => caseOf(entrance, seeds, plan.seed, run.cases++);
  if (entrance.kind === 'running') {
    while (hasMore()) await fuzzOneMaster(entrance, plan, run, { hasMore, nextCase, found });
  } else {
    const target = { program: plan.program } as FuzzTarget;
    while (hasMore()) {
      const input = nextCase();
      await entrance.deliver(input, target).catch((error: unknown) => found(error, [input]));
    }
  }
  return { entrance: entrance.name, ...run };
}

interface Feed {
  hasMore(): boolean;
  nextCase(): Uint8Array;
  found(reason: unknown, inputs: readonly Uint8Array[]): void;
}

/** Until something is found, or this master has had enough. */
async function fuzzOneMaster(
  entrance: Entrance,
  { program }: FuzzPlan,
  run: { longestMs: number },
  { hasMore, nextCase, found }: Feed,
): Promise<void> {
  const monitored = await MonitoredMaster.open(program);
  let batch: Uint8Array[] = [];
  try {
    for (let count = 0; count < NEW_MASTER_AFTER && hasMore(); count += batch.length) {
      batch = [];
      while (batch.length < BATCH && hasMore()) batch.push(nextCase());
      for (let at = 0; at < batch.length; at += AT_ONCE) {
        const together = batch.slice(at, at + AT_ONCE);
        await Promise.all(together.map((input) => monitored.deliver(entrance, input)));
      }
      await monitored.check();
    }
  } catch (error) {
    found(error, await narrow(entrance, program, batch));
  } finally {
    run.longestMs = Math.max(run.longestMs, monitored.witness.longestMs);
    await monitored.close();
  }
}

/** The one input of a batch that does harm alone; the whole batch when it takes more than one. */
async function narrow(
  entrance: Entrance,
  program: string,
  batch: readonly Uint8Array[],
): Promise<readonly Uint8Array[]> {
  for (const input of [...batch].reverse()) {
    if ((await replay(entrance, program, [input])) !== undefined) return [input];
  }
  return batch;
}

/** Delivers inputs to a new master. @returns what went wrong; undefined when nothing did */
export async function replay(
  entrance: Entrance,
  program: string,
  inputs: readonly Uint8Array[],
): Promise<string | undefined> {
  if (entrance.kind !== 'running') {
    try {
      for (const input of inputs) await entrance.deliver(input, { program } as FuzzTarget);
      return undefined;
    } catch (error) {
      return String(error);
    }
  }
  const monitored = await MonitoredMaster.open(program);
  try {
    for (const input of inputs) {
      await monitored.deliver(entrance, input);
      await monitored.check();
    }
    return undefined;
  } catch (error) {
    return String(error);
  } finally {
    await monitored.close();
  }
}
