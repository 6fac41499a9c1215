import {
  AccessRole,
  decodeTopicData,
  NodeExtensionKind,
  type BridgeOrder,
  type Init,
  type NodeMessage,
  type ServiceReply,
} from '@ubii/proto';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { codeOf, joinAs } from './access-world.ts';
import { SERVICES } from './recording-world.ts';

type Answer = Omit<Init<NonNullable<NodeMessage['bridgeAnswer']>>, 'number'>;

async function joinBridge(master: TestMaster, isBridge = true): Promise<TestClient> {
  const node = { kind: NodeExtensionKind.EXTERNAL, isBridge };
  const client = await master.register({ name: 'Hall', extension: { recordLists: true, node } });
  client.open();
  return client;
}

function takeOrders(bridge: TestClient): BridgeOrder[] {
  return bridge.takeSent().flatMap((sent) => {
    if (sent.kind !== 'frame') return [];
    const order = decodeTopicData(sent.frame).nodeMessages[0]?.bridgeOrder;
    return order === undefined ? [] : [order];
  });
}

function say(client: TestClient, number: number, answer: Answer): void {
  client.socket.handleTopicData(encodeNodeMessageFrame({ bridgeAnswer: { number, ...answer } }));
}

/** Waits for the order of a request. */
async function orderOf(bridge: TestClient): Promise<BridgeOrder> {
  for (let i = 0; i < 200; i++) {
    const [order] = takeOrders(bridge);
    if (order !== undefined) return order;
    await Promise.resolve();
  }
  throw new Error('The bridge was asked nothing.');
}

const get = (master: TestMaster, targetId: string): Promise<ServiceReply> =>
  master.call({
    topic: `${SERVICES}bridge_mappings_get`,
    bridgeMappingsRequest: { targetId },
  });

describe('mappings of a bridge', () => {
  it('are asked of the bridge, and its answer is the reply [BR-80] [BR-82]', async () => {
    const master = new TestMaster();
    const bridge = await joinBridge(master);
    const asking = master.call({
      topic: `${SERVICES}bridge_mappings_set`,
      bridgeMappingsChange: { targetId: bridge.id, mappingsJson: '[]', revision: 'r1' },
    });
    const { number, set } = await orderOf(bridge);
    expect(set).toMatchObject({ mappingsJson: '[]', revision: 'r1' });
    say(bridge, number, { mappings: { mappingsJson: '[]', revision: 'r2' } });
    expect((await asking).bridgeMappings).toMatchObject({ revision: 'r2' });
  });

  it('are shown to viewers and participants, and are changed and checked by admins only [BR-80] [BR-81] [BR-82]', async () => {
    const master = new TestMaster();
    const bridge = await joinBridge(master);
    const bridgeMappingsChange = { targetId: bridge.id, mappingsJson: '[]' };
    const { ACCESS_ROLE_VIEWER, ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_PLAYER } = AccessRole;
    for (const role of [ACCESS_ROLE_VIEWER, ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_PLAYER]) {
      const guest = await joinAs(master, role);
      for (const service of ['check', 'set']) {
        const topic = `${SERVICES}bridge_mappings_${service}`;
        expect(await codeOf(guest, { topic, bridgeMappingsChange })).toBe('permission_denied');
      }
      const topic = `${SERVICES}bridge_mappings_get`;
      const asking = codeOf(guest, { topic, bridgeMappingsRequest: { targetId: bridge.id } });
      if (role !== ACCESS_ROLE_PLAYER) {
        const { number } = await orderOf(bridge);
        say(bridge, number, { mappings: { revision: 'r1' } });
      }
      expect(await asking).toBe(role === ACCESS_ROLE_PLAYER ? 'permission_denied' : '');
    }
    expect(takeOrders(bridge)).toEqual([]);
  });

  it('are answered by no other client, and not forever [BR-80]', async () => {
    const master = new TestMaster();
    const bridge = await joinBridge(master);
    const other = await joinBridge(master);
    const asking = get(master, bridge.id);
    const { number } = await orderOf(bridge);
    say(other, number, { mappings: { revision: 'false' } });
    await master.pass(5_000);
    expect((await asking).error).toMatchObject({ code: 'unavailable' });
    expect((await asking).error?.message).toContain('did not answer within 5 s');
  });

  it('are asked of bridges only, and end with their connection [BR-80]', async () => {
    const master = new TestMaster();
    const node = await joinBridge(master, false);
    expect((await get(master, node.id)).error?.message).toContain('is no bridge');
    const bridge = await joinBridge(master);
    const asking = get(master, bridge.id);
    await orderOf(bridge);
    bridge.drop();
    await master.pass(5_000);
    expect((await asking).error).toMatchObject({ code: 'unavailable' });
    expect((await get(master, bridge.id)).error).toMatchObject({ code: 'unavailable' });
  });

  it('are asked at most 20 times a second [BR-84]', async () => {
    const master = new TestMaster();
    const bridge = await joinBridge(master);
    const answers = await Promise.all(
      Array.from({ length: 21 }, async () => {
        const asking = get(master, bridge.id);
        for (let i = 0; i < 50; i++) {
          for (const { number } of takeOrders(bridge)) say(bridge, number, { mappings: {} });
          await Promise.resolve();
        }
        return asking;
      }),
    );
    const codes = answers.map(({ error }) => error?.code ?? 'fine');
    expect(codes.filter((code) => code === 'resource_exhausted')).toHaveLength(1);
    expect(codes.filter((code) => code === 'fine')).toHaveLength(20);
  });

  it('of a bridge that says too much are refused [BR-84]', async () => {
    const master = new TestMaster();
    const bridge = await joinBridge(master);
    const asking = get(master, bridge.id);
    const { number } = await orderOf(bridge);
    say(bridge, number, { mappings: { mappingsJson: ' '.repeat(70_000) } });
    expect((await asking).error).toMatchObject({ code: 'resource_exhausted' });
  });

  it('are those of a client that is not listed as a node [BR-40]', async () => {
    const master = new TestMaster();
    const bridge = await joinBridge(master);
    const { nodeList } = await master.call({ topic: `${SERVICES}node_list` });
    expect(nodeList?.elements.map(({ clientId }) => clientId)).not.toContain(bridge.id);
  });
});
