import type { IoInit } from '@ubii/pm-sandbox';
import { DATA_FORMATS } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { formatOf, isList } from './drive-module.ts';
import { HostileInputs } from './hostile-inputs.ts';
import { PLAIN_MODULES } from './plain-modules.ts';
import { WAYS } from './ways.ts';

const DELTAS_MS = [0, 0.001, 16.7, 1000, 1e9];
/** Outputs told by a real clock, which differ from run to run. */
const MEASURED = 'durationMs';

describe.each(PLAIN_MODULES.map((module) => [module.name, module] as const))(
  '%s',
  (_name, module) => {
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
  },
);
