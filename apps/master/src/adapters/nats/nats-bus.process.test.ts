import { headers } from '@nats-io/transport-node';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';

import { clusterBusSuite, Inbox } from '../../testing/acceptance/index.ts';
import { openNatsBench, type CuttableLink, type NatsBench } from '../../testing/nats-bench.ts';
import { RecordingLog } from '../../testing/recording-log.ts';
import { NatsBus } from './nats-bus.ts';

const MAX_BYTES = 8_000_000;

clusterBusSuite('NatsBus', async () => {
  const bench = await openNatsBench();
  const links = new Map<string, CuttableLink>();
  return {
    async open(masterId) {
      const opened = await bench.openLink();
      links.set(masterId, opened);
      return new NatsBus(opened.link, 'test', MAX_BYTES);
    },
    setReachable(masterId, isReachable) {
      const link = links.get(masterId)!;
      if (isReachable) link.heal();
      else link.cut();
      return Promise.resolve();
    },
    close: () => bench.close(),
  };
});

describe('messages over NATS', () => {
  let bench: NatsBench;
  beforeEach(async () => {
    bench = await openNatsBench();
  });
  afterEach(() => bench.close());

  const A = '0a7d3f0e-5a53-4d6c-9f3c-111111111111';
  const B = '0a7d3f0e-5a53-4d6c-9f3c-222222222222';

  async function join(masterId: string, cluster = 'test') {
    const log = new RecordingLog();
    const { link } = await bench.openLink(log);
    const bus = new NatsBus(link, cluster, MAX_BYTES);
    const messages = new Inbox<string>();
    const reach = new Inbox<boolean>();
    bus.listen(masterId, {
      handleMessage: (from, message) => messages.add(`${from} ${Buffer.from(message).toString()}`),
      handleReach: (isReachable) => reach.add(isReachable),
    });
    await reach.next();
    return { bus, link, log, messages, reach };
  }

  it('[CU-50] stay in their cluster', async () => {
    const [a, b] = [await join(A), await join(B)];
    const other = await join(B, 'other');
    a.bus.broadcast(Buffer.from('to all'));
    a.bus.send(B, Buffer.from('to one'));
    expect([await b.messages.next(), await b.messages.next()]).toEqual([
      `${A} to all`,
      `${A} to one`,
    ]);
    expect(other.messages.waiting).toEqual([]);
  });

  it('[CU-51] of others on the same subjects are ignored, whatever is in them', async () => {
    const [a, b] = [await join(A), await join(B)];
    const { connection } = (await bench.openLink()).link;
    const part = headers();
    part.set('Ubii-Part', 'junk');
    for (const subject of [`ubii.test.to.${B}.stranger`, 'ubii.test.all.*', 'ubii.test.all.x']) {
      connection.publish(subject, 'junk');
      connection.publish(subject, 'junk', { headers: part });
    }
    connection.publish(`ubii.test.to.${B}.${A}`, 'junk', { headers: part });
    await connection.flush();
    a.bus.send('not.an.id', Buffer.from('junk'));
    a.bus.send(B, Buffer.from('real'));
    expect(await b.messages.next()).toBe(`${A} real`);
    expect(() => a.bus.listen('>', { handleMessage() {}, handleReach() {} })).toThrow(TypeError);
  });

  it('[CU-51] go on after a listener failed', async () => {
    const [a, b] = [await join(A), await join(B)];
    const add = b.messages.add.bind(b.messages);
    b.messages.add = (text) => {
      b.messages.add = add;
      throw new Error(`failed at ${text.length} characters`);
    };
    a.bus.send(B, Buffer.from('first'));
    a.bus.send(B, Buffer.from('second'));
    expect(await b.messages.next()).toBe(`${A} second`);
    expect(b.log.lines.at(-1)).toMatchObject({
      level: 'error',
      message: 'a message of another master failed',
    });
  });

  it('[CU-52] that are too large are dropped, with a line in the log', async () => {
    const [a, b] = [await join(A), await join(B)];
    a.bus.send(B, new Uint8Array(MAX_BYTES + 1));
    a.bus.send(B, Buffer.from('next'));
    expect(await b.messages.next()).toBe(`${A} next`);
    expect(a.log.lines.at(-1)).toMatchObject({
      level: 'warn',
      message: 'a message between masters is too large',
    });
  });

  it('[CU-51] are counted until the system has taken them', async () => {
    const [a, b] = [await join(A), await join(B)];
    expect(a.bus.queuedBytes).toBe(0);
    a.bus.send(B, new Uint8Array(1000));
    expect(a.bus.queuedBytes).toBeGreaterThan(1000);
    await b.messages.next();
    expect(a.bus.queuedBytes).toBe(0);
  });

  it('[CU-60] are carried again after NATS was killed', async () => {
    const [a, b] = [await join(A), await join(B)];
    await bench.server.kill();
    expect([await a.reach.next(), await b.reach.next()]).toEqual([false, false]);
    a.bus.send(B, Buffer.from('lost'));
    expect(a.bus.queuedBytes).toBe(0);
    await bench.server.restart();
    expect([await a.reach.next(), await b.reach.next()]).toEqual([true, true]);
    a.bus.send(B, Buffer.from('again'));
    expect(await b.messages.next()).toBe(`${A} again`);
  });
});
