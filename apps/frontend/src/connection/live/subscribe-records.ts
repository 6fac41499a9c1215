import type { EncodedRecord, SubscribeOptions, UbiiClient } from '@ubii/client-web';
import type { DataFormat, TopicRecord } from '@ubii/proto';
import type { LiveSubscription } from './live-topics.ts';
import { patternRateHz, type LivePattern } from './topic-source.ts';

/** Subscribes to decoded records. The client reports a refusal; there are no records then. */
export function subscribeRecords<F extends DataFormat = DataFormat>(
  client: Pick<UbiiClient, 'subscribe'>,
  pattern: LivePattern,
  options: SubscribeOptions<F>,
  onRecord: (record: TopicRecord<F>) => void,
): LiveSubscription {
  const maxRateHz = patternRateHz(pattern) ?? options.maxRateHz;
  const subscription = client
    .subscribe(pattern, { ...options, ...(maxRateHz === undefined ? {} : { maxRateHz }) })
    .onRecord(onRecord);
  subscription.ready.catch(() => undefined);
  return { ready: subscription.ready, close: () => void subscription.close() };
}

/** Subscribes to encoded records. The client reports a refusal. */
export function subscribeEncoded(
  client: Pick<UbiiClient, 'subscribeEncoded'>,
  pattern: LivePattern,
  onRecord: (record: EncodedRecord) => void,
): LiveSubscription {
  const close = client.subscribeEncoded(pattern, { onRecord, onGone: () => undefined });
  return { ready: Promise.resolve(), close };
}
