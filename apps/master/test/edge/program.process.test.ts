import { execFileSync, spawn } from 'node:child_process';
import type { ChildProcess } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { temporaryFolder } from '@ubii/program/testing';
import { decodeTopicData, encode, RECORDING_STATUS_TOPIC, type RecordingList } from '@ubii/proto';
import { beforeAll, describe, expect, it, onTestFinished, vi } from 'vitest';
import { WebSocket } from 'ws';

// A whole master each: minutes on a busy machine are no fault of it.
vi.setConfig({ testTimeout: 60_000 });
const WAIT = { timeout: 30_000 };

const packageFolder = fileURLToPath(new URL('../..', import.meta.url));
/** The program as `npm start` runs it, built from the sources as they are now. */
const program = join(packageFolder, '.cache', 'main.js');

beforeAll(() => {
  execFileSync(process.execPath, ['build.mjs', '.cache'], { cwd: packageFolder });
}, 60_000);

class Program {
  readonly child: ChildProcess;
  stdout = '';
  stderr = '';

  constructor(flags: readonly string[], { withChannel = false } = {}) {
    this.child = spawn(process.execPath, [program, ...flags], {
      stdio: ['ignore', 'pipe', 'pipe', ...(withChannel ? (['ipc'] as const) : [])],
      env: { PATH: process.env['PATH'], HOME: temporaryFolder() },
    });
    this.child.stdout?.on('data', (text) => (this.stdout += text));
    this.child.stderr?.on('data', (text) => (this.stderr += text));
    onTestFinished(() => {
      this.child.kill('SIGKILL');
    });
  }

  /** Exit code and everything written, once the process ended. */
  ended(): Promise<{ code: number | null; stdout: string; stderr: string }> {
    return new Promise((resolve) =>
      this.child.once('close', (code) =>
        resolve({ code, stdout: this.stdout, stderr: this.stderr }),
      ),
    );
  }

  /** The line of `--print-endpoints json`. */
  ready(): Promise<Endpoints> {
    return new Promise((resolve, reject) => {
      this.child.stdout?.on('data', () => {
        if (this.stdout.includes('\n')) resolve(JSON.parse(this.stdout) as Endpoints);
      });
      this.child.once('close', () => reject(new Error(this.stderr)));
    });
  }
}

interface Endpoints {
  readonly url: string;
  readonly servicesJson: string;
  readonly servicesBinary: string;
  readonly topicDataWs: string;
  readonly pid: number;
}

const quiet = [
  ...['--lan', 'off', '--port', '0', '--legacy-ports', 'off'],
  ...['--print-endpoints', 'json'],
];

function start(flags: readonly string[] = []): Program {
  return new Program([...quiet, ...flags]);
}

async function takePort(): Promise<number> {
  const server = createServer();
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  onTestFinished(() => void server.close());
  return (server.address() as AddressInfo).port;
}

/** A client that publishes to a master and receives its announcements of recordings. */
class Publisher {
  /** Records in the running recording, as the master said last: they are in its file. */
  recordCount = 0;
  readonly #socket: WebSocket;

  private constructor(socket: WebSocket) {
    this.#socket = socket;
    socket.binaryType = 'arraybuffer';
    socket.on('message', (data, isBinary) => {
      if (!isBinary) return;
      for (const record of decodeTopicData(new Uint8Array(data as ArrayBuffer)).records) {
        if (record.format !== 'recordingStatus') continue;
        this.recordCount = record.value.running[0]?.recordCount ?? 0;
      }
    });
    socket.on('error', () => undefined);
  }

  static async open({ servicesJson, topicDataWs }: Endpoints): Promise<Publisher> {
    const registration = { name: 'publisher', extension: { recordLists: true } };
    const { client } = await callJson<{
      client: { id: string; extension: { resumeToken: string } };
    }>(servicesJson, { topic: '/services/client/registration', client: registration });
    const { id, extension } = client;
    const query = `?token=${extension.resumeToken}&clientID=${id}`;
    const socket = new WebSocket(`${topicDataWs}${query}`);
    await new Promise((resolve) => socket.once('open', resolve));
    await callJson(servicesJson, {
      topic: '/services/topic_subscription',
      topicSubscription: { clientId: id, subscribeTopics: [RECORDING_STATUS_TOPIC] },
    });
    return new Publisher(socket);
  }

  /** Publishes as fast as the socket takes it, until it closes. */
  publishAtFullSpeed(): void {
    const frame = encode('ubii.topicData.TopicData', {
      topicDataRecordList: {
        elements: Array.from({ length: 100 }, (_, index) => ({
          topic: `/lab/${index % 10}`,
          double: index,
        })),
      },
    });
    const send = (): void => {
      if (this.#socket.readyState !== WebSocket.OPEN) return;
      this.#socket.send(frame, () => setImmediate(send));
    };
    send();
  }
}

async function callJson<T>(url: string, request: object): Promise<T> {
  const headers = { 'content-type': 'application/json' };
  const response = await fetch(url, { method: 'POST', body: JSON.stringify(request), headers });
  return (await response.json()) as T;
}

describe('a master that is killed while it records', () => {
  it('[RC-7] has all but the last moment in the file when it starts again', async () => {
    const flags = ['--data-dir', temporaryFolder()];
    const master = start(flags);
    const endpoints = await master.ready();
    const publisher = await Publisher.open(endpoints);
    await callJson(endpoints.servicesJson, {
      topic: '/services/ubii/recording_start',
      recordingStartRequest: { name: 'Cut' },
    });
    publisher.publishAtFullSpeed();
    await vi.waitFor(() => expect(publisher.recordCount).toBeGreaterThan(1_000), WAIT);
    master.child.kill('SIGKILL');
    await master.ended();
    const written = publisher.recordCount;
    const next = await start(flags).ready();
    const { recordingList } = await callJson<{ recordingList: RecordingList }>(next.servicesJson, {
      topic: '/services/ubii/recording_list',
    });
    const [cut] = recordingList.elements;
    expect(cut).toMatchObject({ name: 'Cut', problem: expect.stringContaining('may be missing') });
    expect(cut!.recordCount).toBeGreaterThanOrEqual(written);
    const response = await fetch(`${next.url}/recordings/${cut!.id}.mcap`);
    expect(new Uint8Array(await response.arrayBuffer()).length).toBe(cut!.sizeBytes);
  });
});

describe('the master as a process', () => {
  it('prints one line of JSON when it is ready, and everything else on standard error', async () => {
    const master = start();
    const endpoints = await master.ready();
    expect(endpoints.pid).toBe(master.child.pid);
    expect(endpoints.url).toMatch(/^http:\/\/localhost:\d+$/);
    expect(endpoints.servicesBinary).toBe(`${endpoints.url}/services/binary`);
    expect(endpoints.topicDataWs).toBe(`${endpoints.url.replace('http', 'ws')}/topicdata`);
    const reply = await fetch(endpoints.servicesJson, {
      method: 'POST',
      body: '{"topic":"/services/server_configuration"}',
    });
    expect(await reply.json()).toHaveProperty('server');
    expect(master.stdout.split('\n')).toEqual([expect.any(String), '']);
    expect(master.stderr).toContain(endpoints.url);
  });

  it.each(['SIGTERM', 'SIGINT', 'SIGHUP'] as const)('ends in good order on %s', async (signal) => {
    const master = start();
    const { topicDataWs } = await master.ready();
    const socket = new WebSocket(`${topicDataWs}?clientID=unknown`);
    await new Promise((resolve) => socket.once('close', resolve));
    const ended = master.ended();
    master.child.kill(signal);
    expect((await ended).code).toBe(0);
  });

  it('says in the terminal that it stopped, and nothing on the line for programs', async () => {
    const shown = new Program(
      quiet.filter((flag) => !['--print-endpoints', 'json'].includes(flag)),
    );
    await vi.waitFor(() => expect(shown.stdout).toContain('http://localhost:'), 30_000);
    const ended = shown.ended();
    shown.child.kill('SIGINT');
    expect((await ended).stdout).toMatch(/\nStopped\.\n$/);
    const master = start();
    await master.ready();
    const endedToo = master.ended();
    master.child.kill('SIGINT');
    expect((await endedToo).stdout).not.toContain('Stopped');
  });

  it('ends with the program that started it', async () => {
    const master = new Program(quiet, { withChannel: true });
    await master.ready();
    const exited = new Promise((resolve) => master.child.once('exit', resolve));
    master.child.disconnect();
    expect(await exited).toBe(0);
  });

  it('shows help and version, whatever else is wrong', async () => {
    const help = await new Program(['--help', '--port', 'x']).ended();
    expect(help).toMatchObject({ code: 0, stderr: '' });
    expect(help.stdout).toContain('--legacy-ports');
    const { version } = JSON.parse(readFileSync(join(packageFolder, 'package.json'), 'utf8')) as {
      version: string;
    };
    expect(await new Program(['--version']).ended()).toMatchObject({
      code: 0,
      stdout: `${version}\n`,
    });
  });
});

describe('a master that cannot start says why in one sentence', () => {
  async function refusal(flags: readonly string[]): Promise<string> {
    const { code, stdout, stderr } = await new Program(flags).ended();
    expect(code).toBe(1);
    expect(stdout).toBe('');
    expect(stderr.trimEnd()).not.toContain('\n');
    return stderr;
  }

  it('when a flag is unknown or wrong', async () => {
    expect(await refusal(['--prot', '1'])).toContain(
      'Unknown flag --prot. Use --help to list all flags.',
    );
    expect(await refusal(['--port', 'x'])).toContain('--port must be a whole number');
  });

  it('when its port is taken', async () => {
    const port = await takePort();
    const message = await refusal(['--lan', 'off', '--port', String(port)]);
    expect(message).toContain(`Port ${port} (--port) is used by another program`);
  });

  it('when a legacy port that was asked for is taken', async () => {
    const port = await takePort();
    const message = await refusal(['--lan', 'off', '--port', '0', '--legacy-ports', `0,${port}`]);
    expect(message).toContain(`Port ${port} (--legacy-ports) is used`);
  });

  it('when the data directory cannot be written', async () => {
    const file = join(temporaryFolder(), 'file');
    writeFileSync(file, '');
    expect(await refusal([...quiet, '--data-dir', file])).toContain('a file has that name');
  });
});
