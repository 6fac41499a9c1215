import type { EncodedRecord } from '@ubii/client-web';
import type { DataFormat, TopicRecord } from '@ubii/proto';
import { useDocumentVisibility } from '@vueuse/core';
import {
  computed,
  onScopeDispose,
  shallowRef,
  toValue,
  watch,
  type ComputedRef,
  type MaybeRefOrGetter,
  type ShallowRef,
} from 'vue';
import { useConnection } from '../useConnection.ts';
import type { LiveStatus } from './live-status.ts';
import { LiveTopics, type LiveTopicsPorts } from './live-topics.ts';
import type { RecordView, WindowRecord } from './record-window.ts';
import { subscribeEncoded, subscribeRecords } from './subscribe-records.ts';
import { patternsOf, type TopicSource } from './topic-source.ts';

/** The rate at which marks over pictures, and pictures, still look continuous, records per second. */
export const VISIBLE_HZ = 30;

interface CommonOptions<R> {
  /** Records kept of each topic, newest included; 0 for those who take each record in `onRecord` only. @default 1 */
  readonly keep?: number;
  /** Whether records come while the page is hidden, too. @default false */
  readonly whileHidden?: boolean;
  /** Called with each record as it comes, before it is drawn. */
  readonly onRecord?: (record: R) => void;
}

/** How records of topics are wanted. */
export interface TopicOptions<F extends DataFormat> extends CommonOptions<TopicRecord<F>> {
  /** Only records of this data format. @default every format */
  readonly format?: F;
  /** At most this many records of a topic per second, read with each subscription. @default no limit */
  readonly maxRateHz?: MaybeRefOrGetter<number>;
}

/** Option for encoded records: code that forwards them does not need them decoded. */
export interface EncodedTopicOptions extends CommonOptions<EncodedRecord> {
  readonly encoded: true;
}

/** What live topics show now. Changes at most once a frame. */
export interface LiveRecords<R> {
  /** The record that came last. */
  readonly newest: ComputedRef<R | undefined>;
  /** The last `keep` records of each topic, oldest first. */
  readonly records: ComputedRef<readonly R[]>;
  /** The newest record of each topic. */
  readonly byTopic: ComputedRef<ReadonlyMap<string, R>>;
  /** How many records came, and how many of these were replaced before they could be drawn. */
  readonly counts: ComputedRef<{ readonly received: number; readonly dropped: number }>;
  readonly status: Readonly<ShallowRef<LiveStatus>>;
}

/**
 * The one way of components to live data: subscribes while the calling scope lives and the page is visible. A record
 * that the master retains, and the first of a topic, show in the next frame, whether or not the page has counters of
 * the topic yet.
 */
export function useTopic(
  source: MaybeRefOrGetter<TopicSource>,
  options: EncodedTopicOptions,
): LiveRecords<EncodedRecord>;
export function useTopic<F extends DataFormat = DataFormat>(
  source: MaybeRefOrGetter<TopicSource>,
  options?: TopicOptions<F>,
): LiveRecords<TopicRecord<F>>;
export function useTopic<F extends DataFormat>(
  source: MaybeRefOrGetter<TopicSource>,
  options: TopicOptions<F> | EncodedTopicOptions = {},
): LiveRecords<EncodedRecord> | LiveRecords<TopicRecord<F>> {
  const { client } = useConnection();
  if ('encoded' in options) {
    return useLiveTopics<EncodedRecord>(source, options, (pattern, onRecord) =>
      subscribeEncoded(client, pattern, onRecord),
    );
  }
  return useLiveTopics<TopicRecord<F>>(source, options, (pattern, onRecord) => {
    const { format, maxRateHz: rate } = options;
    const maxRateHz = toValue(rate);
    return subscribeRecords(
      client,
      pattern,
      { ...(format && { format }), ...(maxRateHz && { maxRateHz }) },
      onRecord,
    );
  });
}

function useLiveTopics<R extends WindowRecord>(
  source: MaybeRefOrGetter<TopicSource>,
  { keep = 1, whileHidden = false, onRecord = () => undefined }: CommonOptions<R>,
  subscribe: LiveTopicsPorts<R>['subscribe'],
): LiveRecords<R> {
  const { isConnected } = useConnection();
  const status = shallowRef<LiveStatus>('off');
  const view = shallowRef<RecordView<R>>(NOTHING);
  const live = new LiveTopics<R>(keep, {
    subscribe,
    atFrame: (fn) => void requestAnimationFrame(fn),
    onRecord,
    show: (next) => (view.value = next),
    showStatus: (next) => (status.value = next),
  });
  const visibility = useDocumentVisibility();
  watch(
    () => whileHidden || visibility.value === 'visible',
    (isSeen) => live.setSeen(isSeen),
    { immediate: true },
  );
  const patterns = (): ReturnType<typeof patternsOf> => patternsOf(toValue(source));
  watch(
    () => JSON.stringify(patterns()),
    () => live.follow(patterns()),
    { immediate: true },
  );
  watch(isConnected, (connected) => connected && live.expectRepeats());
  onScopeDispose(() => live.close());
  return {
    newest: computed(() => view.value.newest),
    records: computed(() => view.value.records),
    byTopic: computed(() => view.value.byTopic),
    counts: computed(() => view.value),
    status,
  };
}

const NOTHING = {
  newest: undefined,
  records: [],
  byTopic: new Map<string, never>(),
  received: 0,
  dropped: 0,
};
