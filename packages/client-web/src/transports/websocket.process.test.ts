import type { AddressInfo } from 'node:net';
import { WebSocket, WebSocketServer } from 'ws';
import { describe, expect, it } from 'vitest';
import { describeTopicDataTransport } from '../testing/topic-data-transport-suite.ts';
import { createWebSocketTopicData } from './websocket.ts';

describeTopicDataTransport('WebSocket', async (events) => {
  const server = new WebSocketServer({ host: '127.0.0.1', port: 0 });
  await new Promise((resolve) => server.once('listening', resolve));
  server.on('connection', (socket, request) => {
    const query = new URL(request.url!, 'ws://localhost').searchParams;
    socket.on('error', () => undefined);
    socket.on('message', (data, isBinary) => {
      if (isBinary) events.handleBinary(data as Buffer);
      else events.handleText((data as Buffer).toString());
    });
    socket.on('close', () => events.handleClose());
    events.handleOpen({
      query: {
        clientId: query.get('clientID') ?? '',
        resumeToken: query.get('token') ?? undefined,
        ...(query.has('sent') && { sentMs: Number(query.get('sent')) }),
      },
      sendBinary: (bytes) => socket.send(bytes),
      sendText: (text) => socket.send(text),
      close: (code, reason) => socket.close(code, reason),
      cut: () => socket.terminate(),
    });
  });
  const { port } = server.address() as AddressInfo;
  return {
    transport: createWebSocketTopicData(
      `ws://127.0.0.1:${port}/topicdata`,
      (url) => new WebSocket(url),
    ),
    async close() {
      for (const socket of server.clients) socket.terminate();
      await new Promise((resolve) => server.close(resolve));
    },
  };
});

describe('createWebSocketTopicData()', () => {
  it.each([
    ['ws://m/topicdata', 'ws://m/topicdata?token=t%3D&sent=5&clientID=a'],
    ['ws://m/?room=1', 'ws://m/?room=1&token=t%3D&sent=5&clientID=a'],
  ])('adds to %s the token and the time, then the id [EX-4] [EX-51]', (url, expected) => {
    let opened = '';
    const transport = createWebSocketTopicData(url, (full) => {
      opened = full;
      throw new Error('not for real');
    });
    transport.open({ clientId: 'a', resumeToken: 't=', sentMs: 5 }, HANDLER);
    expect(opened).toBe(expected);
  });

  it('reports a socket that cannot even be made like every other failure', async () => {
    const transport = createWebSocketTopicData('ws://m', () => {
      throw new SyntaxError('no such scheme');
    });
    const close = await new Promise((resolve) => {
      const socket = transport.open(
        { clientId: 'a', resumeToken: undefined },
        { ...HANDLER, handleClose: (code, reason) => resolve([code, reason]) },
      );
      socket.sendText('x');
      socket.close();
    });
    expect(close).toEqual([1006, 'SyntaxError: no such scheme']);
  });
});

const HANDLER = {
  handleOpen: () => undefined,
  handleBinary: () => undefined,
  handleText: () => undefined,
  handleClose: () => undefined,
};
