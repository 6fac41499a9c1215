import { once } from 'node:events';
import { readdirSync, writeFileSync } from 'node:fs';
import { connect, type Socket } from 'node:net';
import { join } from 'node:path';
import { connect as connectTls } from 'node:tls';
import { temporaryFolder } from '@ubii/program/testing';
import type { Cancel } from '@ubii/timing';
import { describe, expect, it, onTestFinished, vi } from 'vitest';

import { PreciseSystemClock } from '../../src/adapters/clock/precise-system-clock.ts';
import { RecordingLog } from '../../src/testing/index.ts';
import { send, startEdgeMaster } from './edge-master.ts';
import type { EdgeMaster } from './edge-master.ts';

vi.setConfig({ testTimeout: 60_000 });

/** Headers of a proxy: the master sees a caller that has not joined. */
const STRANGER = 'x-forwarded-for: 203.0.113.7';
const UPGRADE = [
  'connection: Upgrade',
  'upgrade: websocket',
  'sec-websocket-version: 13',
  'sec-websocket-key: AAAAAAAAAAAAAAAAAAAAAA==',
];
/** The other end of each connection is of this process, too, and stays open until the test ends it. */
const EACH = 50;

/** Ten times as fast as that of the system. */
class FastClock extends PreciseSystemClock {
  override monotonicMs(): number {
    return super.monotonicMs() * 10;
  }

  override every(intervalMs: number, fn: () => void): Cancel {
    return super.every(intervalMs / 10, fn);
  }

  override after(delayMs: number, fn: () => void): Cancel {
    return super.after(delayMs / 10, fn);
  }
}

/** A master whose deadlines come soon. */
function start(...flags: string[]): Promise<EdgeMaster> {
  const clock = new FastClock(new RecordingLog());
  return startEdgeMaster({ flags, clock, keepAliveMs: 300 });
}

/** Does something so many times at once. */
function times<T>(count: number, fn: () => Promise<T>): Promise<T[]> {
  return Promise.all(Array.from({ length: count }, fn));
}

async function open(port: number, text = ''): Promise<Socket & { readonly heard: () => string }> {
  const socket = connect({ port, host: '127.0.0.1', allowHalfOpen: true });
  let heard = '';
  socket.on('data', (chunk: Buffer) => (heard += chunk.toString('latin1')));
  socket.on('error', () => undefined);
  onTestFinished(() => void socket.destroy());
  await once(socket, 'connect');
  if (text !== '') socket.write(text);
  return Object.assign(socket, { heard: () => heard });
}

function request(master: EdgeMaster, path: string, lines: readonly string[]): string {
  return [`GET ${path} HTTP/1.1`, `host: localhost:${master.port}`, ...lines, '', ''].join('\r\n');
}

async function connections(master: EdgeMaster): Promise<number> {
  const { body } = await send(master.port, '/metrics', { headers: { connection: 'close' } });
  return Number(/^ubii_connections (\d+)$/m.exec(body.toString())?.[1]);
}

/** The connection that asks is one. */
async function expectNone(master: EdgeMaster): Promise<void> {
  await expect.poll(() => connections(master), { timeout: 30_000 }).toBe(1);
}

function descriptors(): number {
  return readdirSync('/proc/self/fd').length;
}

describe('refused sockets [AC-65]', () => {
  const refused = [
    ['a stranger', 403, '/topicdata?clientID=x', [STRANGER, ...UPGRADE]],
    ['a page of elsewhere', 403, '/topicdata', ['origin: http://evil.example', ...UPGRADE]],
    ['one that is no WebSocket', 400, '/topicdata', ['connection: Upgrade', 'upgrade: h2c']],
    ['a preflight too many', 503, '/preflight', UPGRADE],
  ] as const;

  it.each(refused)(
    'of %s (%i) end, though the other side sends on',
    async (_, status, path, lines) => {
      const master = await start();
      await times(EACH, async () => {
        const socket = await open(master.port, request(master, path, lines));
        await once(socket, 'data');
        socket.write('x');
      });
      const last = await open(master.port, request(master, path, lines));
      await expect.poll(() => last.heard()).toContain(`HTTP/1.1 ${status} `);
      await expectNone(master);
    },
  );

  it.each(refused)(
    'of %s (%i) end, though the other side never closes',
    async (_, _s, path, lines) => {
      const master = await start();
      await times(EACH, () => open(master.port, request(master, path, lines)));
      await expectNone(master);
    },
  );

  it('over TLS end, too', async () => {
    const master = await start('--lan', 'on');
    await times(10, async () => {
      const socket = connectTls({
        port: master.port,
        host: '127.0.0.1',
        rejectUnauthorized: false,
      });
      socket.on('error', () => undefined).on('data', () => undefined);
      onTestFinished(() => void socket.destroy());
      await once(socket, 'secureConnect');
      socket.write(request(master, '/topicdata', [STRANGER, ...UPGRADE]));
      socket.write('x');
    });
    await expectNone(master);
  });
});

const TIMEOUTS = ['--limits', 'headersTimeoutMs=300,slowSocketTimeoutMs=500'];

describe('connections that stop [AC-63]', () => {
  /** Behaviour of a connection that stops, with the bytes that it sends. */
  const stopped: readonly (readonly [string, (master: EdgeMaster) => string])[] = [
    ['says nothing', () => ''],
    ['sends one byte', () => 'G'],
    ['begins a handshake', () => '\u0016'],
    ['sends half a header', (master) => request(master, '/', []).slice(0, -2)],
    ['is idle after an answer', (master) => request(master, '/health', [])],
    [
      'begins a second header',
      (master) => request(master, '/health', []) + request(master, '/', []).slice(0, -2),
    ],
    [
      'sends a body that the master does not read',
      (master) => request(master, '/health', ['content-length: 1000000']),
    ],
  ];

  it.each(['on', 'off'])('are closed, with --lan %s, whatever they do', async (lan) => {
    const master = await start('--lan', lan, ...TIMEOUTS);
    const opened = await Promise.all(
      stopped.map(async ([what, text]) => ({
        what,
        sockets: await times(10, () => open(master.port, text(master))),
      })),
    );
    const stillOpen = () =>
      opened
        .filter(({ sockets }) => sockets.some((each) => !each.readableEnded && !each.destroyed))
        .map(({ what }) => what);
    await expect.poll(stillOpen, { timeout: 30_000 }).toEqual([]);
    await expectNone(master);
  });

  it('one that is half open is closed', async () => {
    const master = await start('--lan', 'on', ...TIMEOUTS);
    for (const [, text] of stopped) {
      const socket = await open(master.port, text(master));
      socket.end();
    }
    await expectNone(master);
  });

  it('one that takes nothing of a large file is closed, and so is the file', async () => {
    const frontendFolder = temporaryFolder();
    writeFileSync(join(frontendFolder, 'index.html'), '<p>');
    writeFileSync(join(frontendFolder, 'large.js'), Buffer.alloc(32 * 1024 * 1024, 'x'));
    const master = await startEdgeMaster({
      frontendFolder,
      flags: ['--limits', 'slowSocketTimeoutMs=500'],
    });
    for (let i = 0; i < 10; i++) {
      const socket = await open(master.port);
      socket.pause();
      socket.write(request(master, '/large.js', []));
    }
    await expectNone(master);
  });
});

describe('one connection', () => {
  it('has its requests answered one after another, in order [AC-64]', async () => {
    const frontendFolder = temporaryFolder();
    writeFileSync(join(frontendFolder, 'index.html'), '<p>');
    for (let i = 0; i < 8; i++) writeFileSync(join(frontendFolder, `${i}.js`), `file ${i}`);
    const master = await startEdgeMaster({ frontendFolder });
    const wanted = [3, 1, 7, 0, 5];
    const socket = await open(
      master.port,
      wanted.map((i) => request(master, `/${i}.js`, [])).join(''),
    );
    await expect
      .poll(() => socket.heard().match(/file \d/g))
      .toEqual(wanted.map((i) => `file ${i}`));
  });

  it('that asks for a thousand files at once has none open for long [AC-64]', async () => {
    const frontendFolder = temporaryFolder();
    writeFileSync(join(frontendFolder, 'index.html'), '<p>');
    writeFileSync(join(frontendFolder, 'large.js'), Buffer.alloc(4 * 1024 * 1024, 'x'));
    const master = await startEdgeMaster({ frontendFolder });
    const before = descriptors();
    const socket = connect(master.port, '127.0.0.1').on('error', () => undefined);
    onTestFinished(() => void socket.destroy());
    await once(socket, 'connect');
    socket.pause();
    socket.write(request(master, '/large.js', []).repeat(1_000));
    await expect.poll(() => connections(master)).toBe(1);
    expect(descriptors()).toBeLessThan(before + 10);
  });
});
