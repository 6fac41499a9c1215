import { mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { buildNodeWorker } from '@ubii/pm-sandbox/build';
import { temporaryFolder } from '@ubii/program/testing';
import { decode, encode, fromJson, type ServiceReply } from '@ubii/proto';
import { afterAll, beforeAll, describe, expect, it, onTestFinished, vi } from 'vitest';
import { WebSocket } from 'ws';

import { startEdgeMaster, type EdgeMaster } from './edge-master.ts';

const PATIENCE = { timeout: 20_000, interval: 50 };

const workerFolder = temporaryFolder(afterAll);
let workerFile: URL;

beforeAll(async () => {
  const file = join(workerFolder, 'pm-worker.js');
  await buildNodeWorker(file);
  workerFile = pathToFileURL(file);
}, 60_000);

const number = (internalName: string) => ({ internalName, messageFormat: 'double' });

/** Files in the form of an original installation. */
const FILES: Readonly<Record<string, string>> = {
  'database/sessions/chain.session': JSON.stringify({
    id: '6f1a4d0e-60a5-4c60-9d57-5c4d7c8d7b60',
    name: 'chain',
    processingModules: [{ name: 'add-one' }, { name: 'times-ten' }],
    ioMappings: [
      {
        processingModuleName: 'add-one',
        inputMappings: [{ inputName: 'in', topicSource: '/chain/in' }],
        outputMappings: [{ outputName: 'out', topicDestination: '/chain/between' }],
      },
      {
        processingModuleName: 'times-ten',
        inputMappings: [{ inputName: 'in', topic: '/chain/between' }],
        outputMappings: [{ outputName: 'out', topic: '/chain/out' }],
      },
    ],
  }),
  'database/sessions/broken.session': '{ "name": "broken", ',
  'database/processing/add-one.pm': JSON.stringify({
    name: 'add-one',
    processingMode: { triggerOnInput: {} },
    inputs: [number('in')],
    outputs: [number('out')],
    onProcessingStringified:
      '(deltaTime, inputs, outputs, state) => {\n  outputs.out = inputs.in + 1;\n}',
  }),
  'database/processing/pm-times-ten.js': `
    const { MSG_TYPES } = require('@tum-far/ubii-msg-formats');
    const { ProcessingModule } = require('../../src/processing/processingModule.js');
    class TimesTen extends ProcessingModule {
      static specs = {
        name: 'times-ten',
        inputs: [{ internalName: 'in', messageFormat: MSG_TYPES.DATASTRUCTURE_DOUBLE }],
        outputs: [{ internalName: 'out', messageFormat: MSG_TYPES.DATASTRUCTURE_DOUBLE }],
        processingMode: { triggerOnInput: {} }
      };
      constructor(specs) { super(specs); Object.assign(this, TimesTen.specs); }
      onCreated() { this.factor = 10; }
      onProcessing(deltaTime, inputs) {
        return { outputs: { out: { double: this.factor * inputs.in.double } } };
      }
    }
    module.exports = TimesTen;`,
  'database/processing/pm-model.js': "const tf = require('@tensorflow/tfjs-node');",
  'config.json': '{ "ports": { "serviceREST": 8102 } }',
};

function writeOriginal(): string {
  const folder = temporaryFolder();
  for (const kind of ['sessions', 'processing']) {
    mkdirSync(join(folder, 'database', kind), { recursive: true });
  }
  for (const [name, text] of Object.entries(FILES)) writeFileSync(join(folder, name), text);
  return folder;
}

/** Names, contents and times of all files. */
function picture(folder: string): readonly unknown[] {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => {
      const path = join(entry.parentPath, entry.name);
      return [path, readFileSync(path, 'utf8'), statSync(path).mtimeMs];
    });
}

async function call(master: EdgeMaster, request: object): Promise<ServiceReply> {
  const response = await fetch(`${master.url}/services/json`, {
    method: 'POST',
    headers: { 'content-type': 'application/json' },
    body: JSON.stringify(request),
  });
  return fromJson('ubii.services.ServiceReply', await response.json());
}

describe('a master with the data of an original installation', () => {
  it('[SE-28] [SE-29] lists and runs its sessions, names what it cannot read, and changes no file', async () => {
    const original = writeOriginal();
    const before = picture(original);
    const master = await startEdgeMaster({ workerFile, flags: ['--original-data', original] });
    const listed = await call(master, { topic: '/services/session/database/get_list' });
    expect(listed.sessionList?.elements.map(({ name }) => name)).toEqual(['chain']);
    const unread = master.logged.filter((line) => line.includes('is ignored'));
    expect(unread.join()).toMatch(/broken\.session.*JSON/);
    expect(unread.join()).toMatch(/pm-model\.js.*tfjs-node/);

    const { client } = await call(master, {
      topic: '/services/client/registration',
      client: { name: 'old client' },
    });
    const socket = new WebSocket(`ws://127.0.0.1:${master.port}/?clientID=${client!.id}`);
    onTestFinished(() => socket.close());
    const seen: unknown[] = [];
    socket.on('message', (data: Buffer, isBinary: boolean) => {
      if (isBinary) seen.push(decode('ubii.topicData.TopicData', data).topicDataRecord?.double);
    });
    await new Promise((resolve) => socket.once('open', resolve));
    await call(master, {
      topic: '/services/topic_subscription',
      topicSubscription: { clientId: client!.id, subscribeTopics: ['/chain/out'] },
    });
    const { session, error } = await call(master, {
      topic: '/services/session/runtime/start',
      session: { name: 'chain' },
    });
    expect(error).toBeUndefined();
    expect(session).toMatchObject({ id: '6f1a4d0e-60a5-4c60-9d57-5c4d7c8d7b60' });
    const input = encode('ubii.topicData.TopicData', {
      topicDataRecord: { topic: '/chain/in', double: 6 },
    });
    await vi.waitFor(() => {
      socket.send(input);
      expect(seen).toContain(70);
    }, PATIENCE);

    await call(master, {
      topic: '/services/session/runtime/stop',
      session: { name: 'chain', id: session!.id },
    });
    const saved = await call(master, {
      topic: '/services/session/database/save',
      session: {
        id: session!.id,
        name: 'chain',
        description: 'changed here',
        processingModules: [{ name: 'add-one' }],
      },
    });
    expect(saved.error).toBeUndefined();
    const again = await call(master, { topic: '/services/session/database/get_list' });
    expect(again.sessionList?.elements).toMatchObject([{ description: 'changed here' }]);
    const deleted = await call(master, {
      topic: '/services/processing_module/database/delete',
      processingModule: { name: 'add-one' },
    });
    expect(deleted.error).toMatchObject({ code: 'failed_precondition' });
    expect(picture(original)).toEqual(before);
  }, 60_000);
});
