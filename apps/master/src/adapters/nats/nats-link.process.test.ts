import { startNats, type NatsServer } from '@ubii/harness';
import { afterEach, describe, expect, it } from 'vitest';

import { openTestLink } from '../../testing/nats-bench.ts';
import { RecordingLog } from '../../testing/recording-log.ts';
import type { NatsLink } from './nats-link.ts';

/** Nothing listens there: privileged, and unassigned. */
const NOWHERE = 'nats://127.0.0.1:9';
/** Short, for starts that are to fail. */
const START_MS = 600;

describe('[CU-60] a link to NATS', () => {
  const ends: (() => Promise<void>)[] = [];
  afterEach(async () => {
    for (const end of ends.splice(0).reverse()) await end();
  });

  const start = async (args?: readonly string[]): Promise<NatsServer> => {
    const server = await startNats(args && { args });
    ends.push(() => server.stop());
    return server;
  };
  const open = async (...args: Parameters<typeof openTestLink>): Promise<NatsLink> => {
    const link = await openTestLink(...args);
    ends.push(() => link.close());
    return link;
  };
  const reached = (link: NatsLink): Promise<boolean> =>
    new Promise((resolve) => {
      const cancel = link.onReach((isConnected) => {
        cancel();
        resolve(isConnected);
      });
    });

  it('gives up at the start after a while, with what to do', async () => {
    const log = new RecordingLog();
    const failed = open(NOWHERE, log, START_MS);
    await expect(failed).rejects.toThrow(
      /No NATS server of the cluster can be reached at nats:\/\/127\.0\.0\.1:9 \(.*refused.*Start NATS/,
    );
    expect(log.lines.map(({ message }) => message)).toEqual([
      'no NATS server answers yet; waiting up to 0.6 s',
    ]);
  });

  it('waits for a server that comes later', async () => {
    const server = await start();
    await server.kill();
    const opening = open(server.url);
    await server.restart();
    expect((await opening).isConnected).toBe(true);
  });

  it('takes the server that answers', async () => {
    const server = await start();
    const link = await open(`${NOWHERE},${server.url}`);
    expect(link.connection.getServer()).toBe(server.url.replace('nats://', ''));
  });

  it('is refused at once with a wrong password, which no message shows', async () => {
    const server = await start(['--user', 'ann', '--pass', 'right']);
    const url = (password: string) => server.url.replace('//', `//ann:${password}@`);
    const log = new RecordingLog();
    const refusal = await open(url('wrong'), log).catch(String);
    expect(refusal).toMatch(/ConfigError: .* refuses this master.*--cluster-credentials/);
    expect(refusal).not.toMatch(/wrong/);
    const link = await open(url('right'), log);
    expect(link.isConnected).toBe(true);
    expect(JSON.stringify(log.lines)).not.toMatch(/wrong|right/);
  });

  it('comes back after its server was killed, and tells both', async () => {
    const server = await start();
    const log = new RecordingLog();
    const link = await open(server.url, log);
    const lost = reached(link);
    await server.kill();
    expect(await lost).toBe(false);
    expect(link.isConnected).toBe(false);
    const back = reached(link);
    await server.restart();
    expect(await back).toBe(true);
    expect(link.isConnected).toBe(true);
    expect(log.lines.map(({ level, message }) => `${level}: ${message}`)).toEqual([
      'info: connected to NATS',
      'warn: lost the connection to NATS; connecting again',
      'info: NATS is back',
    ]);
  });

  it('knows how much NATS takes at once, and is away once it is closed', async () => {
    const server = await start();
    const link = await open(server.url);
    expect(link.maxPayloadBytes).toBe(1024 * 1024);
    await link.close();
    expect(link.isConnected).toBe(false);
  });
});
