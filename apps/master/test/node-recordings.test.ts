import {
  decodeTopicData,
  fromJson,
  NodeExtensionKind,
  RECORDING_STATUS_TOPIC,
  RecordingState,
  type Init,
  type NodeMessage,
  type NodeRecorderOrder,
  type Recording,
  type ServiceReply,
} from '@ubii/proto';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { SERVICES } from './recording-world.ts';

const { RECORDING_STATE_RECORDING: RECORDING, RECORDING_STATE_COMPLETE: COMPLETE } = RecordingState;
const { RECORDING_STATE_AT_NODE: AT_NODE } = RecordingState;

/** A node that records, as far as messages go: the test says what it answers. */
class RecorderNode {
  readonly client: TestClient;
  readonly #master: TestMaster;

  private constructor(master: TestMaster, client: TestClient) {
    this.#master = master;
    this.client = client;
  }

  static async join(master: TestMaster, name: string, records = true): Promise<RecorderNode> {
    const node = { kind: NodeExtensionKind.NODE, records };
    const client = await master.register({ name, extension: { recordLists: true, node } });
    client.open();
    return new RecorderNode(master, client);
  }

  /** What it was told since it was asked last. */
  takeOrders(): NodeRecorderOrder[] {
    return this.client.takeSent().flatMap((sent) => {
      if (sent.kind !== 'frame') return [];
      const order = decodeTopicData(sent.frame).nodeMessages[0]?.recorderOrder;
      return order === undefined ? [] : [order];
    });
  }

  say(message: Init<NodeMessage>): void {
    this.client.socket.handleTopicData(encodeNodeMessageFrame(message));
  }

  report(...elements: Init<Recording>[]): void {
    this.say({ recorderReport: { elements } });
  }

  /** Answers the request that `ask` makes. */
  async answering(
    ask: Promise<ServiceReply>,
    answer: (order: NodeRecorderOrder) => Init<NodeMessage['recorderAnswer'] & object>,
  ): Promise<{ reply: ServiceReply; order: NodeRecorderOrder }> {
    for (let i = 0; i < 200; i++) {
      const order = this.takeOrders().find(({ number }) => number > 0);
      if (order !== undefined) {
        this.say({ recorderAnswer: { number: order.number, ...answer(order) } });
        return { reply: await ask, order };
      }
      await Promise.resolve();
    }
    const { error } = await ask;
    throw new Error(`it was asked nothing: ${error?.message}`);
  }

  /** Starts a recording on this node, for which the node says yes. */
  async start(selection = {}): Promise<{ id: string; order: NodeRecorderOrder }> {
    const ask = this.#master.call({
      topic: `${SERVICES}recording_start`,
      recordingStartRequest: { name: 'Lesson', nodeId: this.client.id, selection },
    });
    const { reply, order } = await this.answering(ask, ({ start }) => ({
      recording: { ...start!.recording, state: RECORDING },
    }));
    if (reply.recording === undefined) throw new Error(reply.error?.message);
    return { id: reply.recording.id, order };
  }
}

async function listOf(master: TestMaster): Promise<readonly Recording[]> {
  const { recordingList } = await master.call({ topic: `${SERVICES}recording_list` });
  return recordingList!.elements;
}

const ask = (master: TestMaster, service: string, id: string): Promise<ServiceReply> =>
  master.call({ topic: `${SERVICES}${service}`, recordingRequest: { id } });

/** A file that the node sends: that of a recording of the master with another id. */
async function fileOf(master: TestMaster): Promise<string> {
  const start = { topic: `${SERVICES}recording_start`, recordingStartRequest: { name: 'Here' } };
  const { id } = (await master.call(start)).recording!;
  await ask(master, 'recording_stop', id);
  return id;
}

function upload(master: TestMaster, id: string, from: string, node: TestClient) {
  const { files, uploads } = master.recordings;
  return master.master.uploadNodeRecording(
    {
      recordingId: id,
      clientId: node.id,
      declaredBytes: 0,
      receive: () => {
        uploads.set(id, files.get(from)!);
        return Promise.resolve();
      },
    },
    node.caller,
  );
}

describe('a recording at a node', () => {
  it('[RC-60] is started only where a node offers it and is there', async () => {
    const master = new TestMaster();
    const start = async (nodeId: string): Promise<string | undefined> => {
      const recordingStartRequest = { nodeId };
      const topic = `${SERVICES}recording_start`;
      return (await master.call({ topic, recordingStartRequest })).error?.message;
    };
    expect(await start('nobody')).toMatch(/No client has the id/);
    const idle = await RecorderNode.join(master, 'idle', false);
    expect(await start(idle.client.id)).toMatch(/does not record. Start a node with --record-dir/);
    const node = await RecorderNode.join(master, 'kitchen');
    node.client.drop();
    expect(await start(node.client.id)).toMatch(/"kitchen" is not connected/);
    expect(await listOf(master)).toEqual([]);
  });

  it('[RC-61] tells the node what clients publish, now and later, with clocks of clients', async () => {
    const master = new TestMaster();
    const node = await RecorderNode.join(master, 'kitchen');
    const ada = await master.legacy('ada');
    const bob = await master.legacy('bob');
    ada.publish('/ada/before', 'double', 1);
    bob.publish('/bob', 'double', 1);
    const { id, order } = await node.start({ clients: ['ada'] });
    const before = { topic: '/ada/before', clientId: ada.id };
    expect(order.start?.sources).toEqual({ recordingId: id, elements: [before] });
    ada.publish('/ada/after', 'double', 1);
    ada.publish('/ada/after', 'double', 2);
    await master.pass(100);
    const told = node.takeOrders().flatMap(({ sources }) => sources?.elements ?? []);
    expect(told).toEqual([{ topic: '/ada/after', clientId: ada.id }]);
  });

  it('[RC-61] is refused with the words of the node, and with ours when it does not answer', async () => {
    const master = new TestMaster();
    const node = await RecorderNode.join(master, 'kitchen');
    const start = (): Promise<ServiceReply> =>
      master.call({
        topic: `${SERVICES}recording_start`,
        recordingStartRequest: { nodeId: node.client.id },
      });
    const error = { code: 'failed_precondition', message: 'The disk is full.' };
    const { reply } = await node.answering(start(), () => ({ error }));
    expect(reply.error).toMatchObject(error);
    const waiting = start();
    await master.pass(5_000);
    expect((await waiting).error?.message).toMatch(/"kitchen" did not answer within 5 s/);
    // The node may have begun: the master orders it to delete the recording.
    expect(node.takeOrders().some(({ remove }) => remove !== undefined)).toBe(true);
    expect(await listOf(master)).toEqual([]);
  });

  it('[RC-62] is in the list and in the status as its node says, and takes markers of topics', async () => {
    const master = new TestMaster();
    const page = await master.extension('page');
    await page.subscribe({ subscribeTopics: [RECORDING_STATUS_TOPIC] });
    const node = await RecorderNode.join(master, 'kitchen');
    const { id } = await node.start();
    page.takeSent();
    node.report({ id, name: 'Lesson', state: RECORDING, recordCount: 7, lostCount: 2 });
    await master.pass(10);
    const [first] = await listOf(master);
    expect(first).toMatchObject({ id, recordCount: 7, lostCount: 2, nodeName: 'kitchen' });
    const statuses = page.takeRecords().filter(({ topic }) => topic === RECORDING_STATUS_TOPIC);
    expect(statuses.at(-1)).toMatchObject({ value: { running: [{ id, recordCount: 7 }] } });
    page.publish('/any/recording/marker', 'string', 'Now');
    await master.pass(100);
    const marks = node.takeOrders().flatMap(({ mark }) => (mark === undefined ? [] : [mark]));
    expect(marks).toMatchObject([{ isTopic: true, marker: { text: 'Now', author: 'page' } }]);
  });

  it('[RC-62] is said only by its node, which has to be one that records', async () => {
    const master = new TestMaster();
    const node = await RecorderNode.join(master, 'kitchen');
    const other = await RecorderNode.join(master, 'other');
    const idle = await RecorderNode.join(master, 'idle', false);
    const { id } = await node.start();
    other.report({ id, state: AT_NODE, recordCount: 99 });
    idle.report({ id: 'made-up', state: AT_NODE });
    other.report({ id: '../escape', state: AT_NODE });
    expect((await listOf(master)).map((one) => [one.id, one.recordCount])).toEqual([[id, 0]]);
  });

  it('[RC-63] is part of no study and no comparison, because its node says so', async () => {
    const master = new TestMaster();
    const node = await RecorderNode.join(master, 'kitchen');
    const study = { studyId: 's', studyName: 'Touch', participantCode: 'P01' };
    node.report({ id: 'claimed', state: AT_NODE, study, replayedRecordingId: 'other' });
    const claims = { study: undefined, replayedRecordingId: '' };
    expect(await listOf(master)).toMatchObject([{ id: 'claimed', ...claims }]);
  });

  it('[RC-54] has pages as long as those of the master, also of a node that sends all', async () => {
    const master = new TestMaster();
    const node = await RecorderNode.join(master, 'kitchen');
    const { id } = await node.start();
    const topics = Array.from({ length: 1_200 }, (_, index) => ({ topic: `/x/${index}` }));
    const markers = [{ id: 'm', text: 'y'.repeat(9_000), author: 'z'.repeat(9_000) }];
    const pageOf = async (topicsFrom: number, told: Init<Recording>) => {
      const topic = `${SERVICES}recording_get`;
      const ask = master.call({ topic, recordingRequest: { id, topicsFrom } });
      return (await node.answering(ask, () => ({ recording: { id, ...told } }))).reply.recording!;
    };
    const first = await pageOf(0, { topics, markers });
    expect([first.topics.length, first.topicsTotal]).toEqual([1_000, 1_200]);
    expect([first.markers[0]!.text.length, first.markers[0]!.author.length]).toEqual([500, 100]);
    expect((await pageOf(1_000, { topics })).topics[0]!.topic).toBe('/x/1000');
    const own = { topics: topics.slice(1_000), topicsFrom: 1_000, topicsTotal: 1_200 };
    expect(await pageOf(1_000, own)).toMatchObject({ topicsFrom: 1_000, topicsTotal: 1_200 });
  });

  it('[RC-63] becomes a recording of the master when its node brings the file, and no other client', async () => {
    const master = new TestMaster();
    const node = await RecorderNode.join(master, 'kitchen');
    const other = await RecorderNode.join(master, 'other');
    const { id } = await node.start();
    const from = await fileOf(master);
    await expect(upload(master, id, from, node.client)).rejects.toThrow('is running');
    const stop = ask(master, 'recording_stop', id);
    await node.answering(stop, () => ({ recording: { id, name: 'Lesson', state: COMPLETE } }));
    await expect(upload(master, id, from, other.client)).rejects.toThrow('by the node "kitchen"');
    node.report({ id, name: 'Lesson', state: COMPLETE, problem: 'It is not uploaded: no room.' });
    const waiting = (await listOf(master)).find((one) => one.id === id);
    expect(waiting).toMatchObject({ state: AT_NODE, problem: 'It is not uploaded: no room.' });
    const retry = ask(master, 'recording_upload', id);
    const { order } = await node.answering(retry, () => ({}));
    expect(order.upload).toMatchObject({ id });
    await upload(master, id, from, node.client);
    const found = (await listOf(master)).find((one) => one.id === id);
    expect(found).toMatchObject({ state: COMPLETE, nodeId: '', kind: 0 });
    // Its answer was lost: the node hears that it is there.
    await expect(upload(master, id, from, node.client)).rejects.toThrow(
      'has this recording already',
    );
  });

  it('[RC-64] stays in the list when its node goes, and is deleted when the node returns', async () => {
    const master = new TestMaster();
    const node = await RecorderNode.join(master, 'kitchen');
    const { id } = await node.start();
    node.client.drop();
    expect(await listOf(master)).toMatchObject([{ id, nodeIsAway: true, state: RECORDING }]);
    expect((await ask(master, 'recording_stop', id)).error?.code).toBe('unavailable');
    expect((await ask(master, 'recording_delete', id)).success).toBeDefined();
    expect(await listOf(master)).toEqual([]);
    node.client.open();
    node.report({ id, state: RECORDING });
    expect(node.takeOrders()).toMatchObject([{ remove: { id } }]);
    expect(await listOf(master)).toEqual([]);
  });

  it('[RC-62] is known to a master that was started again, as its node says', async () => {
    const master = new TestMaster();
    const node = await RecorderNode.join(master, 'kitchen');
    const ada = await master.legacy('ada');
    ada.publish('/ada', 'double', 1);
    const selection = fromJson('ubii.extension.RecordingSelection', { clients: ['ada'] });
    node.report({ id: 'earlier', name: 'Lesson', author: 'Ada', state: RECORDING, selection });
    expect(await listOf(master)).toMatchObject([{ id: 'earlier', author: 'Ada' }]);
    const [order] = node.takeOrders().filter(({ sources }) => sources !== undefined);
    expect(order?.sources?.elements).toEqual([{ topic: '/ada', clientId: ada.id }]);
    // What it has no more is in no list.
    node.report();
    expect(await listOf(master)).toEqual([]);
  });

  it('[RC-65] counts to a limit of its own', async () => {
    const master = new TestMaster({ limits: { recordingsAtNodes: 1 } });
    const node = await RecorderNode.join(master, 'kitchen');
    await node.start();
    await expect(node.start()).rejects.toThrow('recordingsAtNodes');
  });
});
