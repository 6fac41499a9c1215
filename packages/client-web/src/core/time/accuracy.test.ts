import { describe, expect, it } from 'vitest';
import { ClockWorld } from '../../testing/clock-world.ts';
import type { ClockWorldOptions, WayMs } from '../../testing/clock-world.ts';

/** Exponential, so that most packets are quick and some are not. */
const about =
  (leastMs: number, meanMoreMs: number): WayMs =>
  (random) =>
    leastMs - meanMoreMs * Math.log(1 - random());

/** Lost data is sent again after the timeout of TCP. */
const lossy =
  (share: number, way: WayMs): WayMs =>
  (random) =>
    way(random) + (random() < share ? 200 + 800 * random() : 0);

const cable = { toMasterMs: about(0.15, 0.1), toClientMs: about(0.15, 0.1) };
/** Wi-Fi with power saving: what goes to the phone waits longer. */
const wifi = {
  toMasterMs: lossy(0.01, about(1, 2)),
  toClientMs: lossy(0.01, about(1.5, 12)),
};
const badWifi = {
  toMasterMs: lossy(0.05, about(3, 40)),
  toClientMs: lossy(0.05, about(5, 15)),
};

/** Events within a quarter of an hour, besides those of the network. */
type Course = (world: ClockWorld, passedMs: number) => void;

const calm: Course = () => undefined;
const sleeps: Course = (world) => {
  if (world.random() < 0.01) world.sleep(100 + 120_000 * world.random());
};
const clientIsSet: Course = (world) => {
  if (world.random() < 0.01) world.setWall((world.random() - 0.5) * 10_000);
};
const masterIsSet: Course = (world) => {
  if (world.random() < 0.003) world.setMaster((world.random() - 0.5) * 4_000);
};
const masterIsCorrected: Course = (world, passedMs) => {
  world.slewMaster(passedMs % 300_000 > 200_000 ? 100 : 0);
};
const reconnects: Course = (world) => {
  if (world.random() < 0.01) {
    world.setMaster((world.random() - 0.5) * 1e6); // another master
    world.connect();
  }
};

interface Case {
  readonly name: string;
  readonly options: Omit<ClockWorldOptions, 'seed'>;
  readonly course: Course;
  /** Half of all errors are below, milliseconds. */
  readonly medianBelowMs: number;
}

const CASES: readonly Case[] = [
  { name: 'cable', options: cable, course: calm, medianBelowMs: 0.1 },
  { name: 'Wi-Fi', options: wifi, course: calm, medianBelowMs: 3 },
  { name: 'bad Wi-Fi', options: badWifi, course: calm, medianBelowMs: 6 },
  { name: '+200 ppm', options: { ...wifi, driftPpm: 200 }, course: calm, medianBelowMs: 3 },
  { name: '-200 ppm', options: { ...wifi, driftPpm: -200 }, course: calm, medianBelowMs: 3 },
  { name: 'clocks of 1 ms', options: { ...wifi, grainMs: 1 }, course: calm, medianBelowMs: 3 },
  { name: 'sleeps', options: { ...wifi, driftPpm: 80 }, course: sleeps, medianBelowMs: 4 },
  {
    name: 'client set',
    options: { ...wifi, driftPpm: -80 },
    course: clientIsSet,
    medianBelowMs: 4,
  },
  { name: 'master set', options: wifi, course: masterIsSet, medianBelowMs: 4 },
  { name: 'master slews', options: wifi, course: masterIsCorrected, medianBelowMs: 4 },
  { name: 'other masters', options: wifi, course: reconnects, medianBelowMs: 4 },
];

const RUNS = 8;
const DURATION_MS = 900_000;

/** Runs one case with several seeds and compares what the client says with the truth. */
function measure({ options, course }: Case) {
  const errorsMs: number[] = [];
  const barsMs: number[] = [];
  let within = 0;
  let asked = 0;
  for (let seed = 1; seed <= RUNS; seed += 1) {
    const world = new ClockWorld({ ...options, seed });
    world.connect();
    for (let passedMs = 0; passedMs < DURATION_MS;) {
      const stepMs = 1_000 * world.random();
      passedMs += stepMs;
      course(world, passedMs);
      world.pass(stepMs);
      asked += 1;
      const { estimate } = world.masterClock;
      if (estimate === undefined) continue;
      const errorMs = Math.abs(world.masterClock.nowMs() - world.masterMs);
      errorsMs.push(errorMs);
      barsMs.push(estimate.errorMs);
      if (errorMs <= estimate.errorMs) within += 1;
    }
  }
  const known = errorsMs.length;
  return {
    samples: known,
    withinShare: within / known,
    knownShare: known / asked,
    error50Ms: quantile(errorsMs, 0.5),
    error95Ms: quantile(errorsMs, 0.95),
    bar50Ms: quantile(barsMs, 0.5),
    bar95Ms: quantile(barsMs, 0.95),
  };
}

function quantile(values: readonly number[], share: number): number {
  return values.toSorted((a, b) => a - b)[Math.floor(share * (values.length - 1))]!;
}

describe('the master time beside the truth, in simulated networks', () => {
  it.each(CASES)('[TS-4] $name: the error bar holds the truth', (one) => {
    const result = measure(one);
    if (process.env['UBII_PRINT_ACCURACY'])
      console.log(JSON.stringify({ name: one.name, ...result }));
    expect(result.withinShare).toBeGreaterThanOrEqual(0.99);
    expect(result.knownShare).toBeGreaterThanOrEqual(0.9);
    expect(result.error50Ms).toBeLessThan(one.medianBelowMs);
  });
});
