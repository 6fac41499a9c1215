import { encode } from '@ubii/proto';
import { HostileClient } from '../../fixtures/hostile-client.ts';
import type { MasterProcess } from '../../fixtures/master-process.ts';
import { expect, test } from '../../fixtures/test.ts';
import { MousePointerPage } from '../../pages/mouse-pointer-page.ts';

/** A master with pages and a few thousand topics takes some 150 MiB; what grows with every attack passes this soon. */
const MAX_RESIDENT_BYTES = 600 * 1024 * 1024;
const FRAME_LIMIT_BYTES = 32 * 1024 * 1024;

test.describe('while somebody hostile is in the room', () => {
  let anna: MousePointerPage;
  let ben: MousePointerPage;
  let hostile: HostileClient;
  let places = 0;

  test.beforeEach(async ({ master, room }) => {
    anna = new MousePointerPage(await room.atDesk('Anna'));
    ben = new MousePointerPage(await room.withPhone('Ben'));
    await Promise.all([anna.open(), ben.open()]);
    await othersDoNotNotice(master);
    hostile = await HostileClient.register(master.addresses);
  });

  test.afterEach(async ({ master }) => {
    await othersDoNotNotice(master);
    hostile.leave();
  });

  /** Both pointers still travel, the round trip is still measured, memory is bounded, services answer. */
  async function othersDoNotNotice(master: MasterProcess): Promise<void> {
    const at = 0.2 + (places++ % 7) / 10;
    await anna.pointTo({ x: at, y: 0.3 });
    await ben.pointTo({ x: at, y: 0.6 });
    await anna.expectPointer(anna.pointerOf('Ben'), { x: at, y: 0.6 });
    await ben.expectPointer(ben.pointerOf('Anna'), { x: at, y: 0.3 });
    await expect(anna.readout('p50')).toHaveText(/^\d+\.\d\s*ms$/);
    const health = await fetch(new URL('/health', master.url));
    expect(health.ok).toBe(true);
    const resident = await master.residentBytes();
    if (resident !== undefined) expect(resident).toBeLessThan(MAX_RESIDENT_BYTES);
  }

  test('garbage over the socket is refused with errors, then the socket is closed [TD-18]', async () => {
    const socket = await hostile.open();
    const garbage = [
      Uint8Array.of(),
      Uint8Array.of(0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff),
      Uint8Array.of(0x0a, 0x7f, 0x01),
      new Uint8Array(4096).fill(0x1b),
      // A record that says it is longer than the frame, and a topic that is no UTF-8.
      Uint8Array.of(0x12, 0xfe, 0xff, 0xff, 0xff, 0x07),
      Uint8Array.of(0x12, 0x04, 0x0a, 0x02, 0xc3, 0x28),
    ];
    for (let round = 0; round < 10; round++) for (const bytes of garbage) await socket.send(bytes);
    expect(await socket.closed).toBe(4008);
    expect(socket.errors.length).toBeGreaterThan(0);
    for (const message of socket.errors) expect(message).toMatch(/\S.*\.$/);
  });

  test('text that is not PING or PONG is a protocol error as well [TD-2]', async () => {
    const socket = await hostile.open();
    for (let count = 0; count < 40; count++) await socket.send('{"topic": "/hello"}');
    expect(await socket.closed).toBe(4008);
  });

  test('a frame that is too large ends the socket', async () => {
    const socket = await hostile.open();
    await socket.send(new Uint8Array(FRAME_LIMIT_BYTES + 1));
    expect(await socket.closed).toBe(1009);
  });

  test('a socket without a client, or with an invented one, is closed [TD-6]', async () => {
    expect(await hostile.openAs(undefined)).toBe(4004);
    expect(await hostile.openAs('00000000-0000-4000-8000-000000000000')).toBe(4004);
    expect(await hostile.openAs('../../etc/passwd')).toBe(4004);
    // Anna's id alone is not enough: her browser got a token with it.
    expect(await hostile.openAs(await anna.ownId())).toBe(4003);
  });

  test('nobody but the master writes on its topics [TD-16]', async () => {
    const socket = await hostile.open();
    const forged = ['/info/session/start', 'info/device/new', `/ubii/client/${await anna.ownId()}`];
    for (const topic of forged) await socket.publish([{ topic, string: 'forged' }]);
    await expect.poll(() => socket.errors).toHaveLength(forged.length);
    for (const [index, topic] of forged.entries()) expect(socket.errors[index]).toContain(topic);
  });

  test('ten thousand topics', async () => {
    const socket = await hostile.open();
    const topics = Array.from({ length: 10_000 }, (_, index) => `/hostile/${index % 100}/${index}`);
    const subscribed = await hostile.call({
      topic: '/services/topic_subscription',
      topicSubscription: { clientId: hostile.clientId, subscribeTopics: topics },
    });
    expect(subscribed.error).toBeUndefined();
    for (let first = 0; first < topics.length; first += 1_000) {
      const part = topics.slice(first, first + 1_000);
      await socket.publish(part.map((topic, index) => ({ topic, double: index })));
    }
    await expect
      .poll(async () => {
        const { stringList } = await hostile.call({ topic: '/services/topic_list' });
        return stringList?.elements.filter((topic) => topic.startsWith('/hostile/')).length;
      })
      .toBe(topics.length);
  });

  test('regular expressions that never end elsewhere [TD-21]', async () => {
    const socket = await hostile.open();
    const subscribe = (...subscribeTopicRegexp: string[]) =>
      hostile.call({
        topic: '/services/topic_subscription',
        topicSubscription: { clientId: hostile.clientId, subscribeTopicRegexp },
      });
    const accepted = await subscribe('^(a+)+$', '(x+x+)+y', '^(([a-z])+.)+[A-Z]([a-z])+$');
    expect(accepted.error).toBeUndefined();
    // Each of these topics keeps a backtracking matcher busy for longer than the universe is old.
    await socket.publish(
      Array.from({ length: 50 }, (_, index) => ({
        topic: `${'a'.repeat(200)}${'x'.repeat(200)}${index}!`,
        double: 1,
      })),
    );
    for (const pattern of ['(a)\\1', '(?=a)', '(', '(a{1000}){1000}', 'a'.repeat(100_000)]) {
      const { error } = await subscribe(pattern);
      expect(error?.message, `the answer to ${pattern.slice(0, 20)}`).toMatch(/\S.*\.$/);
    }
  });

  test('a flood of records, of errors and of calls', async () => {
    const socket = await hostile.open();
    const records = encode('ubii.topicData.TopicData', {
      topicDataRecordList: {
        elements: Array.from({ length: 1_000 }, (_, index) => ({
          topic: `/flood/${index % 10}`,
          vector3: { x: index, y: 0, z: 0 },
        })),
      },
    });
    const flood = async () => {
      for (let count = 0; count < 200; count++) await socket.send(records);
    };
    const calls = Array.from({ length: 500 }, () => hostile.call({ topic: '/services/nothing' }));
    await Promise.all([flood(), ...calls]);
    for (const reply of await Promise.all(calls)) expect(reply.error?.code).toBe('unimplemented');
  });

  test('somebody who subscribes to everything and reads nothing', async () => {
    const reader = await hostile.open();
    await hostile.call({
      topic: '/services/topic_subscription',
      topicSubscription: { clientId: hostile.clientId, subscribeTopicRegexp: ['.*'] },
    });
    reader.raw.pause();
    const writer = await HostileClient.register(hostile.addresses, 'writer');
    const socket = await writer.open();
    const picture = new Uint8Array(1024 * 1024);
    for (let count = 0; count < 150; count++) {
      await socket.publish([
        { topic: '/hostile/picture', image2D: { width: 512, height: 512, data: picture } },
      ]);
    }
    writer.leave();
  });

  test('requests that are no requests are answered in words [SV-7]', async () => {
    const bad: [BodyInit, string | undefined][] = [
      ['{"topic": ', 'application/json'],
      ['', 'application/json'],
      ['null', 'application/json'],
      ['[1, 2, 3]', 'application/json'],
      ['"text"', 'application/json'],
      ['{"topic": 7}', 'application/json'],
      ['{"topic": "/services/client/registration"}', 'application/json'],
      ['{"topic": "/services/no/such/service"}', 'application/json'],
      ['{"topic": "/services/client/registration", "client": []}', 'application/json'],
      [`${'['.repeat(100_000)}`, 'application/json'],
      [`{"topic": "/a", "__proto__": {"x": 1}, "constructor": 1}`, 'application/json'],
      ['topic=/services/client/registration', 'application/x-www-form-urlencoded'],
      ['<request/>', 'text/xml'],
      [new Uint8Array(1_000).fill(0xff), 'image/png'],
    ];
    for (const [body, contentType] of bad) {
      const answer = await hostile.post(body, contentType);
      const sent = `${contentType}: ${String(body).slice(0, 60)}`;
      expect(answer.status, sent).toBe(200);
      expect(answer.error?.message, sent).toMatch(/\S.*\.$/);
    }
    const binary = await hostile.post(
      new Uint8Array(100).fill(0xff),
      undefined,
      '/services/binary',
    );
    expect(binary.status).toBe(200);
  });

  test('a request that is too large is refused', async () => {
    const answer = await hostile.post(new Uint8Array(FRAME_LIMIT_BYTES + 1), 'application/json');
    expect(answer.error?.message).toMatch(/bytes/);
  });

  test('what is no HTTP, and what breaks off in the middle', async () => {
    await hostile.sendRawTcp('\u0000\u0001\u0002 hello\r\n\r\n');
    await hostile.sendRawTcp(new Uint8Array(70_000).fill(0x41));
    await hostile.breakOff(
      'POST /services/json HTTP/1.1\r\nHost: localhost\r\nContent-Length: 999\r\n\r\n{"to',
    );
    await hostile.breakOff('GET / HTTP/1.1\r\nHost: localhost\r\nX: ');
    await hostile.breakOff(
      'GET /?clientID=x HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\r\n',
    );
  });

  test('files outside the frontend are not served', async () => {
    for (const path of [
      '/../../package.json',
      '/..%2f..%2fpackage.json',
      '/assets/%2e%2e/%2e%2e/package.json',
    ]) {
      const answer = await hostile.get(path);
      expect(answer.text, path).not.toContain('"dependencies"');
    }
  });

  test('somebody who comes and goes all the time', async ({ master }) => {
    for (let count = 0; count < 100; count++) {
      const guest = await HostileClient.register(master.addresses, `guest ${count}`);
      await guest.open();
      guest.leave();
    }
  });
});
