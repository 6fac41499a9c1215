import { encodeRecord, type Image2D } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { emptyRecord } from '../src/testing/test-client.ts';

const TOPIC = '/ada/camera/image';
const PICTURE_BYTES = 100_000;

function picture(number: number): Image2D {
  const data = new Uint8Array(PICTURE_BYTES).fill(number);
  return { width: 250, height: 400, dataFormat: 0, data };
}

function take(client: TestClient, number: number, expiryMs: number, keepSeconds = 0): void {
  const value = picture(number);
  client.sendRecords(
    encodeRecord({ topic: TOPIC, format: 'image2D', value, expiryMs, keepSeconds }),
  );
}

async function createCamera() {
  const master = new TestMaster();
  const ada = await master.extension('ada');
  const retained = async (): Promise<number> => {
    const { limitList } = await master.call({ topic: '/services/ubii/limit_list' });
    return limitList!.elements.find(({ name }) => name === 'retainedBytes')!.use!.value;
  };
  const statistic = async () => {
    const { topicStatistics } = await master.call({
      topic: '/services/ubii/topic_statistics',
      topicStatisticsRequest: {},
    });
    return topicStatistics!.elements.find(({ topic }) => topic === TOPIC);
  };
  /** The camera is on, and every client says that it is there. */
  const stream = async (seconds: number, rateHz: number, ...clients: TestClient[]) => {
    for (let i = 0; i < seconds * rateHz; i++) {
      take(ada, i % 256, Math.max(1000, 3000 / rateHz));
      for (const one of [ada, ...clients]) one.sendText('PONG');
      await master.pass(1000 / rateHz);
    }
  };
  return { master, ada, retained, statistic, stream, before: await retained() };
}

const numbersOf = (client: TestClient): number[] =>
  client
    .takeRecords()
    .flatMap(({ value }) => (value === undefined ? [-1] : [(value as Image2D).data[0]!]));

describe('values that expire', () => {
  it('stand for as long as newer records come, for subscribers that come late as well [TD-47]', async () => {
    const { master, stream, statistic } = await createCamera();
    for (const [seconds, rateHz] of [
      [1, 30],
      [4, 1],
    ] as const) {
      await stream(seconds, rateHz);
      const late = await master.legacy('late');
      await late.subscribe({ subscribeTopics: [TOPIC] });
      expect(numbersOf(late)).toHaveLength(1);
      expect((await statistic())!.valueBytes).toBeGreaterThan(PICTURE_BYTES);
    }
  });

  it('are deleted when no newer record comes, though their client is there [TD-47]', async () => {
    const { master, ada, stream, statistic, retained, before } = await createCamera();
    await stream(2, 10);
    expect(await retained()).toBeGreaterThan(before + PICTURE_BYTES);
    await master.pass(850);
    expect(await statistic()).toBeDefined();
    await master.pass(400);
    expect(await statistic()).toBeUndefined();
    expect(await retained()).toBe(before);
    expect(ada.takeErrors()).toEqual([]);
    const late = await master.extension('late');
    await late.subscribe({ subscribeTopics: [TOPIC] });
    expect(late.takeRecords()).toEqual([]);
    take(ada, 7, 1000);
    await master.pass();
    expect(numbersOf(late)).toEqual([7]);
  });

  it('are deleted within half a second when their client ends the topic [TD-48]', async () => {
    const { master, ada, stream, statistic, retained } = await createCamera();
    const viewer = await master.legacy('viewer');
    await viewer.subscribe({ subscribeTopics: [TOPIC] });
    const before = await retained();
    await stream(2, 1, viewer);
    viewer.takeSent();
    ada.sendRecords(encodeRecord({ topic: TOPIC, expiryMs: 1 }));
    // The picture is gone with the record that ends the topic.
    expect(await retained()).toBeLessThan(before + 200);
    await master.pass(500);
    expect((await statistic())!.valueBytes).toBe(0);
    expect(await retained()).toBe(before);
    expect(numbersOf(viewer)).toEqual([-1]);
  });

  it('end for modules and nodes like all values that are deleted [TD-42]', async () => {
    const { master, stream } = await createCamera();
    const node = await master.extension('node', {
      extension: { recordLists: true, node: { runsJavascript: true } },
    });
    const plain = await master.extension('plain');
    for (const client of [node, plain]) await client.subscribe({ subscribeTopics: [TOPIC] });
    await stream(1, 10, node, plain);
    node.takeSent();
    plain.takeSent();
    await master.pass(1500);
    expect(numbersOf(node)).toEqual([-1]);
    expect(plain.takeRecords()).toEqual([]);
  });

  it('do not wait for subscribers that take nothing [TD-47]', async () => {
    const { master, stream, statistic } = await createCamera();
    const slow = await master.extension('slow');
    const sampled = await master.extension('sampled');
    await slow.subscribe({ subscribeTopics: [TOPIC, '/other'] });
    await sampled.subscribe({ subscribeTopics: [TOPIC], maxRateHz: 20 });
    for (const client of [slow, sampled]) client.connection.stall();
    slow.publish('/other', 'double', 1);
    await stream(2, 10, slow, sampled);
    await master.pass(1500);
    expect((await statistic())!.valueBytes).toBe(0);
    for (const client of [slow, sampled]) {
      client.connection.take();
      client.socket.handleDrain();
    }
    expect(slow.takeValues()).toEqual([['/other', 1]]);
    expect(sampled.takeValues()).toEqual([]);
  });

  it('take the pictures that modules made of them with them, and end as inputs [PM-37]', async () => {
    const { master, ada, stream } = await createCamera();
    const { session, error } = await ada.call({
      topic: '/services/session/runtime/start',
      session: {
        name: 'copies',
        processingModules: [
          {
            name: 'copy',
            inputs: [{ internalName: 'image', messageFormat: 'image2D' }],
            outputs: [
              { internalName: 'copy', messageFormat: 'image2D' },
              { internalName: 'isThere', messageFormat: 'bool' },
            ],
            processingMode: { frequency: { hertz: 10 } },
            onProcessingStringified: `(_delta, { image }) => ({
              outputs: { copy: image && { image2D: image.image2D }, isThere: { bool: image !== undefined } },
            })`,
          },
        ],
        ioMappings: [
          {
            processingModuleName: 'copy',
            inputMappings: [{ inputName: 'image', topic: TOPIC }],
            outputMappings: [
              { outputName: 'copy', topic: '/copy' },
              { outputName: 'isThere', topic: '/is there' },
            ],
          },
        ],
      },
    });
    expect(error).toBeUndefined();
    const latest = async (topic: string) => {
      const reader = await master.extension('reader');
      await reader.subscribe({ subscribeTopics: [topic] });
      return reader.takeRecords().at(-1)?.value;
    };
    await stream(1, 10);
    expect((await latest('/copy')) as Image2D).toMatchObject({ width: 250, height: 400 });
    expect(await latest('/is there')).toBe(true);
    ada.sendRecords(encodeRecord({ topic: TOPIC, expiryMs: 1 }));
    await master.pass(200);
    expect(await latest('/is there')).toBe(false);
    await master.pass(1300);
    expect(await latest('/copy')).toBeUndefined();
    const { session: running } = await ada.call({
      topic: '/services/session/runtime/get',
      session: { id: session!.id },
    });
    // That the topic has no value any more is said, and nothing else.
    expect(running!.extension!.problems.map(({ code }) => code)).toEqual(['topic_without_record']);
  });

  it('are not kept for a client that left, or was lost [TD-47]', async () => {
    const { master, ada, statistic } = await createCamera();
    take(ada, 1, 60_000, 600);
    ada.drop('left');
    expect(await statistic()).toBeUndefined();
    const ben = await master.extension('ben');
    take(ben, 2, 3000, 600);
    ben.drop();
    await master.pass(3500);
    expect(await statistic()).toBeUndefined();
  });

  it('are those of the newest record alone [TD-47]', async () => {
    const { master, ada, statistic } = await createCamera();
    take(ada, 1, 1000);
    take(ada, 2, 0);
    await master.pass(5000);
    expect((await statistic())!.valueBytes).toBeGreaterThan(PICTURE_BYTES);
    ada.sendRecords(emptyRecord(TOPIC));
    await master.pass(5000);
    expect(await statistic()).toMatchObject({ dataFormat: '' });
    take(ada, 3, -1);
    await master.pass(5000);
    expect((await statistic())!.valueBytes).toBeGreaterThan(PICTURE_BYTES);
  });

  it('are forwarded to existing clients as ordinary records [TD-11]', async () => {
    const { master, ada } = await createCamera();
    const viewer = await master.legacy('viewer');
    await viewer.subscribe({ subscribeTopics: [TOPIC] });
    take(ada, 9, 1000);
    await master.pass();
    expect(numbersOf(viewer)).toEqual([9]);
  });
});
