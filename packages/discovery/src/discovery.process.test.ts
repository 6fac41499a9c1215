import { createSocket } from 'node:dgram';
import { describe, expect, it, onTestFinished } from 'vitest';
import { announceMaster } from './announce-master.ts';
import type { AnnounceOptions } from './announce-master.ts';
import type { Announcement } from './announcement.ts';
import { findMasters } from './find-masters.ts';
import type { FoundMaster } from './find-masters.ts';

/*
 * Multicast on loopback, and on a port of each test's own: nothing leaves the machine, and no
 * other program receives it.
 */
const LOOPBACK = '127.0.0.1';
const TIMEOUT_MS = 20_000;

function freePort(): Promise<number> {
  return new Promise((resolve, reject) => {
    const socket = createSocket('udp4');
    socket.once('error', reject);
    socket.bind(0, LOOPBACK, () => {
      const { port } = socket.address();
      socket.close(() => resolve(port));
    });
  });
}

/** Whether this machine lets multicast through on loopback. */
async function hasMulticast(): Promise<boolean> {
  const port = await freePort();
  const socket = createSocket({ type: 'udp4', reuseAddr: true });
  try {
    return await new Promise((resolve) => {
      const late = setTimeout(() => resolve(false), 1_000);
      socket.on('error', () => resolve(false));
      socket.on('message', () => {
        clearTimeout(late);
        resolve(true);
      });
      socket.bind(port, () => {
        try {
          socket.addMembership('224.0.0.251', LOOPBACK);
          socket.setMulticastInterface(LOOPBACK);
          socket.send('hello', port, '224.0.0.251');
        } catch {
          resolve(false);
        }
      });
    });
  } finally {
    socket.close();
  }
}

const canMulticast = await hasMulticast();
if (!canMulticast) console.warn('No multicast on loopback here: discovery is not tested.');

const workshop: Announcement = {
  name: 'Workshop',
  id: 'aaaa',
  version: '0.1.0',
  port: 8080,
  https: true,
  servicesPort: 8102,
  topicDataPort: 8104,
};

function announce(port: number, announcement: Announcement, more: Partial<AnnounceOptions> = {}) {
  const names: string[] = [];
  const problems: string[] = [];
  let wake: () => void = () => undefined;
  const announced = announceMaster({
    addresses: () => [LOOPBACK],
    port,
    announcement,
    host: 'workshop.local',
    onProblem: (reason) => {
      problems.push(reason);
      wake();
    },
    onName: (name) => {
      names.push(name);
      wake();
    },
    ...more,
  });
  onTestFinished(() => announced.close());
  const until = async (isTrue: () => boolean): Promise<void> => {
    while (!isTrue()) await new Promise<void>((resolve) => (wake = resolve));
  };
  return { announced, names, problems, until };
}

/** Resolves with the masters heard, once there are so many. */
function find(port: number, count: number): Promise<readonly FoundMaster[]> {
  return new Promise((resolve) => {
    const end = findMasters({
      addresses: () => [LOOPBACK],
      port,
      onProblem: () => undefined,
      onFound: (masters) => {
        if (masters.length === count) resolve(masters);
      },
    });
    onTestFinished(end);
  });
}

describe.skipIf(!canMulticast)('discovery', { timeout: TIMEOUT_MS }, () => {
  it('finds a master, with all a client needs [DI-1] [DI-2] [DI-5]', async () => {
    const port = await freePort();
    announce(port, workshop);
    const url = `http://${LOOPBACK}:8080`;
    expect(await find(port, 1)).toEqual([{ ...workshop, address: LOOPBACK, url }]);
  });

  it('finds a master that comes later, and several', async () => {
    const port = await freePort();
    const found = find(port, 2);
    announce(port, workshop);
    announce(port, { ...workshop, name: 'Lab', id: 'bbbb', port: 8090 });
    expect((await found).map(({ name }) => name).sort()).toEqual(['Lab', 'Workshop']);
  });

  it('gives the second master of a name a number [DI-3]', async () => {
    const port = await freePort();
    const first = announce(port, workshop);
    await first.until(() => first.names.length > 0);
    const second = announce(port, { ...workshop, id: 'bbbb' });
    await second.until(() => second.names.length > 0);
    expect(first.names).toEqual(['Workshop']);
    expect(second.names).toEqual(['Workshop (2)']);
    expect(await find(port, 2)).toHaveLength(2);
  });

  it('resolves a name conflict of two masters that start at once [DI-3]', async () => {
    const port = await freePort();
    const one = announce(port, { ...workshop, id: 'bbbb' });
    const other = announce(port, workshop);
    // On a busy machine one may begin later, and then gives way though its id is the smaller one.
    const gaveWay = ({ names }: { names: readonly string[] }) => names.includes('Workshop (2)');
    await Promise.race([one, other].map((each) => each.until(() => gaveWay(each))));
    await Promise.all([one, other].map((each) => each.until(() => each.names.length > 0)));
    expect([one, other].map(({ names }) => names.at(-1)).sort()).toEqual([
      'Workshop',
      'Workshop (2)',
    ]);
    expect(await find(port, 2)).toHaveLength(2);
  });

  it('takes a master back when it is closed [DI-4]', async () => {
    const port = await freePort();
    const { announced } = announce(port, workshop);
    await find(port, 1);
    const goodbye = new Promise<void>((resolve) => {
      const socket = createSocket({ type: 'udp4', reuseAddr: true });
      onTestFinished(() => void socket.close());
      socket.on('message', (packet) => {
        // A response, whose first record has the time to live 0.
        if ((packet[2]! & 0x80) !== 0 && hasGoodbye(packet)) resolve();
      });
      socket.bind(port, () => {
        socket.addMembership('224.0.0.251', LOOPBACK);
        void announced.close();
      });
    });
    await goodbye;
  });

  it('does without where the port is taken, and says so once [DI-4]', async () => {
    const taken = createSocket('udp4'); // exclusive
    onTestFinished(() => void taken.close());
    await new Promise<void>((resolve) => taken.bind(0, resolve));
    const { port } = taken.address();
    const { announced, problems, until } = announce(port, workshop);
    await until(() => problems.length > 0);
    expect(problems[0]).toContain('EADDRINUSE');
    await announced.close();
    expect(problems).toHaveLength(1);
  });

  it('does without a network [DI-4]', async () => {
    for (const addresses of [[], ['192.0.2.1']]) {
      const { announced } = announce(await freePort(), workshop, { addresses: () => addresses });
      await announced.close();
      await announced.close();
    }
  });
});

/** The type PTR, class IN, and a time to live of 0. */
function hasGoodbye(packet: Buffer): boolean {
  return packet.includes(Buffer.from([0, 12, 0, 1, 0, 0, 0, 0]));
}
