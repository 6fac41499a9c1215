import { Random } from '../random.ts';
import { MonitoredMaster } from './monitored-master.ts';
import type { Entrance, FuzzTarget } from './entrance.ts';
import type { Find } from './corpus.ts';

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

/** The one input of a batch that does harm by itself; all of them when it takes more than one. */
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
