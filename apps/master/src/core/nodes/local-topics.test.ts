import { Re2Patterns } from '@ubii/patterns/re2';
import { describeTopicPort } from '@ubii/pm-sandbox/testing';
import { ComponentIOType, decode, encode, encodeRecord } from '@ubii/proto';
import { recordValueField } from '@ubii/proto/wire';
import { EndOfTurn, TokenBucket } from '@ubii/timing';
import { FakeClock } from '@ubii/timing/testing';
import { RecordingLog, SequentialIds, testAccount } from '../../testing/index.ts';
import { Client, specOf } from '../clients/client.ts';
import { DeviceRegistry } from '../devices/device-registry.ts';
import { InfoTopics } from '../info/info-topics.ts';
import { MasterPublisher } from '../info/master-publisher.ts';
import { DEFAULT_LIMITS } from '../limits/index.ts';
import { Accounts } from '../shares/accounts.ts';
import { Counters } from '../counters/counters.ts';
import { EventLog } from '../counters/event-log.ts';
import { LimitWatch } from '../counters/limit-watch.ts';
import { KeptValues } from '../topics/kept-values.ts';
import { PatternTable } from '../topics/pattern-table.ts';
import { SelectionTable } from '../topics/selection-table.ts';
import { subscriberFactory } from '../topics/subscriber-factory.ts';
import { SubscriptionTable } from '../topics/subscription-table.ts';
import { TopicTable } from '../topics/topic-table.ts';
import { TurnBatches } from '../topics/turn-batches.ts';
import { LocalTopics, tellOfGone } from './local-topics.ts';

/** The topics of a master, with one client. */
function setup() {
  const clock = new FakeClock();
  const ids = new SequentialIds();
  const limits = DEFAULT_LIMITS;
  const counters = new Counters();
  const limitWatch = new LimitWatch(
    limits,
    clock,
    new RecordingLog(),
    new EventLog(clock, new RecordingLog(), limits),
  );
  const patterns = new PatternTable({
    clock,
    compiler: new Re2Patterns(),
    onOverdrawn: () => undefined,
  });
  const selections = new SelectionTable();
  const accounts = new Accounts({ clock, limits: limitWatch, makeRoom: () => undefined });
  const topics = new TopicTable([patterns, selections], 0, 10, accounts.master, (entry) =>
    tellOfGone(publishing, entry),
  );
  const subscriptions: SubscriptionTable = new SubscriptionTable({
    topics,
    patterns,
    selections,
    limits: limitWatch,
    accounts,
    components: () => devices.components(),
  });
  const kept = new KeptValues({ clock, limits, topics, accounts });
  const publishing = { topics, subscriptions, limits, accounts, counters, kept };
  const devices: DeviceRegistry = new DeviceRegistry({
    ids,
    limits: limitWatch,
    topics,
    subscriptions,
    info: new InfoTopics(new MasterPublisher(publishing, clock), clock, limits),
    accounts,
  });
  const createSubscriber = subscriberFactory({
    ...publishing,
    clock,
    endOfTurn: new EndOfTurn(clock),
    batches: new TurnBatches(),
  });
  const account = testAccount();
  const client = new Client({
    id: 'client',
    spec: specOf(decode('ubii.clients.Client', new Uint8Array())),
    isExtension: true,
    account,
    subscriber: createSubscriber('client', true, account),
    recordBudget: new TokenBucket(1e6, 0),
    byteBudget: new TokenBucket(1e9, 0),
    nowMs: 0,
    epochMs: 0,
  });
  const port = new LocalTopics({
    ...publishing,
    clock,
    nodeId: 'master',
    account: testAccount(),
    deviceOf: (topic) => devices.deviceOfTopic(topic),
    isSession: () => true,
    onLimit: () => undefined,
  });
  return { clock, topics, devices, client, port, ids };
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
