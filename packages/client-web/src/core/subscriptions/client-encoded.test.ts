import { DATA_FORMATS, decodeRecord, encodeRecord } from '@ubii/proto';
import type { RecordInit, TopicRecord } from '@ubii/proto';
import {
  encodeErrorFrame,
  encodeLockstepRequestFrame,
  encodeNodeMessageFrame,
  encodeRecordListFrame,
} from '@ubii/proto/wire';
import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';
import { LIBRARY_NAME } from '../connection/library-name.ts';
import type { EncodedRecord } from './encoded-record.ts';
import type { TopicPattern } from './topic-pattern.ts';
import type { UbiiClient } from '../client/ubii-client.ts';

async function setup() {
  const master = new FakeMaster();
  const all = createTestClient(master);
  await all.client.connect();
  return { master, ...all };
}

function collect(client: UbiiClient, pattern: string | TopicPattern) {
  const records: EncodedRecord[] = [];
  const gone: string[] = [];
  const cancel = client.subscribeEncoded(pattern, {
    onRecord: (record) => records.push(record),
    onGone: (topic) => gone.push(topic),
  });
  return { records, gone, cancel };
}

const valuesOf = (records: readonly EncodedRecord[]) =>
  records.map(({ bytes }) => decodeRecord(bytes).value);

const image = (topic: string, side = 200): RecordInit => ({
  topic,
  format: 'image2D',
  value: { width: side, height: side, data: new Uint8Array(side * side).fill(7) },
  clientId: 'camera',
});

const int32 = (topic: string, value: number): RecordInit => ({ topic, format: 'int32', value });

describe('client.subscribeEncoded()', () => {
  it('hands over the bytes, the value field and the publisher of each record', async () => {
    const { master, client } = await setup();
    const { records } = collect(client, '/a');
    await settle();
    const record: RecordInit = { topic: '/a', format: 'bool', value: true, clientId: 'ben' };
    master.publish(record);
    await settle();
    expect(records).toEqual([
      {
        topic: '/a',
        bytes: encodeRecord(record),
        valueField: DATA_FORMATS.bool.fieldNumber,
        publisherId: 'ben',
        isOwned: false,
      },
    ]);
  });

  it('takes all kinds of patterns, and ends when told so', async () => {
    const { master, client } = await setup();
    const byGlob = collect(client, { glob: '/a/*' });
    const byRegex = collect(client, { regex: '^/a' });
    await settle();
    master.publish(int32('/a/x', 1));
    await settle();
    byGlob.cancel();
    await settle();
    master.publish(int32('/a/x', 2));
    await settle();
    expect(valuesOf(byGlob.records)).toEqual([1]);
    expect(valuesOf(byRegex.records)).toEqual([1, 2]);
    expect(master.holds(client.id).regexes).toEqual(['^/a']);
  });

  it('knows the topics of component profiles', async () => {
    const { master, client } = await setup();
    await client.registerDevice({
      name: 'mouse',
      components: [{ name: 'position', format: 'vector2', tags: ['pointer'], topic: '/m' }],
    });
    const { records } = collect(client, { component: { tags: ['pointer'] } });
    await settle();
    master.publish({ topic: '/m', format: 'vector2', value: { x: 1, y: 2 } });
    await settle();
    expect(valuesOf(records)).toEqual([{ x: 1, y: 2 }]);
  });

  it('shares a record with ordinary subscriptions, in the order of arrival', async () => {
    const { master, client } = await setup();
    const { records } = collect(client, '/a');
    const decoded: TopicRecord[] = [];
    client.subscribe('/a').onRecord((record) => decoded.push(record));
    await settle();
    master.sendBytes(encodeRecordListFrame([1, 2, 3].map((n) => encodeRecord(int32('/a', n)))));
    await settle();
    expect(valuesOf(records)).toEqual([1, 2, 3]);
    expect(decoded.map(({ value }) => value)).toEqual([1, 2, 3]);
    expect(client.counters).toMatchObject({ recordsIn: 3, decodeErrors: 0 });
  });

  it('[PM-36] transfers the buffer of the frame when there is only one receiver of its image', async () => {
    const { master, client } = await setup();
    const { records } = collect(client, '/cam');
    await settle();
    master.publish(image('/cam'));
    await settle();
    const [record] = records;
    expect(record).toMatchObject({ isOwned: true, publisherId: 'camera' });
    // A view of the frame that arrived: the bytes were not copied.
    expect(record!.bytes.byteOffset).toBeGreaterThan(0);
    structuredClone(record!.bytes, { transfer: [record!.bytes.buffer as ArrayBuffer] });
    master.publish(image('/cam'));
    await settle();
    expect(valuesOf(records.slice(1))).toMatchObject([{ width: 200 }]);
  });

  it('gives it away beside small records, which have memory of their own then', async () => {
    const { master, client } = await setup();
    const camera = collect(client, '/cam');
    const small = collect(client, '/a');
    const decoded: TopicRecord[] = [];
    client.subscribe('/a').onRecord((record) => decoded.push(record));
    await settle();
    master.sendBytes(
      encodeRecordListFrame([int32('/a', 1), image('/cam'), int32('/a', 2)].map(encodeRecord)),
    );
    await settle();
    const { bytes, isOwned } = camera.records[0]!;
    expect(isOwned).toBe(true);
    structuredClone(bytes, { transfer: [bytes.buffer as ArrayBuffer] });
    expect(valuesOf(small.records)).toEqual([1, 2]);
    expect(decoded.map(({ value }) => value)).toEqual([1, 2]);
  });

  it('keeps the buffer when there is another receiver of the image, or another image in it', async () => {
    const { master, client } = await setup();
    const first = collect(client, '/cam');
    const second = collect(client, { glob: '/cam' });
    const other = collect(client, '/other');
    await settle();
    master.publish(image('/cam'));
    master.sendBytes(encodeRecordListFrame([image('/other'), image('/other')].map(encodeRecord)));
    await settle();
    expect([...first.records, ...second.records, ...other.records]).toHaveLength(4);
    for (const { isOwned } of [...first.records, ...second.records, ...other.records]) {
      expect(isOwned).toBe(false);
    }
  });

  it('requests a transferred image again for a later receiver', async () => {
    const { master, client } = await setup();
    const first = collect(client, '/cam');
    await settle();
    master.publish(image('/cam'));
    await settle();
    expect(first.records[0]?.isOwned).toBe(true);
    const decoded: TopicRecord[] = [];
    client.subscribe('/cam').onRecord((record) => decoded.push(record));
    await settle();
    await settle();
    expect(decoded).toMatchObject([{ topic: '/cam', value: { width: 200 } }]);
    expect(master.holds(client.id).topics).toEqual(['/cam']);
  });

  it('gives a later subscriber of the same pattern the newest record at once', async () => {
    const { master, client } = await setup();
    client.subscribe('/a').onRecord(() => undefined);
    await settle();
    master.publish(int32('/a', 1));
    await settle();
    const { records } = collect(client, '/a');
    expect(valuesOf(records)).toEqual([1]);
    expect(records[0]).toMatchObject({ valueField: DATA_FORMATS.int32.fieldNumber });
  });

  it('[TD-42] says when a topic has no value any more, and forgets the value', async () => {
    const { master, client } = await setup();
    const first = collect(client, '/a');
    const decoded: TopicRecord[] = [];
    client.subscribe('/a').onRecord((record) => decoded.push(record));
    await settle();
    master.publish(int32('/a', 1));
    master.publish({ topic: '/a' });
    await settle();
    expect(first.gone).toEqual(['/a']);
    expect(decoded).toHaveLength(1);
    const second = collect(client, '/a');
    expect(second.records).toEqual([]);
  });

  it('[TD-42] says so after a reconnect, too, of values that went meanwhile', async () => {
    const { master, client, clock } = await setup();
    const { records, gone } = collect(client, { glob: '/*' });
    await settle();
    for (const topic of ['/a', '/b', '/c']) master.publish(int32(topic, 1));
    await settle();
    master.restart();
    master.publish(int32('/b', 2));
    await clock.advance(10_000);
    expect(gone.sort()).toEqual(['/a', '/c']);
    master.publish(int32('/a', 3));
    await settle();
    expect(valuesOf(records).at(-1)).toBe(3);
  });

  it('stands through a reconnect', async () => {
    const { master, client, clock } = await setup();
    const { records } = collect(client, '/a');
    await settle();
    master.restart();
    await clock.advance(10_000);
    master.publish(int32('/a', 5));
    await settle();
    expect(valuesOf(records)).toEqual([5]);
  });

  it('gets what is whole of a frame that is broken, and the fault is told once', async () => {
    const { master, client, problems } = await setup();
    const { records } = collect(client, '/a');
    await settle();
    const broken = encodeRecord(int32('/a', 300)).slice();
    broken[broken.length - 1] = 0xff; // a number without an end
    master.sendBytes(
      encodeRecordListFrame([encodeRecord(int32('/a', 1)), broken, encodeRecord(int32('/a', 2))]),
    );
    await settle();
    expect(valuesOf(records)).toEqual([1, 2]);
    expect(problems).toHaveLength(1);
    expect(client.counters.decodeErrors).toBe(1);
  });

  it('leaves the errors of the master to onError', async () => {
    const { master, client, problems } = await setup();
    collect(client, '/a');
    await settle();
    master.sendBytes(
      encodeErrorFrame({ title: 't', message: 'refused', code: 'invalid_argument' }),
    );
    await settle();
    expect(problems).toMatchObject([{ code: 'invalid_argument' }]);
  });
});

describe('client.publishEncoded()', () => {
  it('sends the records of a turn as one frame, at its end, in order with the others', async () => {
    const { master, client } = await setup();
    client.setPublishIntervalMs(1_000);
    client.publish('/first', 'int32', 0);
    await settle();
    for (const n of [1, 2, 3]) {
      client.publishEncoded('/a', encodeRecord(int32('/a', n)), DATA_FORMATS.int32.fieldNumber);
    }
    await settle();
    expect(master.published.map(({ value }) => value)).toEqual([0, 1, 2, 3]);
    expect(master.frameSizes.at(-1)).toBeGreaterThanOrEqual(3);
  });

  it('keeps the newest of a topic while there is no connection', async () => {
    const { master, client, clock } = await setup();
    master.stop();
    await settle();
    for (const n of [1, 2]) client.publishEncoded('/a', encodeRecord(int32('/a', n)), 1);
    master.isDown = false;
    await clock.advance(10_000);
    expect(master.published.map(({ value }) => value)).toEqual([2]);
  });
});

describe('node messages', () => {
  it('[EX-20] arrive with their records encoded, also beside records', async () => {
    const { master, client } = await setup();
    const passes: unknown[] = [];
    client.onNodeMessage(({ lockstepRequest }) => passes.push(lockstepRequest));
    const record = encodeRecord(int32('/a', 1));
    master.sendBytes(encodeLockstepRequestFrame({ pass: 3, sessionId: 's' }, [record]));
    await settle();
    expect(passes).toMatchObject([{ head: { pass: 3, sessionId: 's' }, records: [record] }]);
  });

  it('leave after what was published before', async () => {
    const { master, client } = await setup();
    client.setPublishIntervalMs(1_000);
    client.publish('/first', 'int32', 0);
    await settle();
    client.publish('/second', 'int32', 0);
    const frame = encodeNodeMessageFrame({ moduleReports: { statistics: [{ moduleId: 'm' }] } });
    expect(client.sendNodeMessage(frame)).toBe(true);
    await settle();
    expect(master.published.map(({ topic }) => topic)).toEqual(['/first', '/second']);
    expect(master.nodeMessages).toMatchObject([
      { moduleReports: { statistics: [{ moduleId: 'm' }] } },
    ]);
  });

  it('are not sent without a connection, nor to an original master', async () => {
    const { client } = createTestClient(new FakeMaster({ isOriginal: true }));
    expect(client.sendNodeMessage(new Uint8Array(3))).toBe(false);
    await client.connect();
    expect(client.sendNodeMessage(new Uint8Array(3))).toBe(false);
  });
});

describe('what a client is as a node', () => {
  const module = { name: 'mirror', inputs: [{ internalName: 'in', messageFormat: 'double' }] };

  it('[PM-60] is told at registration', async () => {
    const master = new FakeMaster();
    const { client } = createTestClient(master, {
      node: { runsJavascript: true, libraries: ['http'] },
      processingModules: [module],
      isDedicatedNode: true,
    });
    await client.connect();
    expect(master.requests[0]?.client).toMatchObject({
      isDedicatedProcessingNode: true,
      processingModules: [module],
      extension: {
        recordLists: true,
        library: LIBRARY_NAME,
        node: { runsJavascript: true, libraries: ['http'] },
      },
    });
  });

  it('is not spoken of by a client that is none', async () => {
    const { master } = await setup();
    const { client } = master.requests[0]!;
    expect(client).toMatchObject({ isDedicatedProcessingNode: false, processingModules: [] });
    expect(client?.extension?.node).toBeUndefined();
  });

  it('can change while connected, under the same id', async () => {
    const { master, client } = await setup();
    const { id } = client;
    await client.updateProfile({ processingModules: [module], node: { acceptsWork: true } });
    expect(client.id).toBe(id);
    expect(master.requests.at(-1)?.client).toMatchObject({
      id,
      processingModules: [module],
      extension: { node: { acceptsWork: true } },
    });
  });
});
