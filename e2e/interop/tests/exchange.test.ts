import { isDeepStrictEqual } from 'node:util';
import { describe, expect, test } from 'vitest';
import { CLIENT_KINDS, type ClientKind } from '../harness/client-kind.ts';
import { suiteName, useRoom, whyMissing } from '../harness/room.ts';

const room = useRoom();

/** A value of every kind of member that clients write in their own way. Zeros and false matter. */
const VALUES = [
  ['double', 0.25],
  ['double', 0],
  ['int32', -7],
  ['bool', false],
  ['string', 'größer ✓'],
  ['vector2', { x: 1, y: 0 }],
  ['vector3', { x: 0, y: -2.5, z: 3 }],
  ['color', { r: 1, g: 0.5, b: 0, a: 1 }],
] as const;

describe.each(CLIENT_KINDS)('%s', (kind) => {
  describe.skipIf(whyMissing(kind))(suiteName(kind), () => {
    test('gets what our client publishes, by topic [TD-14]', async () => {
      const guest = await room.joins(kind);
      const ours = await room.oursJoins();
      await guest.subscribeTopic('/to/guest');
      for (const [format, value] of VALUES) {
        await guest.isGiven('/to/guest', value, () =>
          ours.publish('/to/guest', format, value as never),
        );
      }
      expect(guest.complaints).toEqual([]);
    });

    test('publishes to our client one by one and in lists [TD-10]', async () => {
      const guest = await room.joins(kind);
      const ours = await room.oursJoins();
      const subscription = ours.subscribe({ glob: '/from/guest/**' });
      await subscription.ready;
      const got: unknown[] = [];
      subscription.onRecord((record) => got.push([record.topic, record.format, record.value]));
      await guest.publish([{ topic: '/from/guest/a', vector2: { x: 1, y: 0 } }], {
        immediately: true,
      });
      await expect.poll(() => got).toHaveLength(1);
      await guest.publish([
        { topic: '/from/guest/b', double: 2 },
        { topic: '/from/guest/c', string: 'three' },
        { topic: '/from/guest/b', double: 4 },
      ]);
      await expect
        .poll(() => got)
        .toEqual([
          ['/from/guest/a', 'vector2', { x: 1, y: 0 }],
          ['/from/guest/b', 'double', 2],
          ['/from/guest/c', 'string', 'three'],
          ['/from/guest/b', 'double', 4],
        ]);
    });

    test('gets what matches its regular expression, of topics that come later as well [TD-20]', async () => {
      const guest = await room.joins(kind);
      const ours = await room.oursJoins();
      // Python sends the text as it is and matches again by itself, as a shell pattern.
      await guest.subscribeRegex('/pattern/*');
      ours.publish('/elsewhere/one', 'double', 1);
      await guest.isGiven('/pattern/one', 2, () => ours.publish('/pattern/one', 'double', 2));
      await guest.isGiven('/pattern/two', 'later', () =>
        ours.publish('/pattern/two', 'string', 'later'),
      );
      const topics = guest.events.all.filter((event) => event.event === 'record');
      expect(new Set(topics.map(({ topic }) => topic))).toEqual(
        new Set(['/pattern/one', '/pattern/two']),
      );
    });

    test('gets its own records back [TD-14]', async () => {
      const guest = await room.joins(kind);
      await guest.subscribeTopic('/echo');
      await guest.isGiven('/echo', 5, () => guest.publish([{ topic: '/echo', double: 5 }]));
    });

    test('gets the last values of topics when it subscribes [TD-24] [EC-9]', async () => {
      const topics = Array.from({ length: 10 }, (_, index) => `/retained/${index}`);
      const ours = await room.oursJoins();
      const seen = new Set<string>();
      const witness = ours.subscribe({ glob: '/retained/*' });
      await witness.ready;
      witness.onRecord(({ topic }) => seen.add(topic));
      for (const topic of topics) ours.publish(topic, 'vector2', { x: 0, y: 9 });
      await expect.poll(() => seen.size).toBe(topics.length);

      const guest = await room.joins(kind);
      for (const topic of topics) await guest.subscribeTopic(topic);
      await guest.events.waitFor(
        'a retained record of each topic',
        (event) => event.event === 'frame' && event.kind === 'record',
        topics.length,
      );
      // nodejs and web nodes know the callback only some turns after the reply. The master waits a
      // moment for them; on a machine that is busy enough a record may still come too early.
      await guest.events.waitFor(
        'most retained records at the callback',
        (event) => event.event === 'record' && isDeepStrictEqual(event.value, { x: 0, y: 9 }),
        topics.length / 2,
      );
    });

    test('gets single records only, however our clients bundle them [TD-3] [EC-1]', async () => {
      const guest = await room.joins(kind);
      const ours = await room.oursJoins();
      await guest.subscribeTopic('/burst');
      for (let value = 1; value <= 100; value++) ours.publish('/burst', 'double', value);
      await guest.events.waitFor(
        'the hundredth frame',
        (event) => event.event === 'frame' && event.kind === 'record',
        100,
      );
      await guest.isGiven('/burst', 101, () => ours.publish('/burst', 'double', 101));
      expect([guest.frames('list'), guest.frames('error'), guest.frames('empty')]).toEqual([
        0, 0, 0,
      ]);
      expect(guest.complaints).toEqual([]);
    });
  });
});

test('all of them and ours speak with each other', async () => {
  const kinds = CLIENT_KINDS.filter((kind) => !whyMissing(kind));
  const guests = await Promise.all(kinds.map((kind) => room.joins(kind)));
  const ours = await room.oursJoins();
  const got = new Map<string, unknown>();
  const subscription = ours.subscribe({ regex: '^/round/' });
  await subscription.ready;
  subscription.onRecord((record) => got.set(record.topic, record.value));
  await Promise.all(guests.map((guest) => guest.subscribeRegex('/round/*')));

  for (const speaker of guests) {
    const topic = `/round/${speaker.kind}`;
    const value = { x: kinds.indexOf(speaker.kind), y: 0.5 };
    const speak = () => speaker.publish([{ topic, vector2: value }]);
    await Promise.all(guests.map((guest) => guest.isGiven(topic, value, speak)));
    await expect.poll(() => got.get(topic)).toEqual(value);
  }
  const value = { x: 7, y: 7 };
  const speak = () => ours.publish('/round/ours', 'vector2', value);
  await Promise.all(guests.map((guest) => guest.isGiven('/round/ours', value, speak)));
  expect(
    guests.map((guest): [ClientKind, readonly string[]] => [guest.kind, guest.complaints]),
  ).toEqual(kinds.map((kind) => [kind, []]));
});
