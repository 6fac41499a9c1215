import { describe, expect, it } from 'vitest';
import type { TopicRate } from '../../connection/topic-rates.ts';
import type { FindPublisher, Publisher } from '../names/publisher.ts';
import { parseTopicFilter } from './topic-filter.ts';
import { TopicsModel } from './topics-model.ts';

interface RateInit {
  readonly hz?: number;
  readonly format?: string;
  readonly publisherId?: string;
  readonly publishedMs?: number;
}

const rateOf = (topic: string, init: RateInit = {}): TopicRate => ({
  statistic: {
    topic,
    dataFormat: init.format ?? 'double',
    publisherId: init.publisherId ?? '',
    records: 1,
    bytes: 10,
    dropped: 0,
    publishedMs: init.publishedMs ?? 0,
    subscribers: 0,
    valueBytes: 10,
  },
  hz: init.hz ?? 0,
  bytesPerSecond: (init.hz ?? 0) * 10,
  droppedPerSecond: 0,
  usualHz: init.hz ?? 0,
});

const CLIENTS: Record<string, Publisher> = {
  'id-1': { name: 'Mara', isAway: false, isClient: true },
  'id-2': { name: 'Ines', isAway: true, isClient: true },
  'id-3': { name: 'Theo', isAway: false, isClient: true },
};

function modelOf(
  topics: readonly (string | TopicRate)[],
  find: FindPublisher = (id) => CLIENTS[id],
) {
  const model = new TopicsModel(find);
  const added = topics.map((topic) => (typeof topic === 'string' ? rateOf(topic) : topic));
  model.apply({ added, removed: [] });
  model.refresh(0);
  return { model, rates: added };
}

const keys = (model: TopicsModel) => model.rows.map(({ key }) => key);

describe('TopicsModel', () => {
  it('lays out branches before what is below them', () => {
    const { model } = modelOf(['/b/y', '/a/x', '/b/z/deep', '/b']);
    expect(keys(model)).toEqual(['/a', '/a/x', '/b', '/b/y', '/b/z', '/b/z/deep']);
    expect(model.rows.map(({ level }) => level)).toEqual([1, 2, 1, 2, 2, 3]);
    expect(model.rows.map(({ count }) => count)).toEqual([1, 1, 3, 1, 1, 1]);
  });

  it('says where a row stands among its siblings', () => {
    const { model } = modelOf(['/a/x', '/a/y', '/a/z', '/b']);
    expect(model.rows.map(({ position, setSize }) => `${position}/${setSize}`)).toEqual([
      '1/2',
      '1/3',
      '2/3',
      '3/3',
      '2/2',
    ]);
  });

  it('counts the publishers that are clients, not the master and clients that left', () => {
    const { model } = modelOf(
      ['id-1', 'master', 'left', ''].map((publisherId) =>
        rateOf(`/${publisherId}/x`, { publisherId }),
      ),
      (id) => CLIENTS[id] ?? { name: id, isAway: false },
    );
    expect(model.totals).toMatchObject({ topics: 4, publishers: 1 });
  });

  it('sums up rates and takes the newest record of a branch', () => {
    const { model } = modelOf([
      rateOf('/a/x', { hz: 10, publishedMs: 500 }),
      rateOf('/a/b/y', { hz: 5, publishedMs: 900 }),
    ]);
    const branch = model.find('/a')!;
    expect([branch.count, branch.hz, branch.bytesPerSecond, branch.publishedMs]).toEqual([
      2, 15, 150, 900,
    ]);
    expect(model.totals).toEqual({ topics: 2, publishers: 0, hz: 15, bytesPerSecond: 150 });
  });

  it('sorts names by number and without case', () => {
    const { model } = modelOf(['/s10', '/S9', '/s2', '/B', '/a']);
    expect(keys(model)).toEqual(['/a', '/B', '/s2', '/S9', '/s10']);
  });

  it('puts clients first and those that are away last', () => {
    const { model } = modelOf(['/studio', '/id-2/x', '/id-3/x', '/id-1/x']);
    model.setAllExpanded(false);
    model.refresh(0);
    expect(keys(model)).toEqual(['/id-1', '/id-3', '/studio', '/id-2']);
  });

  it('ranks by rate on every level, without moving for small differences', () => {
    const { model, rates } = modelOf([
      rateOf('/a/slow', { hz: 1 }),
      rateOf('/a/fast', { hz: 60 }),
      rateOf('/b', { hz: 30 }),
      rateOf('/c', { hz: 0 }),
    ]);
    model.setOrder('rate');
    model.refresh(0);
    expect(keys(model)).toEqual(['/a', '/a/fast', '/a/slow', '/b', '/c']);
    const before = model.rows;
    (rates[2] as { hz: number }).hz = 30.5;
    model.refresh(5000);
    expect(model.rows).toBe(before);
    (rates[2] as { hz: number }).hz = 90;
    model.refresh(5500);
    expect(model.rows).toBe(before); // Not more often than once a second.
    model.refresh(6100);
    expect(keys(model)).toEqual(['/b', '/a', '/a/fast', '/a/slow', '/c']);
  });

  it('ranks by bandwidth and by age', () => {
    const { model } = modelOf([
      rateOf('/a', { hz: 1, publishedMs: 9000 }),
      rateOf('/b', { hz: 9, publishedMs: 1000 }),
    ]);
    model.setOrder('bandwidth');
    model.refresh(0);
    expect(keys(model)).toEqual(['/b', '/a']);
    model.setOrder('age');
    model.refresh(0);
    expect(keys(model)).toEqual(['/a', '/b']);
  });

  it('shows what is found with what is above it, and sums up only that', () => {
    const { model } = modelOf(['/id-1/phone/acceleration', '/id-1/phone/touch', '/studio/radius']);
    model.setAllExpanded(false);
    model.setFilter(parseTopicFilter('accel'));
    model.refresh(0);
    expect(keys(model)).toEqual(['/id-1', '/id-1/phone', '/id-1/phone/acceleration']);
    expect(model.rows[0]?.count).toBe(1);
    expect([model.found, model.totals.topics]).toEqual([1, 3]);
    model.setFilter(parseTopicFilter('client:mara'));
    model.refresh(0);
    expect(model.found).toBe(2);
    model.setFilter(parseTopicFilter(''));
    model.refresh(0);
    expect(keys(model)).toEqual(['/id-1', '/studio']); // as it was before the search
  });

  it('finds topics by name and id of their publisher', () => {
    const { model } = modelOf([rateOf('/studio/radius', { publisherId: 'id-3' }), '/studio/x']);
    for (const search of ['theo', 'client:theo', 'client:id-3']) {
      model.setFilter(parseTopicFilter(search));
      model.refresh(0);
      expect(keys(model)).toEqual(['/studio', '/studio/radius']);
    }
  });

  it('filters by data format, also when the format of a topic changes', () => {
    const { model, rates } = modelOf([
      rateOf('/a', { format: 'vector2' }),
      rateOf('/b', { format: 'double' }),
    ]);
    expect(model.formats()).toEqual(['double', 'vector2']);
    model.setFormat('vector2');
    model.refresh(0);
    expect(keys(model)).toEqual(['/a']);
    rates[1]!.statistic.dataFormat = 'vector2';
    model.refresh(0);
    expect(keys(model)).toEqual(['/a', '/b']);
  });

  it('collapses within a search without forgetting it for later', () => {
    const { model } = modelOf(['/a/x', '/b/x']);
    model.setFilter(parseTopicFilter('x'));
    model.setExpanded(model.find('/a')!, false);
    model.refresh(0);
    expect(keys(model)).toEqual(['/a', '/b', '/b/x']);
    model.setFilter(parseTopicFilter(''));
    model.refresh(0);
    expect(keys(model)).toEqual(['/a', '/a/x', '/b', '/b/x']);
  });

  it('searches again when a client gets another name', () => {
    const names: Record<string, { name: string; isAway: boolean }> = {};
    const { model } = modelOf(['/id-9/x', '/id-8/x'], (id) => names[id]);
    model.setFilter(parseTopicFilter('zoe'));
    model.refresh(0);
    expect(model.rows).toEqual([]);
    names['id-9'] = { name: 'Zoe', isAway: false };
    model.handlePublishers();
    model.refresh(0);
    expect(keys(model)).toEqual(['/id-9', '/id-9/x']);
  });

  it('opens what is above a topic', () => {
    const { model } = modelOf(['/a/b/c']);
    model.setAllExpanded(false);
    model.reveal('/a/b/c');
    model.refresh(0);
    expect(keys(model)).toEqual(['/a', '/a/b', '/a/b/c']);
  });

  it('removes topics and the branches that held nothing else', () => {
    const { model, rates } = modelOf(['/a/b/c', '/a/d', '/a']);
    model.apply({ added: [], removed: [rates[0]!] });
    model.refresh(0);
    expect(keys(model)).toEqual(['/a', '/a/d']);
    model.apply({ added: [], removed: [rates[2]!] });
    model.refresh(0);
    expect(keys(model)).toEqual(['/a', '/a/d']);
    model.apply({ added: [], removed: [rates[1]!] });
    model.refresh(0);
    expect(keys(model)).toEqual([]);
    expect(model.totals.topics).toBe(0);
  });

  it('keeps a topic that came back in the same reply', () => {
    const { model, rates } = modelOf(['/a']);
    const again = rateOf('/a', { hz: 7 });
    model.apply({ added: [again], removed: [rates[0]!] });
    model.refresh(0);
    expect(model.find('/a')?.rate).toBe(again);
    expect(model.totals.topics).toBe(1);
  });

  it('begins wide branches collapsed, and lets a person decide from then on', () => {
    const { model } = modelOf(Array.from({ length: 100 }, (_, i) => `/wide/${i}`));
    expect(keys(model)).toEqual(['/wide']);
    model.setExpanded(model.find('/wide')!, true);
    model.apply({ added: [rateOf('/wide/new')], removed: [] });
    model.refresh(0);
    expect(model.rows).toHaveLength(102);
  });

  it('gives the same array while nothing moves', () => {
    const { model } = modelOf(['/a', '/b']);
    const before = model.rows;
    model.handlePublishers();
    model.refresh(0);
    expect(model.rows).toBe(before);
  });
});

describe('TopicsModel with 10 000 topics', () => {
  const topicOf = (i: number) => `/client-${i % 100}/device-${i % 7}/component-${i}`;
  const all = Array.from({ length: 10_000 }, (_, i) =>
    rateOf(topicOf(i), { hz: i % 3, publishedMs: i }),
  );

  it('shows each topic once, in order, below its own branches', () => {
    const { model } = modelOf(all);
    model.setAllExpanded(true);
    model.refresh(0);
    const leaves = model.rows.filter(({ rate }) => rate);
    expect(new Set(leaves.map(({ rate }) => rate)).size).toBe(10_000);
    const expectedBranches = new Set(
      all.flatMap(({ statistic }) => {
        const [, client, device] = statistic.topic.split('/');
        return [`/${client}`, `/${client}/${device}`];
      }),
    );
    expect(model.rows).toHaveLength(10_000 + expectedBranches.size);
    const open: string[] = [];
    for (const row of model.rows) {
      open.length = row.level - 1;
      expect(row.parent?.key).toBe(open.at(-1) ?? '');
      open.push(row.key);
    }
  });

  it('counts and sums up like a plain loop, also while topics come and go', () => {
    const { model } = modelOf(all);
    const here = new Set(all);
    for (let round = 1; round <= 5; round++) {
      const removed = [...here].filter((_, i) => i % (round + 3) === 0);
      const added = Array.from({ length: 300 }, (_, i) =>
        rateOf(topicOf(20_000 + round * 300 + i), { hz: 2 }),
      );
      for (const rate of removed) here.delete(rate);
      for (const rate of added) here.add(rate);
      model.apply({ added, removed });
      model.refresh(0);
      for (let client = 0; client < 100; client += 9) {
        const prefix = `/client-${client}`;
        const mine = [...here].filter(({ statistic }) => statistic.topic.startsWith(`${prefix}/`));
        const node = model.find(prefix);
        expect(node?.count ?? 0).toBe(mine.length);
        expect(node?.hz ?? 0).toBe(mine.reduce((sum, { hz }) => sum + hz!, 0));
      }
      expect(model.totals.topics).toBe(here.size);
    }
  });

  it('begins with the roots only', () => {
    expect(modelOf(all).model.rows).toHaveLength(100);
  });

  it('finds the same topics as a plain loop', () => {
    const { model } = modelOf(all);
    model.setFilter(parseTopicFilter('client-1 component-9'));
    model.refresh(0);
    const expected = all.filter(
      ({ statistic: { topic } }) => topic.includes('client-1') && topic.includes('component-9'),
    );
    const found = model.rows.filter(({ rate }) => rate).map(({ key }) => key);
    expect(found.toSorted()).toEqual(expected.map(({ statistic }) => statistic.topic).toSorted());
  });
});
