import { createServer, get as getPlain } from 'node:http';
import type { IncomingMessage, Server } from 'node:http';
import { get as getSecure } from 'node:https';
import { connect } from 'node:net';
import type { AddressInfo } from 'node:net';

import { temporaryFolder } from '@ubii/program/testing';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { WebSocket, WebSocketServer } from 'ws';

import { Certificates } from './certificates.ts';
import { OnePort } from './one-port.ts';

const silent = { error() {}, warn() {}, info() {}, debug() {}, child: () => silent };

let dataDir: string;
let server: Server;
let onePort: OnePort;
let certificates: Certificates;
let names: string[];
let port: number;

beforeEach(async () => {
  dataDir = temporaryFolder();
  names = ['localhost', '127.0.0.1'];
  certificates = await Certificates.open({
    dataDir,
    own: undefined,
    names: () => names,
    masterName: 'test',
    nowMs: Date.now,
    log: silent,
  });
  server = createServer((request, response) => {
    let body = '';
    request.on('data', (chunk) => (body += String(chunk)));
    request.on('end', () => {
      const isSecure = 'encrypted' in request.socket;
      response.end(`${isSecure ? 'secure' : 'plain'} ${request.method} ${request.url} ${body}`);
    });
  });
  const sockets = new WebSocketServer({ server });
  sockets.on('connection', (socket) => socket.on('message', (data) => socket.send(data)));
  onePort = new OnePort(certificates.served);
  onePort.attach(server);
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  port = (server.address() as AddressInfo).port;
});

afterEach(async () => {
  const closed = new Promise((resolve) => server.close(resolve));
  onePort.cut();
  server.closeAllConnections();
  await closed;
});

function textOf(
  ask: (handle: (response: IncomingMessage) => void) => {
    on(event: 'error', fn: (e: Error) => void): unknown;
  },
): Promise<string> {
  return new Promise((resolve, reject) => {
    ask((response) => {
      let text = '';
      response.on('data', (chunk) => (text += String(chunk)));
      response.on('end', () => resolve(text));
    }).on('error', reject);
  });
}

const plain = (path: string): Promise<string> =>
  textOf((handle) => getPlain(`http://127.0.0.1:${port}${path}`, { agent: false }, handle));
const secure = (path: string, ca = certificates.authority): Promise<string> =>
  textOf((handle) =>
    getSecure(`https://127.0.0.1:${port}${path}`, { agent: false, ...(ca && { ca }) }, handle),
  );

function echo(url: string): Promise<string> {
  return new Promise((resolve, reject) => {
    const socket = new WebSocket(url, certificates.authority ? { ca: certificates.authority } : {});
    socket.on('open', () => socket.send('hello'));
    socket.on('message', (data) => {
      socket.close();
      resolve(String(data));
    });
    socket.on('error', reject);
  });
}

describe('one port', () => {
  it('answers HTTP and HTTPS, side by side', async () => {
    const answers = await Promise.all([plain('/a'), secure('/b'), plain('/c'), secure('/d')]);
    expect(answers.map((text) => text.trim())).toEqual([
      'plain GET /a',
      'secure GET /b',
      'plain GET /c',
      'secure GET /d',
    ]);
  });

  it('takes sockets of both kinds', async () => {
    expect(await echo(`ws://127.0.0.1:${port}/`)).toBe('hello');
    expect(await echo(`wss://127.0.0.1:${port}/`)).toBe('hello');
  });

  it('keeps a connection open for several requests, and bodies that come in pieces', async () => {
    const socket = connect(port, '127.0.0.1');
    let received = '';
    socket.on('data', (data) => (received += String(data)));
    const until = (text: string): Promise<void> =>
      new Promise((resolve) => {
        const look = (): void => {
          if (!received.includes(text)) return;
          socket.off('data', look);
          resolve();
        };
        socket.on('data', look);
      });
    socket.write('P');
    socket.write('OST /one HTTP/1.1\r\nhost: x\r\ncontent-length: 6\r\n\r\nabc');
    const first = until('plain POST /one abcdef');
    socket.write('def');
    await first;
    const second = until('plain GET /two');
    socket.write('GET /two HTTP/1.1\r\nhost: x\r\n\r\n');
    await second;
    socket.destroy();
  });

  it('uses a certificate that clients trust only after its authority was installed', async () => {
    await expect(secure('/', '')).rejects.toThrow(/self-signed|unable to/);
    expect(await plain('/after')).toContain('/after');
  });

  it('shows a new certificate from the next connection on', async () => {
    names = [...names, '127.0.0.2'];
    await certificates.renewIfNeeded();
    onePort.show(certificates.served);
    const seen = await new Promise<string>((resolve, reject) => {
      getSecure(
        `https://127.0.0.1:${port}/`,
        { agent: false, ...(certificates.authority && { ca: certificates.authority }) },
        (response) => {
          const { getPeerCertificate } = response.socket as never as {
            getPeerCertificate(): { subjectaltname: string };
          };
          resolve(getPeerCertificate.call(response.socket).subjectaltname);
          response.resume();
        },
      ).on('error', reject);
    });
    expect(seen).toContain('127.0.0.2');
  });

  it('is not disturbed by clients that disconnect or send invalid data', async () => {
    for (const text of ['', '\x16', '\x16\x03\x01\x00\x05hello', '\x00\x00', 'GET']) {
      await new Promise<void>((resolve) => {
        const socket = connect(port, '127.0.0.1', () => socket.end(Buffer.from(text, 'latin1')));
        socket.on('error', () => {});
        socket.on('close', () => resolve());
        socket.resume();
      });
    }
    expect(await plain('/still')).toContain('/still');
    expect(await secure('/here')).toContain('/here');
  });

  it('cuts the silent', async () => {
    const socket = connect(port, '127.0.0.1');
    const closed = new Promise((resolve) => socket.on('close', resolve));
    socket.on('error', () => {});
    await plain('/so that the first has arrived'.replaceAll(' ', '-'));
    onePort.cut();
    await closed;
  });
});
