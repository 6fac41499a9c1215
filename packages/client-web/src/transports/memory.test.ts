import { describeServiceTransport } from '../testing/service-transport-suite.ts';
import { describeTopicDataTransport } from '../testing/topic-data-transport-suite.ts';
import { createMemoryServices, createMemoryTopicData } from './memory.ts';

describeServiceTransport('memory', (answer) => {
  let isGone = false;
  return Promise.resolve({
    transport: createMemoryServices({
      handleServiceRequest: (request) =>
        isGone ? Promise.reject(new Error('the master is down')) : answer(request),
      openConnection: () => undefined,
    }),
    close() {
      isGone = true;
      return Promise.resolve();
    },
  });
});

describeTopicDataTransport('memory', (events) => {
  let isGone = false;
  return Promise.resolve({
    transport: createMemoryTopicData({
      handleServiceRequest: () => Promise.reject(new Error('not asked for')),
      openConnection(query, peer) {
        if (isGone) return undefined;
        events.handleOpen({
          query,
          sendBinary: (bytes) => peer.sendBinary(bytes),
          sendText: (text) => peer.sendText(text),
          close: (code, reason) => peer.close(code, reason),
          cut: () => peer.close(1006, ''),
        });
        return events;
      },
    }),
    close() {
      isGone = true;
      return Promise.resolve();
    },
  });
});
