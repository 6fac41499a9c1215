import { decodeRecord, encodeRecord, type DataFormat, type RecordInit } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import type { EncodedRecord, TopicPort, TopicSelector } from '../ports/topic-port.ts';

/** A port, and another client with the same topics. */
export interface TopicPortWorld {
  readonly port: TopicPort;
  /** Prefix of the suite's topics, such as `/test-1`, when there are others. @default none */
  readonly root?: string;
  /** Client id that publishes with `put`. */
  readonly publisherId: string;
  /** The other client publishes. */
  put(record: RecordInit & { readonly format: DataFormat }): void;
  /** Resolves when all records in transit have arrived, at the port and elsewhere. */
  settle(): Promise<void>;
  /** The newest record others see on a topic. */
  seenByOthers(topic: string): Uint8Array | undefined;
  /** The value of a topic is deleted. Undefined where the port cannot learn of it. */
  readonly delete?: (topic: string) => void;
  /**
   * Registers a device of the other client with one publishing component, a vector2 with the tag `stick`.
   * Resolves with the component's topic and its device's id.
   */
  readonly addStick?: () => Promise<{ readonly topic: string; readonly deviceId: string }>;
  close(): Promise<void>;
}

const STICKS: TopicSelector = {
  kind: 'component',
  profile: {
    topic: '',
    messageFormat: '',
    ioType: 0,
    deviceId: '',
    tags: ['stick'],
    description: '',
    id: '',
    name: '',
    notifyConditionIds: [],
  },
};

/** Acceptance tests of topic ports. An adapter's test passes a function that sets up the adapter. */
export function describeTopicPort(name: string, setup: () => Promise<TopicPortWorld>): void {
  describe(`${name} as a port to topics`, () => {
    let world: TopicPortWorld;
    let root = '';
    beforeEach(async () => {
      world = await setup();
      root = world.root ?? '';
    });
    afterEach(() => world.close());

    const put = (path: string, value: number) =>
      world.put({ topic: `${root}${path}`, format: 'double', value });
    const subscribe = (path: string) =>
      listen(world.port, { kind: 'topic', topic: `${root}${path}` }, root);

    it('hands over records of a topic as they travel', async () => {
      const log = subscribe('/a');
      await world.settle();
      put('/a', 1);
      put('/b', 2);
      await world.settle();
      expect(log.values()).toEqual(['/a=1']);
      const [record] = log.records;
      expect(record).toMatchObject({ valueField: 3, publisherId: world.publisherId });
      expect(decodeRecord(record!.bytes).topic).toBe(`${root}/a`);
    });

    it('[PM-26] hands over the value that is there', async () => {
      put('/a', 1);
      await world.settle();
      const log = subscribe('/a');
      await world.settle();
      expect(log.values()).toEqual(['/a=1']);
    });

    it('hands over the newest value last, and leaves what it gave alone', async () => {
      const log = subscribe('/a');
      await world.settle();
      put('/a', 1);
      await world.settle();
      const [first] = log.records;
      for (const value of [2, 3, 4]) put('/a', value);
      await world.settle();
      expect(log.values().at(-1)).toBe('/a=4');
      expect(decodeRecord(first!.bytes).value).toBe(1);
    });

    it('serves several subscriptions of one topic, each until it ends', async () => {
      const first = subscribe('/a');
      const second = subscribe('/a');
      await world.settle();
      put('/a', 1);
      await world.settle();
      first.cancel();
      first.cancel();
      put('/a', 2);
      await world.settle();
      expect(first.values()).toEqual(['/a=1']);
      expect(second.values()).toEqual(['/a=1', '/a=2']);
    });

    it('hands over the value to a later subscription of the same topic, too', async () => {
      subscribe('/a');
      await world.settle();
      put('/a', 1);
      await world.settle();
      const later = subscribe('/a');
      await world.settle();
      expect(later.values()).toEqual(['/a=1']);
    });

    it('lets a listener end its subscription from within', async () => {
      let count = 0;
      const cancel: Cancel = world.port.subscribe(
        { kind: 'topic', topic: `${root}/a` },
        {
          onRecord() {
            count++;
            cancel();
          },
          onGone() {},
        },
      );
      await world.settle();
      put('/a', 1);
      await world.settle();
      put('/a', 2);
      await world.settle();
      expect(count).toBe(1);
    });

    it.each<[string, (root: string) => TopicSelector]>([
      [
        'an expression, unanchored',
        (at) => ({ kind: 'regex', source: `${at.slice(1)}/game/[0-9]+/x` }),
      ],
      ['a glob, for the whole topic', (at) => ({ kind: 'glob', glob: `${at}/game/*/x*` })],
    ])('[PM-41] selects topics by %s, those that are there and later ones', async (_, selector) => {
      put('/game/1/x', 1);
      put('/game/a/y', 2);
      await world.settle();
      const log = listen(world.port, selector(root), root);
      await world.settle();
      put('/game/2/x', 3);
      put('/other/2/x', 4);
      await world.settle();
      expect(log.values()).toEqual(['/game/1/x=1', '/game/2/x=3']);
    });

    it('refuses an expression that is none', () => {
      const listener = { onRecord() {}, onGone() {} };
      expect(() => world.port.subscribe({ kind: 'regex', source: '(' }, listener)).toThrow(Error);
    });

    it('[PM-41] selects components by a profile, those that are there and later ones', async (context) => {
      const { addStick } = world;
      if (addStick === undefined) return context.skip();
      const early = await addStick();
      const log = listen(world.port, STICKS, '');
      await world.settle();
      const late = await addStick();
      await world.settle();
      for (const { topic } of [early, late]) {
        world.put({ topic, format: 'vector2', value: { x: 1, y: 2 } });
      }
      put('/a', 1);
      await world.settle();
      expect(log.records.map(({ topic }) => topic)).toEqual([early.topic, late.topic]);
      const devices = log.records.map(({ deviceId }) => deviceId);
      expect(devices).toEqual([early.deviceId, late.deviceId]);
    });

    it('[PM-44] tells when a value was deleted', async (context) => {
      if (world.delete === undefined) return context.skip();
      const log = subscribe('/a');
      const all = listen(world.port, { kind: 'glob', glob: `${root}/*` }, root);
      await world.settle();
      put('/a', 1);
      await world.settle();
      world.delete(`${root}/a`);
      await world.settle();
      expect(log.gone).toEqual(['/a']);
      expect(all.gone).toEqual(['/a']);
      put('/a', 2);
      await world.settle();
      expect(log.values()).toEqual(['/a=1', '/a=2']);
    });

    it('publishes for others and for itself', async () => {
      const log = subscribe('/out');
      await world.settle();
      const topic = `${root}/out`;
      const bytes = encodeRecord({ topic, format: 'double', value: 5, clientId: 'me' });
      expect(world.port.publish(topic, bytes, 3, 'session')).toBeUndefined();
      await world.settle();
      const seen = world.seenByOthers(topic);
      expect(seen && decodeRecord(seen)).toMatchObject({ topic, value: 5, clientId: 'me' });
      expect(log.values()).toEqual(['/out=5']);
    });

    it('[PM-47] refuses topics only the master publishes on, with a sentence', async () => {
      const bytes = encodeRecord({ topic: '/info/x', format: 'double', value: 5 });
      expect(world.port.publish('/info/x', bytes, 3, 'session')).toMatch(/\w+ \w+/);
      await world.settle();
      expect(world.seenByOthers('/info/x')).toBeUndefined();
    });
  });
}

/** Notes what comes, topics without their root. */
function listen(port: TopicPort, selector: TopicSelector, root: string) {
  const records: EncodedRecord[] = [];
  const gone: string[] = [];
  const cancel = port.subscribe(selector, {
    onRecord: (record) => records.push(record),
    onGone: (topic) => gone.push(topic.slice(root.length)),
  });
  const values = () =>
    records.map(
      ({ topic, bytes }) => `${topic.slice(root.length)}=${String(decodeRecord(bytes).value)}`,
    );
  return { records, gone, values, cancel };
}
