import { execFileSync } from 'node:child_process';
import { once } from 'node:events';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it, vi } from 'vitest';

import {
  MASTER,
  MASTER_V6,
  NEIGHBOURS,
  OLD_DEVICE,
  PHONE,
  PHONE_V6,
  TestNetwork,
} from './test-network.ts';

// Processes and networks, on a machine that may be busy.
vi.setConfig({ testTimeout: 120_000 });

const packageFolder = fileURLToPath(new URL('../..', import.meta.url));
const program = join(packageFolder, '.cache-lan-connections', 'main.js');
const ask = fileURLToPath(new URL('ask.mjs', import.meta.url));
const flood = fileURLToPath(new URL('flood.mjs', import.meta.url));
/** Descriptor limit of the attack that kept everybody out, as low as on some systems. */
const DESCRIPTORS = 700;

const reason = TestNetwork.reasonAgainst();
if (reason !== undefined) console.warn(`The tests of the LAN are left out: ${reason}.`);

describe.skipIf(reason !== undefined)('a master of which strangers take all connections', () => {
  const network = new TestNetwork();
  let master: ReturnType<TestNetwork['startOnMaster']>;
  let attacker: ReturnType<TestNetwork['startOnPhone']> | undefined;
  let port = 0;
  let joinToken = '';

  beforeAll(async () => {
    execFileSync(process.execPath, ['build.mjs', '.cache-lan-connections'], { cwd: packageFolder });
    network.open();
    master = network.startOnMaster(
      [
        program,
        ...['--port', '0', '--legacy-ports', 'off', '--print-endpoints', 'json'],
        ...['--data-dir', network.newFolder()],
      ],
      { PATH: process.env['PATH'], HOME: network.newFolder() },
      DESCRIPTORS,
    );
    const [line] = (await once(master.stdout!, 'data')) as [Buffer];
    const endpoints = JSON.parse(line.toString()) as { url: string; joinToken: string };
    port = Number(new URL(endpoints.url).port);
    joinToken = endpoints.joinToken;
    // It is not read, and must not stop the master.
    master.stderr?.resume();
  }, 120_000);

  afterAll(() => {
    attacker?.kill('SIGKILL');
    master?.kill('SIGKILL');
    network.close();
  });

  interface Caller {
    readonly where: 'master' | 'phone';
    readonly host: string;
    readonly from?: string;
    readonly bearer?: string;
  }

  async function call(topic: string, payload: object, caller: Caller): Promise<unknown> {
    const { where, host, from, bearer } = caller;
    const { text } = (await network.run(where, ask, {
      url: `http://${host.includes(':') ? `[${host}]` : host}:${port}/services/json`,
      method: 'POST',
      from,
      headers: {
        'content-type': 'application/json',
        ...(bearer !== undefined && { authorization: `Bearer ${bearer}` }),
      },
      body: JSON.stringify({ topic, ...payload }),
    })) as { text: string };
    return JSON.parse(text);
  }

  it('admits local callers, joined clients and other strangers [AC-60] [AC-61] [AC-62]', async () => {
    const phone = { where: 'phone', host: MASTER, from: PHONE } as const;
    const joined = (await call(
      '/services/client/registration',
      { client: { name: 'phone', extension: {} } },
      { ...phone, bearer: joinToken },
    )) as { client: { extension: { credential: string } } };
    const { credential } = joined.client.extension;

    const addresses = [OLD_DEVICE, ...NEIGHBOURS];
    attacker = network.startOnPhone([
      flood,
      JSON.stringify({ host: MASTER, port, addresses, each: 100 }),
    ]);
    await once(attacker.stdout!, 'data');

    for (let i = 0; i < 3; i++) {
      const list = await call(
        '/services/client/get_list',
        {},
        { where: 'master', host: '127.0.0.1' },
      );
      expect(list).toHaveProperty('clientList');
      const member = await call('/services/client/get_list', {}, { ...phone, bearer: credential });
      expect(member).toHaveProperty('clientList');
      const stranger = { where: 'phone', host: MASTER_V6, from: PHONE_V6 } as const;
      expect(await call('/services/server_configuration', {}, stranger)).toHaveProperty('server');
    }
    const { limitList } = (await call(
      '/services/ubii/limit_list',
      {},
      { where: 'master', host: '127.0.0.1' },
    )) as { limitList: { elements: { name: string; hits?: string; value: number }[] } };
    const limitOf = (name: string) => limitList.elements.find((each) => each.name === name);
    expect(limitOf('connections')?.value).toBe((DESCRIPTORS - 128) / 2);
    expect(Number(limitOf('connectionsOfStrangers')?.hits)).toBeGreaterThan(0);
    expect(Number(limitOf('connectionsPerAddress')?.hits)).toBeGreaterThan(0);
  });
});
