import { decodeRecord, encodeRecord } from '@ubii/proto';
import { expect, it } from 'vitest';
import { FakeTopics } from './fake-topics.ts';
import { describeTopicPort } from './topic-port-suite.ts';

describeTopicPort('FakeTopics', () => {
  const topics = new FakeTopics('me');
  let sticks = 0;
  return Promise.resolve({
    port: topics,
    publisherId: 'publisher',
    put: ({ topic, format, value }) => topics.put(topic, format, value, 'publisher'),
    settle: () => Promise.resolve(),
    seenByOthers: (topic) => {
      const record = topics.published.findLast((published) => published.topic === topic);
      return record && encodeRecord(record);
    },
    delete: (topic) => topics.delete(topic),
    addStick: () => {
      const deviceId = `device-${++sticks}`;
      const component = { clientId: 'publisher', deviceId, deviceName: deviceId, name: 'stick' };
      const topic = topics.addComponent({ ...component, format: 'vector2', tags: ['stick'] });
      return Promise.resolve({ topic, deviceId });
    },
    close: () => Promise.resolve(),
  });
});

it('keeps what was published', () => {
  const topics = new FakeTopics();
  const bytes = encodeRecord({ topic: '/a', format: 'double', value: 1 });
  topics.publish('/a', bytes, 3);
  expect(topics.published).toEqual([decodeRecord(bytes)]);
});
