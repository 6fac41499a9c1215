import { fromJson, ModuleOrigin, type ProcessingModule } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { moduleEntries } from '../../modules/library/module-entry.ts';
import { aModule, aSessionOf } from '../model/testing/small-graph.ts';
import { hostedModules, hostLoad } from './host-load.ts';
import { groupModules, withRecent } from '../../modules/library/recent-modules.ts';

const node = (init: object) =>
  fromJson('ubii.extension.NodeInfo', { clientId: 'n', available: true, ...init });

describe('modules used last', () => {
  it('come first, each once, up to a number', () => {
    expect(withRecent(['b', 'a'], 'a')).toEqual(['a', 'b']);
    expect(withRecent(['1', '2', '3', '4', '5'], '6')).toEqual(['6', '1', '2', '3', '4']);
  });

  it('are taken out of the others; what is gone is left out', () => {
    const entries = moduleEntries([aModule('a'), aModule('b'), aModule('c')], [], []);
    const { recent, others } = groupModules(entries, ['c', 'gone']);
    expect(recent.map(({ module }) => module.name)).toEqual(['c']);
    expect(others.map(({ module }) => module.name)).toEqual(['a', 'b']);
  });

  it('come after those that people of this master wrote', () => {
    const own = {
      ...aModule('own'),
      extension: { ...aModule('own').extension, origin: ModuleOrigin.MODULE_ORIGIN_STORED },
    } as ProcessingModule;
    const groups = groupModules(moduleEntries([aModule('a'), own, aModule('c')], [], []), [
      'own',
      'c',
    ]);
    const names = Object.entries(groups).map(([title, list]) => [
      title,
      ...list.map(({ module }) => module.name),
    ]);
    expect(names).toEqual([
      ['own', 'own'],
      ['recent', 'c'],
      ['others', 'a'],
    ]);
  });
});

describe('nodes that run modules', () => {
  it('say how full they are', () => {
    expect(hostLoad(node({ instances: 1, node: { capacity: 4 } }))).toEqual({
      text: '1 of 4',
      share: 0.25,
    });
    expect(hostLoad(node({ instances: 9, node: { capacity: 4 } })).share).toBe(1);
    expect(hostLoad(node({ instances: 2 })).text).toBe('2');
    expect(hostLoad(node({})).text).toBe('idle');
    expect(hostLoad(node({ available: false })).text).toBe('away');
  });

  it('say what runs on them', () => {
    const session = aSessionOf([{ ...aModule('a'), nodeId: 'n' }, aModule('b')]);
    expect(hostedModules(node({}), [session])).toEqual([
      { moduleId: 'a', name: 'a', sessionId: 'session', session: 'Test' },
    ]);
  });
});
