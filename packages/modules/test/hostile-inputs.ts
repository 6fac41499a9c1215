import type { IoInit } from '@ubii/pm-sandbox';
import { DATA_FORMATS, type DataFormat } from '@ubii/proto';
import { formatOf, isList, Sample, type InputValues } from './drive-module.ts';

const NUMBERS = [0, -0, 1, -1, 0.5, 1e-320, 1e6, -1e300, 1e308, NaN, Infinity, -Infinity];
const TEXTS = ['', ' ', 'a.b[0]', '__proto__', 'http://thing.local/', 'http://other.local/', '€'];

/** Numbers from 0 to 1 that look random and are always the same (Park and Miller, 1988). */
function pseudoRandom(seed: number): () => number {
  let state = seed;
  return () => (state = (state * 48_271) % 2_147_483_647) / 2_147_483_647;
}

/** The same inputs for the same seed: missing ones, wrong numbers, other number formats, all that fits. */
export class HostileInputs {
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
        return this.pick([0, 1, -1, 7, 100, 50_000, -(2 ** 31)]);
      case 'bool':
        return this.#random() < 0.5;
      case 'string':
        return this.pick(TEXTS);
      case 'keyEvent':
        return { type: this.pick([0, 1, 7]), key: this.pick(TEXTS) };
      case 'image2D':
        // Complete, too short, and without any pixel.
        return {
          width: this.pick([4, 0, -1]),
          height: this.pick([3, 3, 100_000]),
          dataFormat: this.pick([0, 1, 2, 9]),
          data: new Uint8Array(this.pick([12, 36, 48, 0])).fill(this.pick([0, 255])),
        };
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
