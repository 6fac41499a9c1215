import { createMemoryIdentity } from '@ubii/client-web/node';
import { createClient } from '@ubii/client-web/node';
import type { UbiiClient } from '@ubii/client-web/node';
import { AccessRole, SessionState } from '@ubii/proto';
import type { Init, ProcessingModule, Session } from '@ubii/proto';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { startMaster, startNode } from './programs.ts';

// Each test starts two programs, which takes long on a busy machine.
vi.setConfig({ testTimeout: 60_000 });
const POLL = { timeout: 30_000 };

interface Printed {
  readonly id: string;
  readonly name: string;
  readonly master: string;
  readonly pid: number;
}

const printing = ['--print-endpoints', 'json'];

const triple = `export default {
  name: 'triple', inputs: { in: 'double' }, outputs: { out: 'double' }, mode: { triggerOnInput: {} },
  onProcessing(deltaTime, inputs, state) {
    if (inputs.in) return { outputs: { out: { double: inputs.in.double * 3 } } };
  },
};`;

async function joinAs(url: string, name = 'guest'): Promise<UbiiClient> {
  const client = createClient({ url, name, identity: createMemoryIdentity() });
  onTestFinished(() => client.close());
  await client.connect();
  return client;
}

function sessionOf(module: Init<ProcessingModule>): Init<Session> {
  const { name = '' } = module;
  return {
    name: `session of ${name}`,
    processingModules: [module],
    ioMappings: [
      {
        processingModuleName: name,
        inputMappings: [{ inputName: 'in', topic: '/in' }],
        outputMappings: [{ outputName: 'out', topic: '/out' }],
      },
    ],
  };
}

async function nodeNames(client: UbiiClient): Promise<string[]> {
  const { elements } = await client.call('nodeList');
  return elements.slice(1).map(({ name }) => name);
}

/** Publishes until the module publishes this value; an older value may come first. */
async function expectOut(client: UbiiClient, value: number, output: number): Promise<void> {
  let newest: unknown;
  const subscription = client.subscribe('/out').onRecord((record) => (newest = record.value));
  await subscription.ready;
  newest = undefined;
  try {
    await expect
      .poll(() => {
        client.publish('/in', 'double', value);
        return newest;
      }, POLL)
      .toBe(output);
  } finally {
    await subscription.close();
  }
}

describe('the node as a process', () => {
  it('is a participant on the machine of the master, and an admin with the file of its token [AC-40] [AC-44]', async () => {
    const master = await startMaster({ trustsLoopback: false });
    const identity = ['--identity', 'off', '--master', master.url];
    const tokenFile = ['--token-file', join(master.dataDir, 'admin-token')];
    const [plain, admin] = [
      startNode([...identity, ...printing]),
      startNode([...identity, ...tokenFile, ...printing]),
    ];
    const ids = [(await plain.ready<Printed>()).id, (await admin.ready<Printed>()).id];
    const client = await joinAs(master.url);
    const { clients } = await client.call('clientReport', { clientIds: ids });
    const roleOf = (id: string | undefined) => clients.find((one) => one.clientId === id)?.role;
    expect(ids.map(roleOf)).toEqual([
      AccessRole.ACCESS_ROLE_PARTICIPANT,
      AccessRole.ACCESS_ROLE_ADMIN,
    ]);
  });

  it('[PM-60] [SE-30] runs a module of its folder, which a session names', async () => {
    const master = await startMaster();
    const folder = temporaryFolder();
    writeFileSync(join(folder, 'triple.js'), triple);
    const node = startNode([
      ...['--master', master.url, '--modules', folder, '--name', 'kitchen'],
      ...printing,
    ]);
    const printed = await node.ready<Printed>();
    expect(printed).toMatchObject({ name: 'kitchen', master: master.url, pid: node.child.pid });
    const client = await joinAs(master.url);
    const session = await client.call('sessionRuntimeStart', sessionOf({ name: 'triple' }));
    expect(session.processingModules[0]?.nodeId).toBe(printed.id);
    await expectOut(client, 4, 12);
    await node.says('Started module "triple" of session "session of triple"');
    await client.call('sessionRuntimeStop', { id: session.id });
    await node.says('Stopped module "triple"');
    await expect
      .poll(async () => (await client.call('sessionRuntimeGet', session)).extension?.state, POLL)
      .toBe(SessionState.SESSION_STOPPED);
  });

  it('[PM-90] [PM-94] loads the asset sets of its modules from the master', async () => {
    const { url, dataDir } = await startMaster();
    mkdirSync(join(dataDir, 'models', 'factor'), { recursive: true });
    writeFileSync(join(dataDir, 'models', 'factor', 'factor.json'), '[5]');
    const folder = temporaryFolder();
    writeFileSync(
      join(folder, 'by-factor.js'),
      triple
        .replace("'triple',", "'by-factor', assets: ['factor'],")
        .replace(
          '* 3',
          "* JSON.parse(String.fromCharCode(...state.assets.factor['factor.json']))[0]",
        ),
    );
    const node = startNode(['--master', url, '--modules', folder, ...printing]);
    await node.ready<Printed>();
    const client = await joinAs(url);
    await client.call('sessionRuntimeStart', sessionOf({ name: 'by-factor' }));
    await expectOut(client, 4, 20);
    await node.says('Loading the asset set factor: 100 %');
  });

  it('logs files that cannot be loaded, and applies changes at once', async () => {
    const master = await startMaster();
    const folder = temporaryFolder();
    writeFileSync(join(folder, 'broken.pm'), '{');
    const node = startNode(['--master', master.url, '--modules', folder, ...printing]);
    const { id } = await node.ready<Printed>();
    await node.says('broken.pm: ');
    const client = await joinAs(master.url);
    const offered = async (): Promise<readonly string[]> => {
      const { elements } = await client.call('nodeList');
      return elements.find(({ clientId }) => clientId === id)?.moduleNames ?? [];
    };
    expect(await offered()).not.toContain('triple');
    writeFileSync(join(folder, 'triple.mjs'), triple);
    await expect.poll(offered, POLL).toContain('triple');
    rmSync(join(folder, 'triple.mjs'));
    await expect.poll(offered, POLL).not.toContain('triple');
  });

  it.each(['SIGTERM', 'SIGINT', 'SIGHUP'] as const)('deregisters on %s', async (signal) => {
    const master = await startMaster();
    const node = startNode(['--master', master.url, '--name', 'leaving', ...printing]);
    await node.ready<Printed>();
    const client = await joinAs(master.url);
    expect(await nodeNames(client)).toEqual(['leaving']);
    node.child.kill(signal);
    expect(await node.ended()).toBe(0);
    expect(await nodeNames(client)).toEqual([]);
  });

  it('exits in time when the master is not available', async () => {
    const master = await startMaster();
    const node = startNode(['--master', master.url, ...printing]);
    await node.ready<Printed>();
    await master.kill();
    node.child.kill('SIGINT');
    expect(await node.ended()).toBe(0);
  });

  it('exits when its parent process ends', async () => {
    const master = await startMaster();
    const node = startNode(['--master', master.url, ...printing], { withChannel: true });
    await node.ready<Printed>();
    node.child.disconnect();
    expect(await node.ended()).toBe(0);
  });

  it('connects to a master that starts later, and to one that restarts', async () => {
    const master = await startMaster();
    await master.kill();
    const node = startNode(['--master', master.url, '--name', 'patient', ...printing]);
    await node.says('Retrying until it succeeds');
    await master.restart();
    const { id } = await node.ready<Printed>();
    await master.kill();
    await node.says(/until it succeeds[^]*until it succeeds/);
    await master.restart();
    const client = await joinAs(master.url);
    await expect.poll(() => nodeNames(client), POLL).toEqual(['patient']);
    const { elements } = await client.call('nodeList');
    expect(elements[1]?.clientId).toBe(id);
  });

  it('[PM-63] gets the modules that sessions assigned to it, in a new run', async () => {
    const master = await startMaster();
    const identity = join(temporaryFolder(), 'identity.json');
    const flags = ['--master', master.url, '--identity', identity, ...printing];
    const first = startNode(flags);
    const { id } = await first.ready<Printed>();
    const client = await joinAs(master.url);
    const code =
      '(dt, inputs) => { if (inputs.in) return { outputs: { out: { double: inputs.in.double + 1 } } }; }';
    const started = await client.call(
      'sessionRuntimeStart',
      sessionOf({
        name: 'plus-one',
        nodeId: id,
        inputs: [{ internalName: 'in', messageFormat: 'double' }],
        outputs: [{ internalName: 'out', messageFormat: 'double' }],
        processingMode: { triggerOnInput: {} },
        onProcessingStringified: code,
      }),
    );
    await expectOut(client, 1, 2);
    first.child.kill('SIGTERM');
    await first.ended();
    const state = async () => (await client.call('sessionRuntimeGet', started)).extension?.state;
    await expect.poll(state, POLL).toBe(SessionState.SESSION_DEGRADED);
    const second = startNode(flags);
    expect((await second.ready<Printed>()).id).toBe(id);
    await expect.poll(state, POLL).toBe(SessionState.SESSION_RUNNING);
    await expectOut(client, 5, 6);
    expect(JSON.parse(readFileSync(identity, 'utf8'))).toMatchObject({ clientId: id });
  });

  it('does not use an identity that another process uses', async () => {
    const master = await startMaster();
    const identity = join(temporaryFolder(), 'identity.json');
    const flags = ['--master', master.url, '--identity', identity, ...printing];
    const first = startNode(flags);
    const { id } = await first.ready<Printed>();
    const second = startNode(flags);
    expect((await second.ready<Printed>()).id).not.toBe(id);
    const client = await joinAs(master.url);
    expect(await nodeNames(client)).toHaveLength(2);
  });

  it('[PM-52] lets modules read from allowed origins only', async () => {
    const master = await startMaster();
    const node = startNode(['--master', master.url, '--allow-fetch', master.url, ...printing]);
    const { id } = await node.ready<Printed>();
    const client = await joinAs(master.url);
    const texts: unknown[] = [];
    await client.subscribe('/text').onRecord(({ value }) => texts.push(value)).ready;
    const module = {
      name: 'reader',
      nodeId: id,
      outputs: [{ internalName: 'text', messageFormat: 'string' }],
      processingMode: { frequency: { hertz: 5 } },
      extension: { libraries: ['http'] },
      onProcessingStringified: `async (dt, inputs, state) => {
        const own = await state.modules.http.get('${master.url}/health');
        const other = await state.modules.http.get('http://127.0.0.1:9/').catch((error) => error.message);
        return { outputs: { text: { string: own.status + ' ' + other } } };
      }`,
    };
    await client.call('sessionRuntimeStart', {
      name: 'reading',
      processingModules: [module],
      ioMappings: [
        {
          processingModuleName: 'reader',
          inputMappings: [],
          outputMappings: [{ outputName: 'text', topic: '/text' }],
        },
      ],
    });
    await expect.poll(() => texts[0], POLL).toMatch(/^200 .*not allowed/);
  });

  it('[PM-53] continues after a module that never returns', async () => {
    const master = await startMaster();
    const node = startNode(['--master', master.url, ...printing]);
    const { id } = await node.ready<Printed>();
    const client = await joinAs(master.url);
    const base = { nodeId: id, outputs: [{ internalName: 'out', messageFormat: 'double' }] };
    await client.call('sessionRuntimeStart', {
      ...sessionOf({ ...base, name: 'endless', onProcessingStringified: '() => { for (;;); }' }),
      ioMappings: [],
    });
    await node.says(/endless onProcessing.*: /);
    const session = await client.call('sessionRuntimeStart', {
      ...sessionOf({
        ...base,
        name: 'well',
        inputs: [{ internalName: 'in', messageFormat: 'double' }],
        processingMode: { triggerOnInput: {} },
        onProcessingStringified:
          '(dt, inputs) => { if (inputs.in) return { outputs: { out: { double: -inputs.in.double } } }; }',
      }),
    });
    expect(session.id).not.toBe('');
    await expectOut(client, 8, -8);
  });
});

describe('a node that cannot start prints the reason in one line', () => {
  it.each([
    [['--mastre', 'x'], 'Unknown flag --mastre'],
    [['--master', 'ftp://x'], '--master must be an http or https URL'],
    [['--master'], '--master needs a value'],
    [['--allow-fetch', 'example.org'], '--allow-fetch must be origins'],
    [['--modules', '/not/there'], 'The module folder /not/there (--modules) cannot be read'],
    [['stray'], 'Unexpected argument "stray"'],
  ])('%j', async (flags, reason) => {
    const node = startNode(flags);
    expect(await node.ended()).toBe(1);
    expect(node.stdout).toBe('');
    expect(node.stderr).toContain(reason);
    expect(node.stderr.trimEnd()).not.toContain('\n');
  });

  it('shows help and version, also with invalid flags', async () => {
    const help = startNode(['--help', '--master', 'x']);
    expect(await help.ended()).toBe(0);
    expect(help.stdout).toContain('--no-accept-work');
    const version = startNode(['--version']);
    expect(await version.ended()).toBe(0);
    expect(version.stdout).toMatch(/^\d+\.\d+\.\d+\n$/);
  });
});
