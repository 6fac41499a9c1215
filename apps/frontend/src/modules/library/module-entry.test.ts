import { fromJson, ModuleOrigin, type NodeInfo, type ProcessingModule } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { aSession } from '../../sessions/testing/a-session.ts';
import { filterModules, isDeletable, moduleEntries, moduleFormats } from './module-entry.ts';

const module = (json: object): ProcessingModule =>
  fromJson('ubii.processing.ProcessingModule', json);

const mirror = module({
  name: 'mirror',
  tags: ['pointer'],
  inputs: [{ internalName: 'a', messageFormat: 'ubii.dataStructure.Vector2' }],
  outputs: [{ internalName: 'b', messageFormat: 'vector2' }],
  extension: { origin: 'MODULE_ORIGIN_BUILT_IN' },
});
const clock = module({
  name: 'clock',
  description: 'Ticks.',
  outputs: [{ internalName: 't', messageFormat: 'double' }],
  extension: { origin: 'MODULE_ORIGIN_STORED' },
});
const node: NodeInfo = fromJson('ubii.extension.NodeInfo', {
  clientId: 'n',
  moduleNames: ['clock'],
});

describe('the library', () => {
  const entries = moduleEntries([mirror, clock], [node], [aSession()]);

  it('lists the nodes that offer a module and the sessions that use it', () => {
    expect(entries.map((one) => one.module.name)).toEqual(['clock', 'mirror']);
    expect(entries[0]?.offeredBy).toEqual([node]);
    expect(entries[1]?.usedBy.map(({ name }) => name)).toEqual(['Two hands']);
  });

  it('is found by words, data format and origin', () => {
    const find = (search: object) =>
      filterModules(entries, { text: '', format: '', origin: undefined, ...search }).map(
        (one) => one.module.name,
      );
    expect(find({})).toEqual(['clock', 'mirror']);
    expect(find({ text: 'POINT mirr' })).toEqual(['mirror']);
    expect(find({ format: 'double' })).toEqual(['clock']);
    expect(find({ origin: ModuleOrigin.MODULE_ORIGIN_BUILT_IN })).toEqual(['mirror']);
    expect(find({ text: 'nothing' })).toEqual([]);
  });

  it('names data formats once, in short', () => {
    expect(moduleFormats(mirror)).toEqual(['vector2']);
  });

  it('lets only what was stored be deleted [SE-22]', () => {
    expect(entries.map(isDeletable)).toEqual([true, false]);
  });
});
