import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { temporaryFolder } from '@ubii/program/testing';
import { fromJson, RecordingKind, type Recording } from '@ubii/proto';
import { RecordingWriter } from '@ubii/recording';
import { DiskFile } from '@ubii/recording/node';
import {
  lz4Bomb,
  manyMarkers,
  MemoryFile,
  metadataIndexOf3Gib,
  recordChunkIndexOf3Gib,
} from '@ubii/recording/testing';
import type { Clock } from '@ubii/timing';
import { SystemClock } from '@ubii/timing/system';
import { FakeClock } from '@ubii/timing/testing';
import { build } from 'esbuild';
import { afterAll, beforeAll, describe, expect, it, onTestFinished } from 'vitest';

import { DiskFolder, recordingPath } from '@ubii/recording/node';
import { recordOnThread } from '@ubii/recording/thread';
import { DEFAULT_LIMITS } from '../../src/index.ts';
import {
  addAll,
  recorderSuite,
  recordsToKeep,
  runningJob,
} from '../../src/testing/acceptance/index.ts';
import { RecordingLog } from '../../src/testing/index.ts';
import { startEdgeMaster, type EdgeMaster } from './edge-master.ts';

const built = temporaryFolder(afterAll);
let workerFile: URL;
let checkProcessFile: URL;

beforeAll(async () => {
  const { resolve } = createRequire(import.meta.url);
  const entryPoints = Object.fromEntries(
    ['recorder-worker', 'check-process'].map((name) => [name, resolve(`@ubii/recording/${name}`)]),
  );
  await build({
    entryPoints,
    outdir: built,
    outExtension: { '.js': '.mjs' },
    bundle: true,
    platform: 'node',
    format: 'esm',
    logLevel: 'warning',
    banner: {
      js: "import { createRequire } from 'node:module'; const require = createRequire(import.meta.url);",
    },
  });
  workerFile = pathToFileURL(join(built, 'recorder-worker.mjs'));
  checkProcessFile = pathToFileURL(join(built, 'check-process.mjs'));
}, 60_000);

function openWorker(folder: string, file = workerFile, clock: Clock = new SystemClock()) {
  const log = new RecordingLog();
  const recorder = recordOnThread({
    folder,
    limits: DEFAULT_LIMITS,
    clock,
    workerFile: file,
    checkProcessFile,
    onFailure: (what, reason) => log.error(what, { reason }),
  });
  return { log, recorder };
}

recorderSuite('WorkerRecorder', () => {
  const folder = temporaryFolder();
  return {
    recorder: openWorker(folder).recorder,
    async file(id) {
      const file = await DiskFile.open(recordingPath(folder, id));
      onTestFinished(() => file.close());
      return file;
    },
    reopen: () => openWorker(folder).recorder,
  };
});

describe('WorkerRecorder', () => {
  it('[RC-19] goes on without recording when its thread cannot be had', async () => {
    const { recorder, log } = openWorker(temporaryFolder(), new URL('file:///not/there.mjs'));
    await expect(recorder.list()).rejects.toMatchObject({ code: 'unavailable' });
    addAll(recorder, recordsToKeep('/x', 3));
    expect(log.lines.filter(({ level }) => level === 'error')).toHaveLength(1);
    await recorder.close();
  });

  it('says that recordings can be listed again after a failure', async () => {
    const clock = new FakeClock();
    const nowhere = new URL('file:///not/there.mjs');
    const { recorder } = openWorker(temporaryFolder(), nowhere, clock);
    const revisions: number[] = [];
    recorder.onState(({ listRevision }) => revisions.push(listRevision));
    await expect(recorder.list()).rejects.toMatchObject({ code: 'unavailable' });
    expect(revisions).toEqual([1]);
    await clock.advance(5_000);
    expect(revisions).toEqual([1, 2]);
    await recorder.close();
  });

  it('takes many publishers, in batches', async () => {
    const folder = temporaryFolder();
    const { recorder } = openWorker(folder);
    await recorder.start(runningJob('a'));
    for (let i = 0; i < 50; i++) addAll(recorder, recordsToKeep(`/x/${i % 20}`, 100));
    expect(await recorder.stop('a')).toMatchObject({ recordCount: 5_000, topicCount: 20 });
    await recorder.close();
  });
});

interface Reply {
  readonly recording?: Recording;
  readonly recordingList?: { readonly elements: Recording[] };
}

async function call(master: EdgeMaster, request: object): Promise<Reply> {
  const response = await fetch(`${master.url}/services/json`, {
    method: 'POST',
    body: JSON.stringify(request),
    headers: { 'content-type': 'application/json' },
  });
  return (await response.json()) as Reply;
}

/** A recording of this master that is finished. */
async function record(master: EdgeMaster): Promise<Recording> {
  const recordingStartRequest = { name: 'Größe 1' };
  const topic = '/services/ubii/recording_start';
  const { recording } = await call(master, { topic, recordingStartRequest });
  await call(master, {
    topic: '/services/ubii/recording_stop',
    recordingRequest: { id: recording!.id },
  });
  return recording!;
}

/** A small MCAP file. */
async function mcapFile(): Promise<Uint8Array<ArrayBuffer>> {
  const file = new MemoryFile();
  const writer = await RecordingWriter.create(file, {
    name: 'Elsewhere',
    kind: 'recording',
    masterName: 'Other',
    version: '1',
    notes: '',
    selection: '',
  });
  for (const { source, record } of recordsToKeep('/x', 5)) {
    const timeNs = 1_750_000_000_000_000_000n;
    await writer.addRecord({ ...source, record, logTimeNs: timeNs, publishTimeNs: timeNs });
  }
  await writer.end();
  return Uint8Array.from(file.bytes);
}

describe('files of recordings over HTTP', () => {
  it('[RC-40] are sent as a whole, in ranges, and not twice', async () => {
    const master = await startEdgeMaster({ recorderWorkerFile: workerFile, checkProcessFile });
    const { id } = await record(master);
    const url = `${master.url}/recordings/${id}.mcap`;
    const whole = await fetch(url);
    const bytes = new Uint8Array(await whole.arrayBuffer());
    expect(whole.headers.get('content-disposition')).toContain('Gr%C3%B6%C3%9Fe%201.mcap');
    const etag = whole.headers.get('etag')!;
    const asked = async (headers: Record<string, string>) => {
      const response = await fetch(url, { headers });
      const body = new Uint8Array(await response.arrayBuffer());
      return { status: response.status, body, range: response.headers.get('content-range') };
    };
    const total = bytes.length;
    expect(await asked({ range: 'bytes=0-7' })).toEqual({
      status: 206,
      body: bytes.slice(0, 8),
      range: `bytes 0-7/${total}`,
    });
    expect(await asked({ range: 'bytes=-8' })).toMatchObject({ body: bytes.slice(-8) });
    expect(await asked({ range: 'bytes=8-' })).toMatchObject({ body: bytes.slice(8) });
    expect(await asked({ range: `bytes=${total}-` })).toMatchObject({
      status: 416,
      range: `bytes */${total}`,
    });
    expect(await asked({ range: 'lines=1-2' })).toMatchObject({ status: 200, body: bytes });
    const other = { range: 'bytes=0-7', 'if-range': '"other"' };
    expect(await asked(other)).toMatchObject({ status: 200, body: bytes });
    expect(await asked({ 'if-none-match': etag })).toMatchObject({ status: 304 });
    expect((await fetch(url, { method: 'HEAD' })).headers.get('content-length')).toBe(`${total}`);
    expect((await fetch(`${master.url}/recordings/..%2Fnothing.mcap`)).status).toBe(404);
  });

  it('[RC-41] are uploaded, and listed as imports', async () => {
    const dataDir = temporaryFolder();
    const master = await startEdgeMaster({
      dataDir,
      recorderWorkerFile: workerFile,
      checkProcessFile,
    });
    const url = `${master.url}/recordings`;
    const upload = async (body: BodyInit, query = '') => {
      const response = await fetch(url + query, { method: 'POST', body });
      return { status: response.status, json: await response.json() };
    };
    const { status, json } = await upload(await mcapFile(), '?name=Mine');
    expect(status).toBe(200);
    const recording = fromJson('ubii.extension.Recording', json);
    expect(recording).toMatchObject({ name: 'Mine', recordCount: 5, topicCount: 1 });
    expect(recording.kind).toBe(RecordingKind.RECORDING_KIND_IMPORT);
    expect((await fetch(`${url}/${recording.id}.mcap`)).status).toBe(200);
    expect((await upload('no recording')).status).toBe(400);
    expect(readdirSync(join(dataDir, 'recordings'))).toEqual([`${recording.id}.mcap`]);
  });

  it('[RC-41] are refused when they are too large', async () => {
    const dataDir = temporaryFolder();
    const flags = ['--limits', 'recordingUploadBytes=1000'];
    const master = await startEdgeMaster({
      dataDir,
      flags,
      recorderWorkerFile: workerFile,
      checkProcessFile,
    });
    const send = (body: BodyInit, more: object = {}) =>
      fetch(`${master.url}/recordings`, { method: 'POST', body, ...more });
    expect((await send('x'.repeat(1_001))).status).toBe(429);
    const unknownLength = new Blob(['x'.repeat(2_000)]).stream();
    expect((await send(unknownLength, { duplex: 'half' })).status).toBe(429);
    expect(readdirSync(join(dataDir, 'recordings'))).toEqual([]);
  });

  it('[RC-41] are refused while they arrive when there is no space left for recordings', async () => {
    const dataDir = temporaryFolder();
    const flags = ['--limits', 'recordingsBytes=3000'];
    const master = await startEdgeMaster({
      dataDir,
      flags,
      recorderWorkerFile: workerFile,
      checkProcessFile,
    });
    const send = (bytes: number) => {
      const body = new Blob(['x'.repeat(bytes)]).stream();
      // Not in the types of the DOM
      const init: RequestInit & { readonly duplex: 'half' } = {
        method: 'POST',
        body,
        duplex: 'half',
      };
      return fetch(`${master.url}/recordings`, init);
    };
    const refused = await send(4_000);
    expect(refused.status).toBe(429);
    expect(await refused.text()).toContain('recordingsBytes');
    expect(readdirSync(join(dataDir, 'recordings'))).toEqual([]);
    expect((await send(2_000)).status).toBe(400); // No recording, but not too large.
  });

  it('[EX-90] [RC-41] leave entries in the audit log, refused ones included', async () => {
    const dataDir = temporaryFolder();
    const master = await startEdgeMaster({
      dataDir,
      recorderWorkerFile: workerFile,
      checkProcessFile,
    });
    for (const [body, name] of [
      [await mcapFile(), 'Mine'],
      ['no recording', 'Text'],
    ] as const) {
      await fetch(`${master.url}/recordings?name=${name}`, { method: 'POST', body });
    }
    const response = await fetch(`${master.url}/services/json`, {
      method: 'POST',
      headers: { 'content-type': 'application/json' },
      body: JSON.stringify({ topic: '/services/ubii/audit_log', auditLogRequest: {} }),
    });
    const { auditLog } = (await response.json()) as { auditLog: { entries: object[] } };
    const service = 'POST /recordings';
    expect(auditLog.entries).toMatchObject([
      { service, object: 'Text', error: 'invalid_argument' },
      { service, object: 'Mine', error: '' },
    ]);
  });
});

describe('files of others', () => {
  it('[RC-43] [RC-44] [RC-45] end neither the master nor what it records', async () => {
    const dataDir = temporaryFolder();
    const folder = join(dataDir, 'recordings');
    mkdirSync(folder);
    writeFileSync(join(folder, 'liar.mcap'), metadataIndexOf3Gib());
    const flags = ['--limits', 'recordingCheckBytes=33554432'];
    const files = { recorderWorkerFile: workerFile, checkProcessFile };
    const master = await startEdgeMaster({ dataDir, flags, ...files });
    const running = await call(master, {
      topic: '/services/ubii/recording_start',
      recordingStartRequest: { name: 'Own' },
    });
    const upload = async (body: Uint8Array<ArrayBuffer>): Promise<string> => {
      const response = await fetch(`${master.url}/recordings`, { method: 'POST', body });
      return `${response.status} ${await response.text()}`;
    };
    expect(await upload(recordChunkIndexOf3Gib())).toMatch(/^400 .*no recording: The chunk at/);
    expect(await upload(lz4Bomb())).toMatch(/^400 .*no recording: The chunk at/);
    // Within all limits, and too much for a heap of 32 MiB.
    expect(await upload(manyMarkers(200_000))).toMatch(/^400 .*check did not come to an end/);
    const listOf = async (of: EdgeMaster): Promise<Recording[]> => {
      const { recordingList } = await call(of, { topic: '/services/ubii/recording_list' });
      return recordingList!.elements;
    };
    const states = (await listOf(master)).map(({ state }) => String(state)).sort();
    expect(states).toEqual([
      'RECORDING_STATE_RECORDING',
      'RECORDING_STATE_REJECTED',
      'RECORDING_STATE_REJECTED',
    ]);
    const { id } = running.recording!;
    const recordingRequest = { id };
    const topic = '/services/ubii/recording_stop';
    expect((await call(master, { topic, recordingRequest })).recording!.state).toBe(
      'RECORDING_STATE_COMPLETE',
    );
    const liar = await fetch(`${master.url}/recordings/liar.mcap`);
    expect(`${liar.status} ${await liar.text()}`).toMatch(/^400 .*It can only be deleted/);
    await master.close();

    const next = await startEdgeMaster({ dataDir, ...files });
    const again = (await listOf(next)).map(({ state }) => String(state)).sort();
    expect(again).toEqual([
      'RECORDING_STATE_COMPLETE',
      'RECORDING_STATE_REJECTED',
      'RECORDING_STATE_REJECTED',
    ]);
  });
});

it('[RC-7] [RC-42] DiskFolder forgets uploads of earlier runs, and lists recordings only', async () => {
  const folder = join(temporaryFolder(), 'recordings');
  const disk = new DiskFolder(folder);
  expect(await disk.list()).toEqual([]);
  expect(await disk.freeBytes()).toBeGreaterThan(0);
  mkdirSync(folder);
  for (const name of ['a.mcap', 'b.upload', 'notes.txt']) writeFileSync(join(folder, name), '');
  expect(await disk.list()).toEqual(['a']);
  expect(readdirSync(folder).sort()).toEqual(['a.mcap', 'notes.txt']);
});
