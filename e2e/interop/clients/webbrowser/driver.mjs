// Drives the published @tum-far/ubii-node-webbrowser, bundled for Node. See driver-loop.mjs.
// Environment: UBII_INTEROP_PACKAGES, the folder the package was installed and bundled in.

import { createRequire } from 'node:module';
import { join } from 'node:path';
import { emit, emitFrame, serve } from '../driver-loop.mjs';

const require = createRequire(join(process.env.UBII_INTEROP_PACKAGES, 'package.json'));
const { WebSocket } = require('ws');

// A browser's WebSocket throws when it is told to send while it connects; the one of ws does the same.
globalThis.WebSocket = class extends WebSocket {
  constructor(url) {
    super(url);
    this.addEventListener('open', () => emit('open'));
    this.addEventListener('close', ({ code, reason }) => emit('close', { code, reason }));
    this.addEventListener('message', ({ data }) =>
      emitFrame(data, (bytes) => translator.createPayloadFromBuffer(bytes)),
    );
  }
};

const { UbiiClientService, ProtobufTranslator, MSG_TYPES } = require('./bundle.cjs');
const translator = new ProtobufTranslator(MSG_TYPES.TOPIC_DATA);
const service = UbiiClientService.instance;

serve({
  async connect({ services, topicData, name }) {
    service.setName(name);
    await service.connect(services, topicData);
    await service.waitForConnection();
    const { client } = service;
    return {
      clientId: service.getClientID(),
      client: client.clientSpecification,
      server: client.serverSpecification,
    };
  },
  async callService({ request }) {
    return service.callService(request);
  },
  async registerDevice({ device }) {
    return service.registerDevice(device);
  },
  async subscribeTopic({ topic }) {
    await service.subscribeTopic(topic, (value, of) =>
      emit('record', { subscription: topic, topic: of, value }),
    );
  },
  async subscribeRegex({ regex }) {
    const subscribed = await service.subscribeRegex(regex, (value, of) =>
      emit('record', { subscription: regex, topic: of, value }),
    );
    if (!subscribed) throw new Error('refused');
  },
  publish({ records, immediately }) {
    if (immediately) records.forEach((record) => service.publishRecordImmediately(record));
    else service.publishRecordList(records);
  },
  async reconnect() {
    await service.reconnect();
    await service.waitForConnection();
  },
  async disconnect() {
    await service.disconnect();
  },
});
