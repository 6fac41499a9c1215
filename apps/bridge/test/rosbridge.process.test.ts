import { systemClock } from '@ubii/timing/system';
import { encode } from 'cborg';
import { Ros, Topic } from 'roslib';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { rosCodec } from '../src/adapters/rosbridge/ros-codec.ts';
import type { RosMessage } from '../src/adapters/rosbridge/ros-message.ts';
import { ROS_TYPES } from '../src/adapters/rosbridge/ros-types.ts';
import { createRosbridgeSystem } from '../src/adapters/rosbridge/rosbridge-system.ts';
import { foreignSystemSuite } from '../src/testing/foreign-system-suite.ts';
import { Inbox } from '../src/testing/inbox.ts';
import { mappingOf } from '../src/testing/mapping-of.ts';
import { isConnected, SystemEvents } from '../src/testing/system-events.ts';
import { joinAs, mappingFile, startBridge, startMaster } from './programs.ts';
import { startRosbridge } from './rosbridge-server.ts';

vi.setConfig({ testTimeout: 60_000 });

const FLOAT = 'std_msgs/Float64';

/** `roslib`, the client of the makers of rosbridge. */
async function openRos(url: string): Promise<Ros> {
  const ros = new Ros({});
  ros.on('error', () => undefined);
  const connected = new Promise<void>((resolve) => ros.once('connection', () => resolve()));
  await ros.connect(url);
  await connected;
  return ros;
}

function topicOf(ros: Ros, name: string, messageType = FLOAT, compression = 'none') {
  return new Topic<Record<string, unknown>>({ ros, name, messageType, compression });
}

foreignSystemSuite<RosMessage>('RosbridgeSystem', async () => {
  let server = await startRosbridge();
  const { port, url } = server;
  const system = createRosbridgeSystem({ url, ca: undefined, clock: systemClock, random: () => 0 });
  let ros = await openRos(url);
  const received = new Inbox<{ address: string; number: number }>();
  const listen = (): void => {
    for (const name of ['/suite/result', '/suite/early']) {
      topicOf(ros, name).subscribe(({ data }) =>
        received.add({ address: name, number: Number(data) }),
      );
    }
  };
  listen();
  return {
    system,
    received,
    // Single topics only.
    address: (level) => `/suite/${level === '+' ? 'first' : level === 'again' ? 'first' : level}`,
    mapping: (direction, foreign) => mappingOf(direction, foreign, '/x', { rosType: FLOAT }),
    payload: (number) => ({ data: number }),
    number: ({ data }) => Number(data),
    async publish(address, number) {
      await server.untilSubscribed(address);
      topicOf(ros, address).publish({ data: number });
    },
    outage: {
      async end() {
        ros.close();
        await server.close();
      },
      async begin() {
        server = await startRosbridge(port);
        ros = await openRos(url);
        listen();
      },
    },
    async close() {
      ros.close();
      await server.close();
    },
  };
});

describe('values and messages of ROS [BR-70]', () => {
  it.each([
    ['std_msgs/Bool', 'bool', true, { data: true }],
    ['std_msgs/String', 'string', 'a', { data: 'a' }],
    [FLOAT, 'double', 0.5, { data: 0.5 }],
    ['std_msgs/Int32', 'int32', 7, { data: 7 }],
    ['std_msgs/Float64MultiArray', 'doubleList', { elements: [1, 2] }, { data: [1, 2] }],
    ['std_msgs/ColorRGBA', 'color', { r: 1, g: 0, b: 0, a: 1 }, { r: 1, g: 0, b: 0, a: 1 }],
    ['geometry_msgs/Vector3', 'vector3', { x: 1, y: 2, z: 3 }, { x: 1, y: 2, z: 3 }],
    [
      'geometry_msgs/PointStamped',
      'vector3',
      { x: 1, y: 2, z: 3 },
      { point: { x: 1, y: 2, z: 3 } },
    ],
    [
      'geometry_msgs/Quaternion',
      'quaternion',
      { x: 0, y: 0, z: 0, w: 1 },
      { x: 0, y: 0, z: 0, w: 1 },
    ],
    [
      ...(['geometry_msgs/Pose', 'pose3D'] as const),
      { position: { x: 1, y: 2, z: 3 }, quaternion: { x: 0, y: 0, z: 0, w: 1 } },
      { position: { x: 1, y: 2, z: 3 }, orientation: { x: 0, y: 0, z: 0, w: 1 } },
    ],
    [
      ...(['geometry_msgs/Twist', 'doubleList', { elements: [1, 2, 3, 4, 5, 6] }] as const),
      { linear: { x: 1, y: 2, z: 3 }, angular: { x: 4, y: 5, z: 6 } },
    ],
    ['sensor_msgs/Joy', 'floatList', { elements: [0.5, -1] }, { axes: [0.5, -1], buttons: [] }],
    ['sensor_msgs/Joy', 'int32List', { elements: [0, 1] }, { axes: [], buttons: [0, 1] }],
    [
      ...(['sensor_msgs/CompressedImage', 'image2D'] as const),
      { width: 0, height: 0, dataFormat: 0, data: Buffer.from([0xff, 0xd8, 0xff, 1]) },
      { format: 'jpeg', data: '/9j/AQ==' },
    ],
    [
      ...(['sensor_msgs/Image', 'image2D'] as const),
      { width: 1, height: 2, dataFormat: 1, data: Uint8Array.of(1, 2, 3, 4, 5, 6) },
      { width: 1, height: 2, encoding: 'rgb8', step: 3, is_bigendian: 0, data: 'AQIDBAUG' },
    ],
  ] as const)('%s is %s', (rosType, format, value, message) => {
    const mapping = mappingOf('both', '/a', '/a', { rosType, format });
    const written = rosCodec.write(
      { topic: '/a', format, value, bytes: new Uint8Array() },
      mapping,
    );
    expect(written).toMatchObject(message);
    expect(rosCodec.read(written, mapping)).toMatchObject({ format, value });
  });

  it('reads rows with gaps, and blue before red', () => {
    const mapping = mappingOf('in', '/a', '/a', {
      rosType: 'sensor_msgs/Image',
      format: 'image2D',
    });
    const picture = { width: 1, height: 2, encoding: 'bgr8', step: 4 };
    const data = Buffer.from([3, 2, 1, 0, 6, 5, 4, 0]).toString('base64');
    expect(rosCodec.read({ ...picture, data }, mapping).value).toMatchObject({
      data: Uint8Array.of(1, 2, 3, 4, 5, 6),
    });
  });

  it('takes the time of a header', () => {
    const mapping = mappingOf('in', '/a', '/a', {
      rosType: 'geometry_msgs/PointStamped',
      format: 'vector3',
    });
    const point = { x: 1, y: 2, z: 3 };
    const read = (stamp: object) =>
      rosCodec.read({ header: { stamp }, point }, mapping).timestampMs;
    expect(read({ sec: 1_700_000_000, nanosec: 5e6 })).toBe(1_700_000_000_005);
    expect(read({ secs: 1_700_000_000, nsecs: 5e6 })).toBe(1_700_000_000_005);
    expect(read({ sec: 0, nanosec: 0 })).toBeUndefined();
  });

  it.each([
    ['std_msgs/Float64', 'double', {}, 'Expected a number'],
    ['std_msgs/Float64', 'double', { data: 'fast' }, 'Expected a number'],
    ['geometry_msgs/Vector3', 'vector3', { x: 1, y: 'a', z: 0 }, 'y'],
    ['std_msgs/Float64MultiArray', 'doubleList', { data: 1 }, 'Expected a list of numbers'],
    [
      'sensor_msgs/Image',
      'image2D',
      { width: 9, height: 9, encoding: 'rgb8', step: 27, data: '' },
      'too few',
    ],
    [
      'sensor_msgs/Image',
      'image2D',
      { width: 1, height: 1, encoding: 'bayer', step: 1, data: '' },
      'not supported',
    ],
    ['nav_msgs/Path', 'double', {}, 'nav_msgs/Path is not supported'],
  ] as const)('refuses %s as %s: %j', (rosType, format, message, reason) => {
    const mapping = mappingOf('in', '/a', '/a', { rosType, format });
    expect(() => rosCodec.read(message, mapping)).toThrow(reason);
  });

  it.each([
    ['std_msgs/Float64', 'double', { data: null }, Number.NaN],
    ['std_msgs/Float32', 'float', { data: Infinity }, Infinity],
    ['std_msgs/Float32MultiArray', 'floatList', { data: [1, null, 2] }, [1, Number.NaN, 2]],
    ['std_msgs/Int32', 'int32', { data: -(2 ** 31) }, -(2 ** 31)],
    ['std_msgs/Int64', 'double', { data: 2n ** 53n - 1n }, 2 ** 53 - 1],
    ['std_msgs/Int64', 'double', { data: -(2 ** 53) + 1 }, -(2 ** 53) + 1],
  ] as const)(
    'reads the numbers of %s as %s at their ends: %o [BR-72]',
    (rosType, format, message, value) => {
      const mapping = mappingOf('in', '/a', '/a', { rosType, format });
      const expected = Array.isArray(value) ? { elements: value } : value;
      expect(rosCodec.read(message, mapping).value).toEqual(expected);
    },
  );

  it('reads a vector with null as one with NaN, and never as one with 0 [BR-72]', () => {
    const mapping = mappingOf('in', '/a', '/a', {
      rosType: 'geometry_msgs/Vector3',
      format: 'vector3',
    });
    const { value } = rosCodec.read({ x: null, y: 1, z: 2 }, mapping);
    expect(value).toEqual({ x: Number.NaN, y: 1, z: 2 });
  });

  it.each([
    ['std_msgs/Int32', 'int32', { data: null }, 'Expected a number'],
    ['std_msgs/Int32', 'int32', { data: 2 ** 31 }, 'Expected a whole number from'],
    ['std_msgs/Int32MultiArray', 'int32List', { data: [null] }, 'must be an integer'],
    ['std_msgs/Int64', 'double', { data: 2 ** 53 }, 'below 2^53'],
    ['std_msgs/Int64', 'double', { data: -(2n ** 53n) }, 'below 2^53'],
  ] as const)(
    'refuses numbers that %s as %s does not carry: %o [BR-72]',
    (rosType, format, message, reason) => {
      const mapping = mappingOf('in', '/a', '/a', { rosType, format });
      expect(() => rosCodec.read(message, mapping)).toThrow(reason);
    },
  );

  it.each([
    ['std_msgs/Float64', 'double', Number.NaN],
    ['std_msgs/Float64', 'double', -Infinity],
    // Too large for single precision.
    ['std_msgs/Float32', 'double', 1e300],
    ['std_msgs/Float32MultiArray', 'floatList', { elements: [1, 1e300] }],
    ['geometry_msgs/Twist', 'doubleList', { elements: [0, 0, 0, 0, 0, Number.NaN] }],
    ['geometry_msgs/PointStamped', 'vector3', { x: 0, y: Infinity, z: 0 }],
  ] as const)('does not write null for a number: %s, %s, %o [BR-72]', (rosType, format, value) => {
    const mapping = mappingOf('out', '/a', '/a', { rosType });
    const record = { topic: '/a', format, value, bytes: new Uint8Array() };
    expect(() => rosCodec.write(record, mapping)).toThrow('no NaN and no infinity');
  });

  it('does not write what a type cannot carry', () => {
    const write = (rosType: string, format: 'double' | 'vector3', value: unknown) =>
      rosCodec.write(
        { topic: '/a', format, value, bytes: new Uint8Array() },
        mappingOf('out', '/a', '/a', { rosType }),
      );
    expect(() => write('std_msgs/UInt8', 'double', 256)).toThrow('Expected a number from 0 to 255');
    expect(() => write('std_msgs/Bool', 'vector3', {})).toThrow('std_msgs/Bool carries bool');
    expect(Object.keys(ROS_TYPES)).toContain('sensor_msgs/Joy');
  });
});

describe('rosbridge', () => {
  async function open() {
    const server = await startRosbridge();
    const system = createRosbridgeSystem({
      url: server.url,
      ca: undefined,
      clock: systemClock,
      random: () => 0,
    });
    const events = new SystemEvents<RosMessage>();
    system.open(events);
    await events.states.next(isConnected);
    onTestFinished(async () => {
      await system.close();
      await server.close();
    });
    return { server, system, messages: events.messages, refused: events.refused };
  }

  it('asks for compression, rate and queue, and reads CBOR [BR-71]', async () => {
    const { server, system, messages } = await open();
    const ros = await openRos(server.url);
    onTestFinished(() => ros.close());
    const mapping = mappingOf('in', '/scan', '/scan', {
      rosType: 'std_msgs/Float32MultiArray',
      format: 'floatList',
      compression: 'cbor',
      maxRateHz: 10,
      queueLength: 3,
    });
    system.setMappings([mapping]);
    await expect
      .poll(() => server.operations.at(-1))
      .toMatchObject({
        op: 'subscribe',
        topic: '/scan',
        type: 'std_msgs/Float32MultiArray',
        compression: 'cbor',
        throttle_rate: 100,
        queue_length: 3,
      });
    await server.untilSubscribed('/scan');
    topicOf(ros, '/scan', 'std_msgs/Float32MultiArray').publish({ data: [0.5, 1.5] });
    const { payload } = await messages.next();
    expect(rosCodec.read(payload, mapping).value).toEqual({ elements: [0.5, 1.5] });
    // As rosbridge sends lists of numbers: tag 85 of RFC 8746 and bytes, little-endian.
    const values = new Uint8Array(new Float32Array([2.5]).buffer);
    const [start, end] = encode({ op: 'publish', topic: '/scan', msg: { data: 'X' } })
      .toString()
      .split(',97,88');
    const typed = Uint8Array.from([
      ...start!.split(',').map(Number),
      ...[0xd8, 85, 0x40 + values.length, ...values],
      ...(end ?? '')
        .split(',')
        .filter((byte) => byte !== '')
        .map(Number),
    ]);
    server.sendAll(typed);
    expect(rosCodec.read((await messages.next()).payload, mapping).value).toEqual({
      elements: [2.5],
    });
  });

  it('keeps the subscriptions of mappings that do not change [BR-4]', async () => {
    const { server, system } = await open();
    const [kept, gone, next] = ['/kept', '/gone', '/next'].map((topic) =>
      mappingOf('in', topic, topic, { rosType: FLOAT }),
    );
    system.setMappings([kept!, gone!]);
    system.setMappings([structuredClone(kept!), next!]);
    await expect
      .poll(() => server.operations.map(({ op, topic }) => `${op} ${topic}`))
      .toEqual(['subscribe /kept', 'subscribe /gone', 'unsubscribe /gone', 'subscribe /next']);
  });

  it('advertises each topic once, with its type, before its first message [BR-71]', async () => {
    const { server, system, refused } = await open();
    const mapping = mappingOf('out', '/robots/{1}', '/robots/*', {
      rosType: FLOAT,
      retained: true,
    });
    const send = (address: string) => system.send({ address, mapping, payload: { data: 1 } }).kind;
    expect([send('/robots/a'), send('/robots/a'), send('/robots/b')]).toEqual([
      'sent',
      'sent',
      'sent',
    ]);
    expect(send('/robots/a b')).toBe('refused');
    await expect
      .poll(() => server.operations.map(({ op, topic }) => `${op} ${topic}`))
      .toEqual([
        ...['advertise /robots/a', 'publish /robots/a', 'publish /robots/a'],
        ...['advertise /robots/b', 'publish /robots/b'],
      ]);
    expect(server.operations[0]).toMatchObject({ type: FLOAT, latch: true });
    const other = { ...mapping, rosType: 'std_msgs/Bool' };
    system.send({ address: '/robots/a', mapping: other, payload: { data: true } });
    expect(await refused.next()).toContain('already established with type std_msgs/Float64');
  });

  it('advertises 1000 topics at once, and gives the oldest back [BR-71]', async () => {
    const { server, system } = await open();
    const mapping = mappingOf('out', '/many/{1}', '/many/*', { rosType: FLOAT, maxTopics: 10_000 });
    const send = (index: number) =>
      system.send({ address: `/many/t${index}`, mapping, payload: { data: 1 } });
    for (let index = 0; index <= 1_000; index++) send(index);
    send(1_000);
    send(0);
    const count = (wanted: string) => server.operations.filter(({ op }) => op === wanted).length;
    await expect.poll(() => count('publish')).toBe(1_003);
    const given = server.operations.filter(({ op }) => op === 'unadvertise');
    expect(given.map(({ topic }) => topic)).toEqual(['/many/t0', '/many/t1']);
    expect(count('advertise')).toBe(1_002);
  });

  it('sends user and password only to the proxy in front of rosbridge [BR-43]', async () => {
    const server = await startRosbridge();
    const system = createRosbridgeSystem({
      url: server.url,
      ca: undefined,
      clock: systemClock,
      random: () => 0,
      user: 'ada',
      password: 'secret',
    });
    const connected = new Promise<void>((resolve) => {
      system.open({
        handleMessage: () => undefined,
        handleRefused: () => undefined,
        handleDropped: () => undefined,
        handleSettled: () => undefined,
        handleState: ({ status }) => status === 'connected' && resolve(),
      });
    });
    onTestFinished(async () => {
      await system.close();
      await server.close();
    });
    await connected;
    expect(server.logins).toEqual([`Basic ${btoa('ada:secret')}`]);
  });

  it('refuses what is no message, and other kinds of messages [BR-30]', async () => {
    const { server, refused, messages } = await open();
    for (const [frame, reason] of [
      ['{', 'No message of rosbridge: The message is not JSON'],
      ['3', 'The message is no object'],
      [Uint8Array.of(0xff), 'No message of rosbridge'],
      ['{"op":"png","data":""}', 'Messages of the kind png are not taken'],
      [`{"op":"publish","topic":"/a","msg":${'['.repeat(40)}}`, 'more than 32 levels'],
    ] as const) {
      server.sendAll(frame);
      expect(await refused.next()).toContain(reason);
    }
    expect(messages.all).toEqual([]);
  });

  it('passes values between topics and roslib, and sends nothing back [BR-2] [BR-23]', async () => {
    const server = await startRosbridge();
    onTestFinished(() => server.close());
    const ros = await openRos(server.url);
    onTestFinished(() => ros.close());
    const { url } = await startMaster();
    const client = await joinAs(url);
    const file = mappingFile({
      mappings: [
        {
          direction: 'both',
          foreign: '/speed',
          topic: '/robot/speed',
          format: 'double',
          type: 'std_msgs/Float32',
        },
      ],
    });
    const bridge = startBridge([server.url.replace('ws:', 'rosbridge:')], url, file);
    await bridge.says('Connected to ws:');
    const values: unknown[] = [];
    const records = client.subscribe({ topic: '/robot/speed' }, { format: 'double' });
    records.onRecord(({ value }) => values.push(value));
    await records.ready;
    const heard = new Inbox<unknown>();
    topicOf(ros, '/speed', 'std_msgs/Float32').subscribe(({ data }) => heard.add(data));
    await expect
      .poll(() => server.operations.filter(({ op }) => op === 'subscribe').length)
      .toBe(2);
    client.publish('/robot/speed', 'double', 0.1);
    expect(await heard.next()).toBeCloseTo(0.1);
    topicOf(ros, '/speed', 'std_msgs/Float32').publish({ data: 0.5 });
    await expect.poll(() => values.at(-1)).toBe(0.5);
    // The first value did not come back as another record, rounded as ROS has it.
    expect(values).toEqual([0.1, 0.5]);
  });
});
