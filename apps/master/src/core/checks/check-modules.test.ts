import type { ModuleStatistics } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { checkModules, type ModuleLoad } from './check-modules.ts';

function load(
  statistics: Partial<ModuleStatistics>,
  coreShare = 0.1,
  needsAssets = false,
): ModuleLoad {
  return {
    moduleId: 'm',
    name: 'blur',
    nodeId: 'n',
    sessionId: 's',
    sessionLabel: 'party',
    coreShare,
    needsAssets,
    statistics: {
      runP95Ms: 45.04,
      runsPerSecond: 20,
      overruns: 0,
      ...statistics,
    } as ModuleStatistics,
  };
}

const check = (module: ModuleLoad, overrunsBefore: number | undefined, masterId = '') => [
  ...checkModules(
    [module],
    new Map(overrunsBefore === undefined ? [] : [['m', overrunsBefore]]),
    () => 'lab pc',
    masterId,
  ),
];

describe('checkModules() [EX-47]', () => {
  it('finds one whose runs come too late', () => {
    expect(check(load({ overruns: 7 }), 5)).toEqual([
      [
        'module_slow m',
        expect.objectContaining({
          text: 'The runs of the module "blur" of the session "party" take 45.0 ms on "lab pc", 20 times a second, and start later than its mode requires.',
          clientId: 'n',
          sessionId: 's',
          moduleId: 'm',
        }),
      ],
    ]);
  });

  it('finds one that takes a whole core, also on the master, which is no client', () => {
    const problem = check(load({}, 0.95), 0, 'n')[0]?.[1];
    expect(problem).toMatchObject({ clientId: '' });
    expect(problem?.text).toContain('so that it takes 95 % of a core');
  });

  it('names no module with models that takes a whole core, unless it is late', () => {
    expect(check(load({}, 1.1, true), 0)).toEqual([]);
    expect(check(load({ overruns: 7 }, 1.1, true), 5)).toHaveLength(1);
  });

  it('names no module that is late because something else had the processor', () => {
    expect(check(load({ overruns: 7, runP95Ms: 0.4 }, 0.002), 5)).toEqual([]);
  });

  it('finds nothing where nothing was late since the last look', () => {
    expect(check(load({ overruns: 7 }), 7)).toEqual([]);
    expect(check(load({ overruns: 7 }), undefined)).toEqual([]);
  });
});
