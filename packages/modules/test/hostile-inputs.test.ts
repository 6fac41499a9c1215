import type { IoInit } from '@ubii/pm-sandbox';
import { DATA_FORMATS, type DataFormat } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { MODULES } from '../src/index.ts';
import { formatOf, isList, Sample, type InputValues } from './drive-module.ts';
import { WAYS } from './ways.ts';

const NUMBERS = [0, -0, 1, -1, 0.5, 1e-320, 1e6, -1e300, 1e308, NaN, Infinity, -Infinity];
const TEXTS = ['', ' ', 'a.b[0]', '__proto__', 'http://thing.local/', 'http://other.local/', '€'];
const DELTAS_MS = [0, 0.001, 16.7, 1000, 1e9];
/** Outputs told by a real clock, which differ from run to run. */
const MEASURED = 'durationMs';

/** Numbers from 0 to 1 that look random and are always the same (Park and Miller, 1988). */
function pseudoRandom(seed: number): () => number {
  let state = seed;
  return () => (state = (state * 48_271) % 2_147_483_647) / 2_147_483_647;
}

/** The same inputs for the same seed: missing ones, wrong numbers, other number formats, all that fits. */
class HostileInputs {
  readonly #random: () => number;

  constructor(seed: number) {
    this.#random = pseudoRandom(seed);
  }

  pick<T>(list: readonly T[]): T {
    return list[Math.floor(this.#random() * list.length)]!;
  }

  inputs(inits: Readonly<Record<string, IoInit>>): InputValues {
    const changed = Object.entries(inits).filter(() => this.#random() < 0.7);
    return Object.fromEntries(changed.map(([name, init]) => [name, this.#input(init)]));
  }

  #input(init: IoInit): unknown {
    if (!isList(init)) return this.#random() < 0.1 ? undefined : this.#value(formatOf(init));
    return Array.from({ length: Math.floor(this.#random() * 6) }, (_, i) => {
      const identity = this.pick([undefined, '', 'ann', 'bob', '__proto__']);
      return new Sample(this.#value(formatOf(init)), { identity, topic: `/touch/${i}` });
    });
  }

  #value(format: DataFormat): unknown {
    switch (format) {
      case 'double':
        return this.#random() < 0.2
          ? new Sample(Math.fround(this.#random()), { type: 'float' })
          : this.#number();
      case 'int32':
        return this.pick([0, 1, -1, 7, 100, 2 ** 31 - 1, -(2 ** 31)]);
      case 'bool':
        return this.#random() < 0.5;
      case 'string':
        return this.pick(TEXTS);
      default:
        return Object.fromEntries(
          Object.keys(DATA_FORMATS[format].createDefault() as object).map((part) => [
            part,
            this.#number(),
          ]),
        );
    }
  }

  #number(): number {
    return this.#random() < 0.5 ? this.#random() : this.pick(NUMBERS);
  }
}

describe.each(MODULES.map((module) => [module.name, module] as const))('%s', (_name, module) => {
  const outputs = module.outputs as Readonly<Record<string, IoInit>>;
  const libraries = {
    http: {
      get: (url: string) =>
        url.includes('other')
          ? Promise.reject(new Error('unreachable'))
          : Promise.resolve({ status: 200, text: '{"a":{"b":[1e999]}}' }),
    },
  };

  it.each(WAYS)(
    'puts out nothing but finite values of its formats, whatever comes, %s',
    async (_way, drive) => {
      const hostile = new HostileInputs(7);
      const driven = await drive(module, libraries);
      for (let run = 0; run < 150; run++) {
        const values = hostile.inputs(module.inputs);
        const triggers = hostile.pick([undefined, [], Object.keys(values)]);
        const given = await driven.run(hostile.pick(DELTAS_MS), values, triggers);
        for (const [output, value] of Object.entries(given)) {
          const format = formatOf(outputs[output]!);
          const list = isList(outputs[output]!)
            ? (value as Readonly<Record<string, unknown>>[]).map((element) => element[format])
            : [value];
          for (const one of list) {
            expect(DATA_FORMATS[format].validate(one), `${output} in run ${run}`).toBeUndefined();
            for (const part of typeof one === 'object' ? Object.values(one!) : [one]) {
              if (typeof part === 'number') expect(part, output).toSatisfy(Number.isFinite);
            }
          }
        }
      }
    },
  );

  it.each(WAYS)('does the same again after a restart, %s [PM-54]', async (_way, drive) => {
    const play = async (): Promise<unknown[]> => {
      const hostile = new HostileInputs(11);
      const driven = await drive(module, libraries);
      const played: unknown[] = [];
      for (let run = 0; run < 30; run++) {
        const values = hostile.inputs(module.inputs);
        const given = await driven.run(hostile.pick(DELTAS_MS), values);
        delete given[MEASURED];
        played.push(given);
      }
      return played;
    };
    expect(await play()).toEqual(await play());
  });
});
