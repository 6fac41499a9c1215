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
        ours.publish('/to/guest', format, value as never);
        await guest.receives('/to/guest', value);
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
      ours.publish('/pattern/one', 'double', 2);
      await guest.receives('/pattern/one', 2);
      ours.publish('/pattern/two', 'string', 'later');
      await guest.receives('/pattern/two', 'later');
      expect(
        guest.events.all.filter((event) => event.event === 'record').map(({ topic }) => topic),
      ).toEqual(['/pattern/one', '/pattern/two']);
    });

    test('gets its own records back [TD-14]', async () => {
      const guest = await room.joins(kind);
      await guest.subscribeTopic('/echo');
      await guest.publish([{ topic: '/echo', double: 5 }]);
      await guest.receives('/echo', 5);
    });

    test('gets the last value of a topic when it subscribes [TD-24]', async () => {
      const ours = await room.oursJoins();
      const witness = ours.subscribe('/retained');
      await witness.ready;
      const seen = new Promise((resolve) => witness.onRecord(resolve));
      ours.publish('/retained', 'vector2', { x: 0, y: 9 });
      await seen;
      const guest = await room.joins(kind);
      await guest.subscribeTopic('/retained');
      await guest.events.waitFor(
        'the retained record as a frame',
        (event) => event.event === 'frame' && event.kind === 'record',
      );
      await guest.receives('/retained', { x: 0, y: 9 });
    });

    test('gets single records only, however our clients bundle them [TD-3]', async () => {
      const guest = await room.joins(kind);
      const ours = await room.oursJoins();
      await guest.subscribeTopic('/burst');
      for (let value = 1; value <= 100; value++) ours.publish('/burst', 'double', value);
      await guest.events.waitFor(
        'the hundredth frame',
        (event) => event.event === 'frame' && event.kind === 'record',
        100,
      );
      await guest.receives('/burst', 100);
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
    await speaker.publish([{ topic, vector2: value }]);
    await Promise.all(guests.map((guest) => guest.receives(topic, value)));
    await expect.poll(() => got.get(topic)).toEqual(value);
  }
  ours.publish('/round/ours', 'vector2', { x: 7, y: 7 });
  await Promise.all(guests.map((guest) => guest.receives('/round/ours', { x: 7, y: 7 })));
  expect(
    guests.map((guest): [ClientKind, readonly string[]] => [guest.kind, guest.complaints]),
  ).toEqual(kinds.map((kind) => [kind, []]));
});
