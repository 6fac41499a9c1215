import { Re2Patterns } from '@ubii/patterns/re2';
import { describeTopicPort } from '@ubii/pm-sandbox/testing';
import { ComponentIOType, decode, encode, encodeRecord } from '@ubii/proto';
import { recordValueField } from '@ubii/proto/wire';
import { FakeClock } from '@ubii/timing/testing';
import { expect } from 'vitest';
import { PlainTokens, RecordingLog, SequentialIds, testAccount } from '../../testing/index.ts';
import { TRUSTED_ACCESS } from '../access/caller.ts';
import { createClients } from '../areas/clients.ts';
import { createFoundation } from '../areas/foundation.ts';
import { createTopics } from '../areas/topics.ts';
import { LocalTopics } from './local-topics.ts';

/** The topics of a master, with one client. */
function setup() {
  const ids = new SequentialIds();
  const ports = {
    clock: new FakeClock(),
    ids,
    log: new RecordingLog(),
    tokens: new PlainTokens(),
    patterns: new Re2Patterns(),
  };
  const settings = { version: '1.2.3', endpoints: () => expect.fail('no part asks for endpoints') };
  const foundation = { ...ports, ...createFoundation(ports, settings) };
  const area = { ...foundation, ...createTopics(foundation) };
  const { clients, devices } = createClients(area);
  const message = encode('ubii.clients.Client', { extension: {} });
  const { client } = clients.register(decode('ubii.clients.Client', message), TRUSTED_ACCESS);
  const port = new LocalTopics({
    ...area,
    nodeId: 'master',
    account: testAccount(),
    deviceOf: (topic) => devices.deviceOfTopic(topic),
    isSession: () => true,
    onLimit: () => undefined,
  });
  return { clock: area.clock, topics: area.topics, devices, client, port, ids };
}

describeTopicPort("the master's topics", () => {
  const { clock, topics, devices, client, port, ids } = setup();
  return Promise.resolve({
    port,
    publisherId: client.id,
    put(record) {
      const bytes = encodeRecord(record);
      port.publishAs(client, record.topic, bytes, recordValueField(bytes), 'session');
    },
    settle() {
      clock.endTurnSync();
      return Promise.resolve();
    },
    seenByOthers: (topic) => topics.get(topic)?.record,
    delete(topic) {
      const entry = topics.get(topic);
      if (entry !== undefined) topics.deleteValue(entry);
    },
    addStick() {
      const device = decode(
        'ubii.devices.Device',
        encode('ubii.devices.Device', {
          name: 'pad',
          components: [
            {
              name: 'stick',
              topic: `/client/${ids.uuid()}/stick`,
              messageFormat: 'ubii.dataStructure.Vector2',
              ioType: ComponentIOType.PUBLISHER,
              tags: ['stick'],
            },
          ],
        }),
      );
      const { id, components } = devices.register(client, device).device;
      return Promise.resolve({ topic: components[0]!.topic, deviceId: id });
    },
    close: () => Promise.resolve(),
  });
});
