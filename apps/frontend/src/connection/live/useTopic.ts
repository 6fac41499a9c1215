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

/** Rate at which pictures and overlays look continuous, Hz. */
export const VISIBLE_HZ = 30;

interface CommonOptions<R> {
  /** Number of records kept per topic, including the newest; 0 for callers that only use `onRecord`. @default 1 */
  readonly keep?: number;
  /** Whether to subscribe while the page is hidden, too. @default false */
  readonly whileHidden?: boolean;
  /** Called with each record on arrival, before it is shown. */
  readonly onRecord?: (record: R) => void;
}

/** Options for decoded records. */
export interface TopicOptions<F extends DataFormat> extends CommonOptions<TopicRecord<F>> {
  /** Only records of this data format. @default every format */
  readonly format?: F;
  /** Rate limit per topic, Hz, evaluated with each subscription. @default no limit */
  readonly maxRateHz?: MaybeRefOrGetter<number>;
}

/** Options for encoded records, for code that only forwards them. */
export interface EncodedTopicOptions extends CommonOptions<EncodedRecord> {
  readonly encoded: true;
}

/** Current records of live topics. Changes at most once per frame. */
export interface LiveRecords<R> {
  /** The record received last. */
  readonly newest: ComputedRef<R | undefined>;
  /** The last `keep` records of each topic, oldest first. */
  readonly records: ComputedRef<readonly R[]>;
  /** The newest record of each topic. */
  readonly byTopic: ComputedRef<ReadonlyMap<string, R>>;
  /** Numbers of received records, and of those that were replaced before they were shown. */
  readonly counts: ComputedRef<{ readonly received: number; readonly dropped: number }>;
  readonly status: Readonly<ShallowRef<LiveStatus>>;
}

/**
 * Subscribes to topics while the calling scope is active and the page is visible; all components use this function.
 * Retained records, and the first of a topic, are available in the next frame, independent of topic statistics.
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
