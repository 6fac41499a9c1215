import type { EncodedListener, EncodedRecord } from '@ubii/client-web';
import { compileGlob } from '@ubii/patterns';
import { encodeRecord, type RecordInit, type TopicRecord } from '@ubii/proto';
import { recordValueField } from '@ubii/proto/wire';
import type { LivePattern } from '../topic-source.ts';

interface Subscription {
  readonly pattern: LivePattern;
  readonly options: object;
  readonly onRecord: (record: TopicRecord) => void;
}

function selects(pattern: LivePattern, topic: string): boolean {
  if (typeof pattern === 'string') return pattern === topic;
  return 'glob' in pattern ? compileGlob(pattern.glob)(topic) : pattern.topic === topic;
}

/** Fake client on whose topics the test publishes. Retains the newest record of each, like a master. */
export function fakeTopics() {
  const retained = new Map<string, TopicRecord>();
  const open = new Set<Subscription>();

  function add(subscription: Subscription): () => void {
    open.add(subscription);
    const known = [...retained.values()];
    void Promise.resolve().then(() => {
      for (const record of known) {
        if (open.has(subscription) && selects(subscription.pattern, record.topic))
          subscription.onRecord(record);
      }
    });
    return () => void open.delete(subscription);
  }
  const encoded = (record: TopicRecord): EncodedRecord => {
    const bytes = encodeRecord(record as RecordInit);
    const { topic, clientId: publisherId } = record;
    return { topic, bytes, valueField: recordValueField(bytes), publisherId, isOwned: false };
  };
  return {
    client: {
      id: 'this-page',
      subscribe(pattern: LivePattern, options: object = {}) {
        let close = (): void => undefined;
        return {
          ready: Promise.resolve(),
          onRecord(onRecord: Subscription['onRecord']) {
            close = add({ pattern, options, onRecord });
            return this;
          },
          close: async () => close(),
        };
      },
      subscribeEncoded: (pattern: LivePattern, { onRecord }: EncodedListener) =>
        add({ pattern, options: { encoded: true }, onRecord: (one) => onRecord(encoded(one)) }),
    },
    /** Current subscriptions with their options. */
    subscriptions: () => [...open].map(({ pattern, options }) => ({ pattern, ...options })),
    publish(topic: string, value: number, timestampMs?: number) {
      const record: TopicRecord = { topic, format: 'double', value, timestampMs, clientId: '' };
      retained.set(topic, record);
      for (const { pattern, onRecord } of [...open]) {
        if (selects(pattern, topic)) onRecord(record);
      }
    },
  };
}
