import { networkInterfaces } from 'node:os';
import { afterEach, describe, expect, test } from 'vitest';
import { loadOldSchema } from '../harness/old-schema.ts';
import { RawClient } from '../harness/raw-client.ts';
import { useRoom } from '../harness/room.ts';

const room = useRoom();

const guests: RawClient[] = [];
afterEach(() => {
  for (const guest of guests.splice(0)) guest.close();
});

async function enter(register: 'callJson' | 'callBinary', name: string) {
  const guest = new RawClient(room.legacy, loadOldSchema());
  guests.push(guest);
  const reply = await guest[register]({
    topic: '/services/client/registration',
    client: { name },
  });
  const { id } = reply['client'] as { id: string };
  return { guest, id };
}

const subscribe = (clientId: string, topic: string) => ({
  topic: '/services/topic_subscription',
  topicSubscription: { clientId, subscribeTopics: [topic] },
});

describe('web browser node 0.3.4, by hand', () => {
  test('subscribes before its socket is open and gets the last value once it is [TD-24] [EC-8]', async () => {
    const ours = await room.oursJoins();
    const witness = ours.subscribe('/kept');
    await witness.ready;
    const kept = new Promise((resolve) => witness.onRecord(resolve));
    ours.publish('/kept', 'vector2', { x: 0, y: 4 });
    await kept;

    const { guest, id } = await enter('callJson', 'web node 0.3.4');
    expect(await guest.callJson(subscribe(id, '/kept'))).toHaveProperty('success');
    await guest.open(id, '/topicdata');
    expect(await guest.receives('/kept')).toMatchObject({ vector2: { x: 0, y: 4 } });
  });

  test('is told of new devices with their components [CL-30]', async () => {
    const { guest, id } = await enter('callJson', 'web node 0.3.4');
    await guest.open(id);
    await guest.callJson(subscribe(id, '/info/device/new'));
    const ours = await room.oursJoins();
    await ours.registerDevice({
      name: 'knob',
      components: [{ name: 'angle', format: 'double', topic: '/knob/angle' }],
    });
    expect(await guest.receives('/info/device/new')).toMatchObject({
      device: { name: 'knob', components: [{ name: 'angle', topic: '/knob/angle' }] },
    });
  });

  test('subscribes to components with one profile and gets a list it can iterate [CL-21] [TD-27]', async () => {
    const { guest, id } = await enter('callJson', 'web node 0.3.4');
    await guest.open(id);
    const profile = { tags: ['heart'] };
    await guest.callJson({
      topic: '/services/topic_subscription',
      topicSubscription: { clientId: id, subscribeComponents: [profile] },
    });
    const ask = { topic: '/services/component/get_list', component: profile };
    expect(await guest.callJson(ask)).toMatchObject({ componentList: { elements: [] } });

    const ours = await room.oursJoins();
    const device = await ours.registerDevice({
      name: 'belt',
      components: [{ name: 'pulse', format: 'double', topic: '/belt/pulse', tags: ['heart'] }],
    });
    device.component('pulse').publish(72);
    expect(await guest.receives('/belt/pulse')).toMatchObject({ double: 72 });
    expect(await guest.callJson(ask)).toMatchObject({
      componentList: { elements: [{ name: 'pulse' }] },
    });
  });

  test('unsubscribes without saying who it is, and is answered [SV-12]', async () => {
    const { guest } = await enter('callJson', 'web node 0.3.4');
    const reply = await guest.callJson({
      topic: '/services/topic_subscription',
      topicSubscription: { unsubscribeTopics: ['/a'], unsubscribeTopicRegexp: ['b'] },
    });
    expect(reply).toHaveProperty('error.message');
  });
});

describe('Unity node, by hand', () => {
  test('speaks protobuf over HTTP on both paths [SV-1] [EC-6]', async () => {
    const { guest } = await enter('callBinary', 'Unity node');
    for (const path of ['/services/binary', '/services']) {
      const reply = await guest.callBinary({ topic: '/services/server_configuration' }, path);
      expect(reply['server']).toMatchObject({
        portTopicDataWs: expect.stringMatching(/^\d+$/),
        portTopicDataZmq: expect.stringMatching(/^\d+$/),
      });
    }
  });

  test('answers pings with binary frames and stays active [TD-2] [EC-2]', async () => {
    const { guest, id } = await enter('callBinary', 'Unity node');
    await guest.open(id, '', Buffer.from('PONG'));
    await guest.frames.waitFor(
      'the third ping',
      (frame) => 'text' in frame && frame.text === 'PING',
      3,
    );
    const ours = await room.oursJoins();
    const listed = await room.listed(ours, id);
    expect(listed?.state).toBe(0);
    expect(listed?.latency).toBeGreaterThan(0);
  });

  test('gets zeros that were written as zeros: its buffer keeps what is left out [TD-11] [EC-17]', async () => {
    const { guest: speaker, id: speakerId } = await enter('callJson', 'speaker');
    await speaker.open(speakerId);
    const { guest, id } = await enter('callBinary', 'Unity node');
    await guest.open(id);
    await guest.callBinary(subscribe(id, '/zeros'));
    speaker.publish({ topic: '/zeros', vector3: { x: 0, y: 0, z: 0 } });
    const record = await guest.receives('/zeros');
    // The published decoder gives own properties only to what was on the wire.
    expect(Object.keys(record['vector3'] as object)).toEqual(['x', 'y', 'z']);
  });
});

describe('older applications, by hand', () => {
  test('post JSON to /services and open a socket under any path [SV-1] [TD-1] [EC-6] [EC-7]', async () => {
    const { guest, id } = await enter('callJson', 'old application');
    expect(await guest.callJson({ topic: '/services/service_list' }, '/services')).toHaveProperty(
      'serviceList.elements',
    );
    await guest.open(id, '/some/other/path');
    await guest.callJson(subscribe(id, '/here'));
    guest.publish({ topic: '/here', string: 'there' });
    expect(await guest.receives('/here')).toMatchObject({ string: 'there' });
  });

  test('a page of the original frontend may call from its own port [SV-8]', async () => {
    const response = await fetch(room.legacy.services, {
      method: 'OPTIONS',
      headers: {
        origin: 'http://localhost:8080',
        'access-control-request-method': 'POST',
        'access-control-request-headers': 'content-type',
      },
    });
    expect(response.ok).toBe(true);
    expect(response.headers.get('access-control-allow-origin')).toBe('http://localhost:8080');
    expect(response.headers.get('access-control-allow-headers')?.toLowerCase()).toContain(
      'content-type',
    );
  });

  // The Python node names the address its hostname resolves to, which is not the loopback everywhere.
  test('a program of this machine may name one of its own addresses as its origin [SV-8]', async () => {
    const own = Object.values(networkInterfaces())
      .flatMap((addresses) => addresses ?? [])
      .filter(({ family }) => family === 'IPv4')
      .map(({ address }) => address);
    for (const address of own) {
      const response = await fetch(room.legacy.services, {
        method: 'POST',
        headers: { 'content-type': 'application/json', origin: `http://${address}:8080` },
        body: JSON.stringify({ topic: '/services/server_configuration' }),
      });
      expect([address, response.status]).toEqual([address, 200]);
    }
  });
});
