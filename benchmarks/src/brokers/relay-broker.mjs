/**
 * The limit of a master that passes records of WebSocket clients on to clients of another one over NATS, with the client
 * library that the masters use. Not a product: no clients, no topics, no checks, no slow consumers.
 *
 * What its clients send goes to the subject of the other relay, what comes on its own subject to all its clients.
 *
 * Plain JavaScript, so that it runs in the same plain Node as the built master.
 */
import { createServer } from 'node:http';
import { connect } from '@nats-io/transport-node';
import { WebSocketServer } from 'ws';
import { binaryFrameOf } from './binary-frame.mjs';

const [, , servers, ownSubject, otherSubject] = process.argv;
const MAX_PAYLOAD_BYTES = 16 * 1024 * 1024;

/** @type {Set<import('node:net').Socket>} */
const sockets = new Set();
const nats = await connect({ servers, noEcho: true, noAsyncTraces: true });
nats.subscribe(ownSubject, {
  callback: (error, message) => {
    if (error !== null) throw error;
    const frame = binaryFrameOf(message.data);
    for (const socket of sockets) socket.write(frame);
  },
});
await nats.flush();

const http = createServer();
const server = new WebSocketServer({
  server: http,
  perMessageDeflate: false,
  maxPayload: MAX_PAYLOAD_BYTES,
  skipUTF8Validation: true,
  clientTracking: false,
});

server.on('connection', (connection, request) => {
  const { socket } = request;
  socket.setNoDelay(true);
  sockets.add(socket);
  connection.on('error', () => connection.terminate());
  connection.on('message', (payload) => nats.publish(otherSubject, payload));
  connection.on('close', () => sockets.delete(socket));
});

http.listen(0, '127.0.0.1', () => {
  const { port } = http.address();
  process.stdout.write(`${JSON.stringify({ url: `ws://127.0.0.1:${port}/` })}\n`);
});

process.on('SIGTERM', () => process.exit(0));
