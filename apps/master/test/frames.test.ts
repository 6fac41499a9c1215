import { encode } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';

describe('the topic-data socket', () => {
  it('counts PONG as activity [TD-2]', async () => {
    const { clock, ...master } = await withAda();
    clock.advanceSync(3_000);
    expect(master.ada.takeSent()).toContainEqual({ kind: 'PING' });
    master.ada.sendText('PONG');
    expect(master.ada.takeSent()).toEqual([]);
    expect(await master.stateOf(master.ada.id)).toBe(0);
  });

  it('answers PING with PONG, as text [TD-2] [EX-6]', async () => {
    const { ada } = await withAda();
    ada.sendText('PING');
    expect(ada.takeSent()).toEqual([{ kind: 'PONG' }]);
  });

  it('answers a numbered PING with its time [TS-2]', async () => {
    const { master, ada } = await withAda();
    const nowMs = master.clock.nowMs();
    ada.sendText('PING 17');
    ada.sendText('PING 18 -1700000000000.125 0.250 -12.5');
    expect(ada.takeSent()).toEqual([
      { kind: 'PONG', timed: { number: '17', receivedMs: nowMs, sentMs: nowMs } },
      { kind: 'PONG', timed: { number: '18', receivedMs: nowMs, sentMs: nowMs } },
    ]);
  });

  it.each([
    ...['ping', 'PONG ', '', '{"topic":"/a"}', 'x'.repeat(100_000)],
    ...['PING ', 'PING x', 'PING 1 2', 'PING 1 2 3 4 5', 'PING 1 NaN 1 1', 'PING 12345678901'],
  ])('calls other text a protocol error: %.20j [TD-2]', async (other) => {
    const { ada } = await withAda();
    ada.sendText(other);
    expect(ada.takeErrors()).toMatchObject([{ code: 'invalid_argument', stack: '' }]);
  });

  it('sends single records to a legacy client, whatever it publishes [TD-3] [EC-1]', async () => {
    const { master, ada } = await withAda();
    const ben = await master.legacy('ben');
    await ben.subscribe({ subscribeTopics: ['/a', '/b'] });
    ada.send('/a', 'double', 1);
    ada.send('/b', 'double', 2);
    ada.publish('/a', 'double', 3);
    expect(ben.takeSent().map(({ kind }) => kind)).toEqual(['record', 'record', 'record']);
  });

  it('sends a list to an extension client that takes them [TD-4] [EX-2]', async () => {
    const { master, ada } = await withAda();
    const ben = await master.extension('ben');
    await ben.subscribe({ subscribeTopics: ['/a', '/b'] });
    ada.send('/a', 'double', 1);
    ada.send('/b', 'double', 2);
    ada.publish('/a', 'double', 3);
    const sent = ben.takeSent();
    expect(sent.map(({ kind }) => kind)).toEqual(['list']);
    ben.connection.sent.push(...sent);
    expect(ben.takeValues()).toEqual([
      ['/a', 1],
      ['/b', 2],
      ['/a', 3],
    ]);
  });

  it('sends single records to an extension client that does not take lists [TD-4]', async () => {
    const { master, ada } = await withAda();
    const ben = await master.extension('ben', { extension: { recordLists: false } });
    await ben.subscribe({ subscribeTopics: ['/a'] });
    ada.send('/a', 'double', 1);
    ada.publish('/a', 'double', 2);
    expect(ben.takeSent().map(({ kind }) => kind)).toEqual(['record', 'record']);
  });

  it('is closed when no client is registered with its id [TD-6]', async () => {
    const { master, ada } = await withAda();
    ada.registered.id = 'unknown';
    expect(ada.open()).toBe(false);
    expect(ada.closed).toEqual({ reason: 'unknown client' });
    ada.registered.id = '';
    expect(ada.open()).toBe(false);
    expect(ada.closed).toEqual({ reason: 'unknown client' });
    expect(master.master.metrics()).toContainEqual(
      expect.objectContaining({
        name: 'ubii_sockets_refused_total',
        values: [{ labels: {}, value: 2 }],
      }),
    );
  });

  it('takes the place of the one before, with subscriptions and queue [TD-7] [EX-5]', async () => {
    const { master, ada } = await withAda();
    const ben = await master.legacy('ben');
    await ben.subscribe({ subscribeTopics: ['/a', '/key'] });
    const { connection: first, socket: firstSocket } = ben;
    first.stall();
    ada.publish('/a', 'double', 1);
    ada.publish('/key', 'keyEvent', { type: 1, key: 'x' });
    ada.publish('/key', 'keyEvent', { type: 0, key: 'x' });
    ben.open();
    expect(first.sent.at(-1)).toEqual({ kind: 'close', reason: 'superseded' });
    expect(ben.takeValues()).toEqual([
      ['/a', 1],
      ['/key', { type: 1, key: 'x' }],
      ['/key', { type: 0, key: 'x' }],
    ]);
    // Frames of the first socket are ignored, and its end does not affect the client.
    firstSocket.handleTopicData(encode('ubii.topicData.TopicData', {}));
    firstSocket.handlePing();
    firstSocket.handlePong();
    firstSocket.handleProtocolError('Nonsense.');
    firstSocket.handleDrain();
    firstSocket.handleClose('lost');
    ada.publish('/a', 'double', 2);
    expect(ben.takeValues()).toEqual([['/a', 2]]);
  });

  it('ignores an error that a client sends, and an empty message', async () => {
    const { ada } = await withAda();
    ada.socket.handleTopicData(
      encode('ubii.topicData.TopicData', { error: { title: 'a', message: 'b' } }),
    );
    ada.socket.handleTopicData(new Uint8Array(0));
    expect(ada.takeSent()).toEqual([]);
  });
});

async function withAda() {
  const master = new TestMaster();
  const ada = await master.legacy('ada');
  const stateOf = async (id: string): Promise<number | undefined> => {
    const { clientList } = await master.call({ topic: '/services/client/get_list' });
    return clientList?.elements.find((client) => client.id === id)?.state;
  };
  return { master, clock: master.clock, ada, stateOf };
}
