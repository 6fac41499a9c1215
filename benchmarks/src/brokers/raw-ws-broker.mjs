/**
 * The limit the master is measured against: what a broker on `ws` costs when it does nothing but
 * pass bytes on. Not a product: no clients, no topics, no checks, no slow consumers.
 *
 * The role of a client comes from the URL: `/?publish=<room>&subscribe=<room>`. A publisher's record is put into
 * one frame and the frame is written raw to every subscriber of the room, corked until the end of the turn.
 *
 * Plain JavaScript, so that it runs in the same plain Node as the built master.
 */
import { createServer } from 'node:http';
import { WebSocketServer } from 'ws';
import { binaryFrameOf } from './binary-frame.mjs';

const MAX_PAYLOAD_BYTES = 16 * 1024 * 1024;

/** Subscribers that get the same records. */
class Room {
  /** @type {Set<import('node:net').Socket>} */
  #subscribers = new Set();
  /** A copy of it to loop over: for-of over an array is cheaper than over a set. */
  #sockets = [];
  #isCorked = false;

  add(socket) {
    this.#subscribers.add(socket);
    this.#setSockets();
  }

  delete(socket) {
    this.#subscribers.delete(socket);
    this.#setSockets();
  }

  broadcast(payload) {
    const frame = binaryFrameOf(payload);
    const sockets = this.#sockets;
    // Waiting for the end of the turn pays when there are several sockets; for one it only adds to the
    // round trip.
    if (!this.#isCorked && sockets.length > 1) {
      this.#isCorked = true;
      for (const socket of sockets) socket.cork();
      setImmediate(() => this.#uncorkAll());
    }
    for (const socket of sockets) socket.write(frame);
  }

  #uncorkAll() {
    this.#isCorked = false;
    for (const socket of this.#sockets) socket.uncork();
  }

  #setSockets() {
    if (this.#isCorked) this.#uncorkAll();
    this.#sockets = [...this.#subscribers];
  }
}

/** @type {Map<string, Room>} */
const rooms = new Map();

function roomOf(name) {
  let room = rooms.get(name);
  if (room === undefined) rooms.set(name, (room = new Room()));
  return room;
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
  if (query.has('publish')) {
    const room = roomOf(query.get('publish'));
    connection.on('message', (payload) => room.broadcast(payload));
  }
  if (query.has('subscribe')) {
    const room = roomOf(query.get('subscribe'));
    room.add(socket);
    connection.on('close', () => room.delete(socket));
  }
});

http.listen(0, '127.0.0.1', () => {
  const { port } = http.address();
  process.stdout.write(`${JSON.stringify({ url: `ws://127.0.0.1:${port}/` })}\n`);
});

process.on('SIGTERM', () => process.exit(0));
