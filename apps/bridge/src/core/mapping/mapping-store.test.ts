import { BridgeOutcome } from '@ubii/proto';
import type { BridgeOrder, Init } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { answerMappingOrder } from './answer-mapping-order.ts';
import { MappingStore } from './mapping-store.ts';

const lamp = { direction: 'out', foreign: 'lamps/{1}', topic: '/lamps/*' };
const temperature = { direction: 'in', foreign: 'home/+', topic: '/{1}', format: 'double' };

/** A bridge with this file in memory. */
function open(text?: string) {
  const disk = { text, fails: false };
  const store = new MappingStore({
    protocol: 'mqtt',
    storage: {
      path: '/srv/bridge.json',
      read: () => disk.text,
      write(next) {
        if (disk.fails) throw new Error('no space left');
        disk.text = next;
      },
    },
    digest: (content) => `${content.length} ${content}`,
  });
  const saved: string[] = [];
  const context = {
    store,
    present: async () => ({
      topics: ['/lamps/a', '/lamps/b', '/ubii/x'],
      addresses: ['home/hall'],
    }),
    onSaved: (author: string) => saved.push(author),
  };
  const ask = (order: Init<BridgeOrder>) =>
    answerMappingOrder(context, { number: 1, author: 'Ada', ...order } as BridgeOrder);
  const set = (list: readonly unknown[], revision = store.revision) =>
    ask({ set: { mappingsJson: JSON.stringify(list), revision } });
  return { disk, store, saved, ask, set };
}

const fileOf = (...mappings: object[]) => JSON.stringify({ version: 1, mappings });

describe('the mappings of a bridge', () => {
  it('are told as they are written, with the file [BR-80]', async () => {
    const { ask } = open(fileOf(lamp, { ...temperature, enabled: false }));
    const told = await ask({ get: {} });
    expect(JSON.parse(told.mappingsJson!)).toEqual([lamp, { ...temperature, enabled: false }]);
    expect(told).toMatchObject({ protocol: 'mqtt', file: '/srv/bridge.json', fileExists: true });
  });

  it('pass nothing while they are switched off [BR-5]', () => {
    const { store } = open(fileOf(lamp, { ...temperature, enabled: false }));
    expect(store.file.mappings.map(({ name }) => name)).toEqual(['lamps/{1} out /lamps/*']);
  });

  it('are saved with what else is in the file, in its indentation [BR-82] [BR-83]', async () => {
    const { disk, store, saved, set } = open(
      '{\n    "version": 1,\n    "availability": "a/b",\n    "mappings": []\n}',
    );
    expect(await set([lamp])).toMatchObject({ outcome: BridgeOutcome.BRIDGE_OUTCOME_SAVED });
    expect(disk.text).toContain('{\n    "version": 1,\n    "availability": "a/b",\n    "mappings"');
    expect(store.file.mappings).toHaveLength(1);
    expect(saved).toEqual(['Ada']);
  });

  it('create their file when it is missing [BR-83]', async () => {
    const { disk, store, set } = open();
    expect(store.fileExists).toBe(false);
    await set([lamp]);
    expect(JSON.parse(disk.text!)).toEqual({ version: 1, mappings: [lamp] });
    expect(store.fileExists).toBe(true);
  });

  it('are not saved over a change of another editor, by page or by hand [BR-82]', async () => {
    const { disk, store, saved, set } = open(fileOf(lamp));
    const { revision } = store;
    disk.text = fileOf(temperature);
    const reply = await set([], revision);
    expect(reply).toMatchObject({ outcome: BridgeOutcome.BRIDGE_OUTCOME_CONFLICT });
    expect(JSON.parse(reply.mappingsJson!)).toEqual([temperature]);
    disk.text = '{ half edited';
    const next = await set([]);
    expect(next).toMatchObject({ outcome: BridgeOutcome.BRIDGE_OUTCOME_CONFLICT });
    expect(next.fileProblem).toContain('is not JSON');
    expect(disk.text).toBe('{ half edited');
    expect(store.file.mappings).toHaveLength(1);
    expect(saved).toEqual([]);
  });

  it('are refused with the place of each problem, and nothing is saved [BR-81]', async () => {
    const before = fileOf(lamp);
    const { disk, set } = open(before);
    const wrong = { ...temperature, qos: 3, maxTopics: 0 };
    const reply = await set([lamp, lamp, wrong, { ...temperature, topic: '/{2}' }, 7]);
    expect(reply).toMatchObject({ outcome: BridgeOutcome.BRIDGE_OUTCOME_REFUSED });
    expect(reply.problems?.map(({ index, member }) => [index, member])).toEqual([
      [1, 'name'],
      [2, 'maxTopics'],
      [2, 'qos'],
      [3, 'topic'],
      [4, ''],
    ]);
    expect(reply.problems?.[2]?.message).toBe('Must be 0, 1 or 2, but is 3.');
    expect(disk.text).toBe(before);
  });

  it('stay as they are when the file cannot be written [BR-82]', async () => {
    const { disk, store, set } = open(fileOf(lamp));
    disk.fails = true;
    await expect(set([])).rejects.toThrow(
      'The mapping file /srv/bridge.json cannot be written: no space left. Nothing has changed.',
    );
    expect(store.file.mappings).toHaveLength(1);
  });

  it('are tried on what there is, without being saved [BR-81]', async () => {
    const { disk, ask } = open(fileOf());
    const check = (mapping: object) =>
      ask({ check: { mappingsJson: JSON.stringify([mapping]), previewIndex: 0 } });
    expect((await check(lamp)).matches).toEqual([
      { inward: false, source: '/lamps/a', target: 'lamps/a', isExample: false },
      { inward: false, source: '/lamps/b', target: 'lamps/b', isExample: false },
    ]);
    expect((await check(temperature)).matches).toEqual([
      { inward: true, source: 'home/hall', target: '/hall', isExample: false },
    ]);
    expect((await check({ ...lamp, qos: 9 })).matches).toBeUndefined();
    expect(disk.text).toBe(fileOf());
  });

  it('are a list [BR-81]', async () => {
    const { ask } = open(fileOf());
    for (const mappingsJson of [
      '{}',
      '[',
      JSON.stringify(Array.from({ length: 201 }, () => lamp)),
    ]) {
      await expect(ask({ set: { mappingsJson } })).rejects.toThrow('must be a list of at most 200');
    }
  });
});
