import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { once } from 'node:events';
import { FakeClock } from '@ubii/timing/testing';
import { afterEach, describe, expect, it } from 'vitest';
import { WebSocket } from 'ws';

import { PreflightSockets } from './preflight-sockets.ts';

const open: (() => void)[] = [];
afterEach(() => open.splice(0).forEach((close) => close()));

async function world() {
  const clock = new FakeClock();
  const preflights = new PreflightSockets(clock);
  const server: Server = createServer().on('upgrade', (request, socket, head) => {
    if (!preflights.handleUpgrade(request, socket, head)) socket.destroy();
  });
  server.listen(0, '127.0.0.1');
  await once(server, 'listening');
  open.push(() => {
    preflights.terminate();
    server.close();
  });
  const { port } = server.address() as AddressInfo;
  const connect = (path = '/preflight') => {
    const socket = new WebSocket(`ws://127.0.0.1:${port}${path}`);
    socket.on('error', () => undefined);
    return socket;
  };
  return { clock, connect };
}

describe('PreflightSockets [AC-29]', () => {
  it('answers a question with the time of the master behind it', async () => {
    const { clock, connect } = await world();
    const socket = connect();
    await once(socket, 'open');
    socket.send('1');
    const [data] = (await once(socket, 'message')) as [Buffer];
    expect(data.toString()).toBe(`1 ${clock.preciseMs()}`);
  });

  it('closes when asked too often, or something long', async () => {
    const { connect } = await world();
    const often = connect();
    await once(often, 'open');
    for (let i = 0; i < 17; i += 1) often.send('?');
    const [reason] = (await once(often, 'close')) as [number];
    expect(reason).toBe(1008);
    const long = connect();
    await once(long, 'open');
    long.send('x'.repeat(33));
    const [code] = (await once(long, 'close')) as [number];
    expect(code).toBe(1009);
  });

  it('lives for ten seconds', async () => {
    const { clock, connect } = await world();
    const socket = connect();
    await once(socket, 'open');
    const closed = once(socket, 'close');
    clock.advanceSync(10_000);
    await closed;
  });

  it('refuses one address that opens too many', async () => {
    const { connect } = await world();
    const sockets = [];
    for (let i = 0; i < 8; i += 1) {
      const socket = connect();
      await once(socket, 'open');
      sockets.push(socket);
    }
    const refused = connect();
    const [, response] = (await once(refused, 'unexpected-response')) as [
      unknown,
      { statusCode: number },
    ];
    expect(response.statusCode).toBe(503);
  });

  it('leaves other paths to others', async () => {
    const { connect } = await world();
    const socket = connect('/preflight?clientID=x');
    await new Promise((resolve) => socket.on('close', resolve));
    expect(socket.readyState).toBe(WebSocket.CLOSED);
  });
});
