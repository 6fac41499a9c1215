import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { buildNodeWorker } from '@ubii/pm-sandbox/build';
import { temporaryFolder } from '@ubii/program/testing';
import { fromJson, type ServiceReply, type Session } from '@ubii/proto';
import { afterAll, beforeAll, describe, expect, it, vi } from 'vitest';

import { startEdgeMaster, type EdgeMaster } from './edge-master.ts';

const PATIENCE = { timeout: 20_000, interval: 50 };

const workerFolder = temporaryFolder(afterAll);
let workerFile: URL;

beforeAll(async () => {
  const file = join(workerFolder, 'pm-worker.js');
  await buildNodeWorker(file);
  workerFile = pathToFileURL(file);
}, 60_000);

async function call(master: EdgeMaster, request: object): Promise<ServiceReply> {
  const response = await fetch(`${master.url}/services/json`, {
    method: 'POST',
    headers: { 'content-type': 'application/json' },
    body: JSON.stringify(request),
  });
  return fromJson('ubii.services.ServiceReply', await response.json());
}

async function session(master: EdgeMaster, id: string): Promise<Session> {
  const reply = await call(master, { topic: '/services/session/runtime/get', session: { id } });
  return reply.session!;
}

function running(name: string, onProcessingStringified: string, extension = {}) {
  return {
    topic: '/services/session/runtime/start',
    session: {
      name,
      processingModules: [
        {
          name,
          outputs: [{ internalName: 'out', messageFormat: 'string' }],
          onProcessingStringified,
        },
      ],
      ioMappings: [
        { processingModuleName: name, outputMappings: [{ outputName: 'out', topic: `/${name}` }] },
      ],
      extension,
    },
  };
}

async function valueOf(master: EdgeMaster, topic: string): Promise<boolean> {
  const { stringList } = await call(master, { topic: '/services/topic_list' });
  return stringList!.elements.includes(topic);
}

describe('a master with its real workers', () => {
  it('runs code of clients in a sandbox: it finds nothing there [PM-50] [PM-52]', async () => {
    const master = await startEdgeMaster({ workerFile });
    const { session: started, error } = await call(
      master,
      running(
        'prober',
        '() => ({ outputs: { out: { string: [typeof process, typeof require, typeof fetch].join() } } })',
      ),
    );
    expect(error).toBeUndefined();
    await vi.waitFor(async () => {
      expect((await session(master, started!.id)).extension?.state).toBe(2);
      expect(await valueOf(master, '/prober')).toBe(true);
    }, PATIENCE);
  }, 60_000);

  it('ends an endless loop, and says where it was, while others run on [PM-53] [SE-12]', async () => {
    const master = await startEdgeMaster({ workerFile });
    const good = await call(
      master,
      running('good', '() => ({ outputs: { out: { string: "a" } } })'),
    );
    const bad = await call(master, running('bad', '() => {\n  for (;;) ;\n}'));
    await vi.waitFor(async () => {
      const { extension } = await session(master, bad.session!.id);
      expect(extension?.problems.map(({ code }) => code)).toContain('module_failed');
    }, PATIENCE);
    expect((await session(master, good.session!.id)).extension?.state).toBe(2);
  }, 60_000);

  it('keeps what runs for the next master, in files people can read [SE-20] [SE-24]', async () => {
    const dataDir = temporaryFolder();
    const first = await startEdgeMaster({ workerFile, dataDir });
    const code = '() => ({ outputs: { out: { string: "a" } } })';
    const { session: started } = await call(
      first,
      running('lasting', code, { startWithMaster: true }),
    );
    await call(first, {
      topic: '/services/session/database/save',
      session: { id: started!.id, name: 'lasting' },
    });
    expect(readdirSync(join(dataDir, 'sessions'))).toEqual(['lasting.session']);
    await first.close();
    writeFileSync(join(dataDir, 'sessions', 'broken.session'), '{');

    const second = await startEdgeMaster({ workerFile, dataDir });
    await vi.waitFor(async () => {
      expect((await session(second, started!.id)).extension).toMatchObject({
        state: 2,
        stored: true,
      });
    }, PATIENCE);
    expect(second.logged.join('\n')).toContain('broken.session');
  }, 60_000);

  it('takes modules of its operator, and what changes there [PM-51] [PM-64]', async () => {
    const folder = temporaryFolder();
    const write = (name: string, word: string): void =>
      writeFileSync(
        join(folder, `${name}.js`),
        `export default { name: '${name}', inputs: {}, outputs: { out: 'string' },
           onProcessing() { return { outputs: { out: { string: '${word}' } } }; } };`,
      );
    write('mine', 'one');
    const master = await startEdgeMaster({ workerFile, flags: ['--modules', folder] });
    const names = async (): Promise<string[]> => {
      const { processingModuleList } = await call(master, {
        topic: '/services/processing_module/database/get_list',
      });
      return processingModuleList!.elements.map(({ name }) => name);
    };
    expect(await names()).toEqual(expect.arrayContaining(['mine', 'mirror-pointer']));
    const { session: started, error } = await call(master, {
      topic: '/services/session/runtime/start',
      session: {
        processingModules: [{ name: 'mine' }],
        ioMappings: [
          {
            processingModuleName: 'mine',
            outputMappings: [{ outputName: 'out', topic: '/mine' }],
          },
        ],
      },
    });
    expect(error).toBeUndefined();
    await vi.waitFor(async () => expect(await valueOf(master, '/mine')).toBe(true), PATIENCE);
    expect((await session(master, started!.id)).extension?.state).toBe(2);
    write('another', 'two');
    await vi.waitFor(async () => expect(await names()).toContain('another'), PATIENCE);
  }, 60_000);

  it('gives trusted modules their asset sets, and says which is missing [PM-90] [PM-95]', async () => {
    const folder = temporaryFolder();
    const dataDir = temporaryFolder();
    writeFileSync(
      join(folder, 'greeter.js'),
      `export default { name: 'greeter', assets: ['greeting'], inputs: {}, outputs: { out: 'string' },
         onProcessing(dt, inputs, state) {
           const text = String.fromCharCode(...state.assets.greeting['a.txt']);
           return { outputs: { out: { string: text } } };
         } };`,
    );
    const master = await startEdgeMaster({ workerFile, dataDir, flags: ['--modules', folder] });
    const start = {
      topic: '/services/session/runtime/start',
      session: {
        name: 'greets',
        processingModules: [{ name: 'greeter' }],
        ioMappings: [
          {
            processingModuleName: 'greeter',
            outputMappings: [{ outputName: 'out', topic: '/greeter' }],
          },
        ],
      },
    };
    const without = await call(master, start);
    await vi.waitFor(async () => {
      const { extension } = await session(master, without.session!.id);
      expect(extension?.problems.map(({ message }) => message).join()).toContain(
        'The master has no asset set greeting. Put its files into the folder models/greeting',
      );
    }, PATIENCE);

    mkdirSync(join(dataDir, 'models', 'greeting'), { recursive: true });
    writeFileSync(join(dataDir, 'models', 'greeting', 'a.txt'), 'hello');
    await call(master, { topic: '/services/session/runtime/stop', session: without.session });
    await call(master, start);
    await vi.waitFor(async () => expect(await valueOf(master, '/greeter')).toBe(true), PATIENCE);
  }, 60_000);

  it('does not start with a folder of modules that is not there', async () => {
    await expect(
      startEdgeMaster({ workerFile, flags: ['--modules', '/not/there'] }),
    ).rejects.toThrow('--modules');
  });
});
