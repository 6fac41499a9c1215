import { describe, expect, it } from 'vitest';
import { TopicTree, summarise } from '../tree/topic-tree.ts';
import { rowView } from './row-view.ts';

const NOW = 1_000_000;
const CLIENTS: Record<string, { name: string; isAway: boolean }> = {
  here: { name: 'Mara', isAway: false },
  gone: { name: 'Ines', isAway: true },
};

interface Init {
  readonly hz?: number | undefined;
  readonly usualHz?: number;
  readonly ageMs?: number;
  readonly publisherId?: string;
}

function viewOf(topic: string, { hz, usualHz, ageMs, publisherId = '' }: Init, key = topic) {
  const tree = new TopicTree();
  tree.add({
    statistic: {
      topic,
      dataFormat: 'double',
      publisherId,
      records: 1,
      bytes: 1,
      dropped: 0,
      publishedMs: ageMs === undefined ? 0 : NOW - ageMs,
      subscribers: 0,
      valueBytes: 1,
    },
    hz,
    bytesPerSecond: hz === undefined ? undefined : hz * 60,
    droppedPerSecond: 0,
    usualHz,
  });
  summarise(tree.top, () => true);
  return rowView(tree.find(key)!, (id) => CLIENTS[id], NOW);
}

describe('rowView', () => {
  it('writes rate, bandwidth and age', () => {
    expect(viewOf('/studio/radius', { hz: 59.94, ageMs: 9 })).toMatchObject({
      name: 'radius',
      publisher: undefined,
      hz: '59.9',
      bandwidth: { digits: '3.6', unit: 'k' },
      age: { digits: '9', unit: 'ms' },
      ageMs: 9,
    });
  });

  it('says what is not known', () => {
    expect(viewOf('/a', {})).toMatchObject({
      hz: '–',
      bandwidth: { digits: '–' },
      age: { digits: '–' },
      ageMs: undefined,
      isStale: false,
    });
  });

  it('calls a root by the name of its client', () => {
    expect(viewOf('/here/x', { hz: 1, ageMs: 1 }, '/here')).toMatchObject({
      name: 'Mara',
      publisher: CLIENTS.here,
    });
    expect(viewOf('/unknown/x', {}, '/unknown').name).toBe('unknown');
    expect(viewOf('//x', {}, '/').name).toBe('(no name)');
  });

  it.each<[string, string, Init, boolean]>([
    ['a stream that ended', '/a', { usualHz: 60, ageMs: 11_000 }, true],
    ['a stream that is a little late', '/a', { usualHz: 60, ageMs: 4000 }, false],
    ['a setting made long ago', '/a', { ageMs: 18 * 60_000 }, false],
    ['a slow topic between two records', '/a', { usualHz: 0.1, ageMs: 9000 }, false],
    ['anything of a client that is away', '/gone/a', { ageMs: 38_000 }, true],
    ['a topic whose publisher is away', '/a', { ageMs: 38_000, publisherId: 'gone' }, true],
    ['anything of a client that is here', '/here/a', { ageMs: 38_000 }, false],
  ])('%s', (_what, topic, init, stale) => {
    expect(viewOf(topic, init).isStale).toBe(stale);
  });

  it('warns at the root of a client that is away', () => {
    expect(viewOf('/gone/a', { ageMs: 38_000 }, '/gone').isStale).toBe(true);
    expect(viewOf('/here/a', { ageMs: 38_000 }, '/here').isStale).toBe(false);
  });
});
