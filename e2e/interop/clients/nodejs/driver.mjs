// Drives the published @tum-far/ubii-node-nodejs over HTTP (JSON) and WebSocket, or over ZeroMQ (`tcp://`).
// See driver-loop.mjs.
// Environment: UBII_INTEROP_PACKAGES, the folder the package was installed in.

import { once } from 'node:events';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { emit, emitFrame, serve } from '../driver-loop.mjs';

const require = createRequire(join(process.env.UBII_INTEROP_PACKAGES, 'package.json'));
const { UbiiClientNode } = require('@tum-far/ubii-node-nodejs');
const { DEFAULT_TOPICS } = require('@tum-far/ubii-msg-formats');

let node;
const tokens = new Map();

function emitRecord(subscription, record) {
  const format = record.type;
  emit('record', { subscription, topic: record.topic, format, value: record[format] });
}

async function subscribe(pattern, subscribing) {
  const token = await subscribing;
  if (!token?.topic) throw new Error(`refused: ${JSON.stringify(token)}`);
  tokens.set(pattern, token);
}

serve({
  async connect({ services, topicData, name }) {
    const isHttp = services.startsWith('http');
    const service = { address: services, ...(isHttp && { format: 'JSON' }) };
    node = new UbiiClientNode(name, service, { address: topicData });
    const connectTopicData = node.connectTopicdataSocket.bind(node);
    let opened;
    node.connectTopicdataSocket = () => {
      connectTopicData();
      const decode = (bytes) => node.translatorTopicData.createPayloadFromBuffer(bytes);
      const { websocket, socket } = node.topicDataClient;
      if (websocket === undefined) {
        socket.on('message', (_delimiter, content) =>
          emitFrame(content.toString() === 'PING' ? 'PING' : content, decode),
        );
        emit('open');
        return;
      }
      websocket.addEventListener('message', ({ data }) => emitFrame(data, decode));
      opened = once(websocket, 'open').then(() => emit('open'));
      websocket.addEventListener('close', ({ code, reason }) => emit('close', { code, reason }));
    };
    await node.initialize();
    // The node throws from a timer when it publishes before its socket is open.
    await opened;
    return {
      clientId: node.id,
      client: node.clientSpecification,
      server: node.serverSpecification,
    };
  },
  async callService({ request }) {
    return node.callService(request);
  },
  async registerDevice({ device }) {
    // The node has no call of its own for devices: applications call the service.
    const reply = await node.callService({
      topic: DEFAULT_TOPICS.SERVICES.DEVICE_REGISTRATION,
      device: { ...device, clientId: node.id },
    });
    if (reply.error) throw new Error(reply.error.message);
    return reply.device;
  },
  async subscribeTopic({ topic }) {
    await subscribe(
      topic,
      node.subscribeTopic(topic, (record) => emitRecord(topic, record)),
    );
  },
  async subscribeRegex({ regex }) {
    await subscribe(
      regex,
      node.subscribeRegex(regex, (record) => emitRecord(regex, record)),
    );
  },
  async unsubscribe({ pattern }) {
    await node.unsubscribe(tokens.get(pattern));
  },
  publish({ records, immediately }) {
    if (immediately) records.forEach((record) => node.publishRecordImmediately(record));
    else node.publishRecordList(records);
  },
  async disconnect() {
    // All the node knows of leaving is to stop publishing; its process ends and the socket with it.
    await node.deinitialize();
  },
});
