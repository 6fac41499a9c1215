/**
 * The limit the master is measured against: what a broker on `ws` costs when it does nothing but
 * pass bytes on. Not a product: no clients, no topics, no checks, no slow consumers.
 *
 * The role of a client comes from the URL: `/?publish=1&subscribe=1`. A publisher's record is put into
 * one frame and the frame is written raw to every subscriber, corked until the end of the turn.
 *
 * Plain JavaScript, so that it runs in the same plain Node as the built master.
 */
import { createServer } from 'node:http';
import { WebSocketServer } from 'ws';
import { binaryFrameOf } from './binary-frame.mjs';

const MAX_PAYLOAD_BYTES = 16 * 1024 * 1024;

/** @type {Set<import('node:net').Socket>} */
const subscribers = new Set();
/** A copy of `subscribers` to loop over: for-of over an array is cheaper than over a set. */
let sockets = [];
let isCorked = false;

function uncorkAll() {
  isCorked = false;
  for (const socket of sockets) socket.uncork();
}

function setSubscribers() {
  if (isCorked) uncorkAll();
  sockets = [...subscribers];
}

function broadcast(payload) {
  const frame = binaryFrameOf(payload);
  // Waiting for the end of the turn pays when there are several sockets; for one it only adds to the
  // round trip.
  if (!isCorked && sockets.length > 1) {
    isCorked = true;
    for (const socket of sockets) socket.cork();
    setImmediate(uncorkAll);
  }
  for (const socket of sockets) socket.write(frame);
}

const http = createServer();
const server = new WebSocketServer({
  server: http,
  perMessageDeflate: false,
  maxPayload: MAX_PAYLOAD_BYTES,
  skipUTF8Validation: true,
  clientTracking: false,
});

server.on('connection', (connection, request) => {
  const query = new URL(request.url ?? '/', 'http://localhost').searchParams;
  const socket = request.socket;
  socket.setNoDelay(true);
  connection.on('error', () => connection.terminate());
  if (query.has('publish')) connection.on('message', broadcast);
  if (query.has('subscribe')) {
    subscribers.add(socket);
    setSubscribers();
    connection.on('close', () => {
      subscribers.delete(socket);
      setSubscribers();
    });
  }
});

http.listen(0, '127.0.0.1', () => {
  const { port } = http.address();
  process.stdout.write(`${JSON.stringify({ url: `ws://127.0.0.1:${port}/` })}\n`);
});

process.on('SIGTERM', () => process.exit(0));
