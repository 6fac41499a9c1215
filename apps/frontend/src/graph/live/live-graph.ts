import {
  type ModuleEvent,
  type ModuleStatistics,
  type Session,
  type TopicMux,
  type TopicRecord,
} from '@ubii/proto';
import { useDocumentVisibility, useRafFn } from '@vueuse/core';
import {
  computed,
  onScopeDispose,
  shallowReactive,
  shallowRef,
  watch,
  type Ref,
  type ShallowRef,
} from 'vue';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useSessionEvents } from '../../sessions/live/useSessionEvents.ts';
import { useSessionStatistics } from '../../sessions/live/useSessionStatistics.ts';
import { isAlive } from '../../sessions/state/session-state.ts';
import { RowValues } from '../../topics/rows/row-values.ts';
import { isStale } from '../../topics/rows/staleness.ts';
import { NO_SPARK, type SparkLine } from '../../topics/rows/sparkline.ts';
import { DrawPace } from './draw-pace.ts';
import type { Graph, Wire } from '../model/graph.ts';
import {
  muxPreview,
  type LiveTopic as KnownTopic,
  type MuxPreview,
} from '../model/live/mux-preview.ts';

/** How often counters are asked for, milliseconds. */
const STATISTICS_MS = 250;
/** How often pictures on topic nodes are renewed, Hz. */
const PICTURE_HZ = 2;
/** Run times kept for the chart of a module: a minute at five reports a second. */
const RUN_TIMES = 300;

/** What is shown of a topic on the canvas. */
export interface LiveTopic {
  /** Records per second; undefined while not known. */
  readonly hz: number | undefined;
  /** The newest value in one line. */
  readonly text: string | undefined;
  readonly record: TopicRecord | undefined;
  readonly spark: SparkLine;
  readonly ageMs: number | undefined;
  readonly isStale: boolean;
  readonly droppedPerSecond: number;
  readonly format: string;
  /** Id of who published it last. */
  readonly publisherId: string;
}

export interface RunTime {
  readonly timeMs: number;
  readonly p50Ms: number;
  readonly p95Ms: number;
}

/** What flows through a session, read by views; nothing is asked for while the page is hidden. */
export interface LiveGraph {
  /** Set while the canvas is moved: values are then drawn less often. */
  readonly isMoving: ShallowRef<boolean>;
  topic(topic: string): LiveTopic | undefined;
  /** What a muxer gathers now, or why it gathers nothing. */
  preview(mux: TopicMux): MuxPreview;
  module(id: string): ModuleStatistics | undefined;
  /** Whether a module is reported of at all. */
  has(id: string): boolean;
  /** Oldest first. */
  runTimes(id: string): readonly RunTime[];
  /** Oldest first. */
  readonly events: Readonly<Ref<readonly ModuleEvent[]>>;
}

export function useLiveGraph(
  session: Readonly<Ref<Session>>,
  graph: Readonly<Ref<Graph>>,
): LiveGraph {
  const { client, topics } = useConnection();
  topics.watch(STATISTICS_MS);
  const statistics = useSessionStatistics(session.value.id);
  const events = useSessionEvents(session.value.id);
  const shown = shallowReactive(new Map<string, LiveTopic>());
  const values = new RowValues((topic, maxRateHz, onRecord) => {
    const subscription = client.subscribe(topic, { maxRateHz }).onRecord(onRecord);
    // Refused by the master: the wire then shows no value.
    subscription.ready.catch(() => undefined);
    return () => void subscription.close();
  }, PICTURE_HZ);
  const wanted = computed(() => topicsOf(graph.value));
  const known = shallowRef<readonly KnownTopic[]>([]);

  const visibility = useDocumentVisibility();
  watch(
    [topics.rates, wanted, visibility],
    ([rates, names, seen]) => {
      if (rates === undefined) return;
      values.show(seen === 'hidden' ? [] : [...names].flatMap((name) => rates.get(name) ?? []));
      if (rates.size !== known.value.length) known.value = [...rates.values()].map(knownTopic);
    },
    { immediate: true },
  );
  topics.onChanges(({ added, removed }) => {
    if (added.length + removed.length > 0) known.value = [];
  });

  const isMoving = shallowRef(false);
  const samplePace = new DrawPace();
  const drawPace = new DrawPace();
  useRafFn(() => {
    const nowMs = performance.now();
    if (samplePace.take(nowMs, false)) values.sample(nowMs);
    if (!drawPace.take(nowMs, isMoving.value)) return;
    drawTopics();
    drawModules();
  });
  watch(wanted, (names) => {
    for (const topic of shown.keys()) if (!names.has(topic)) shown.delete(topic);
  });
  function drawTopics(): void {
    const rates = topics.rates.value;
    const nowMs = topics.masterTimeMs.value;
    for (const topic of wanted.value) {
      const rate = rates?.get(topic);
      if (rate === undefined) {
        shown.delete(topic);
        continue;
      }
      const value = values.get(topic);
      const { publishedMs, dataFormat, publisherId } = rate.statistic;
      const next: LiveTopic = {
        hz: rate.hz,
        text: value?.text,
        record: value?.record,
        spark: value?.spark ?? NO_SPARK,
        ageMs: publishedMs === 0 ? undefined : Math.max(0, nowMs - publishedMs),
        isStale: isStale(rate, false, nowMs),
        droppedPerSecond: rate.droppedPerSecond ?? 0,
        format: dataFormat,
        publisherId,
      };
      const old = shown.get(topic);
      if (old === undefined || hasChanged(old, next)) shown.set(topic, next);
    }
  }
  onScopeDispose(() => values.close());

  const modules = shallowReactive(new Map<string, ModuleStatistics>());
  const runTimes = shallowReactive(new Map<string, readonly RunTime[]>());
  /** What was reported of each module and is not drawn yet. */
  const reported = new Map<string, Report>();
  watch(
    () => (isAlive(session.value) ? statistics.value.get(session.value.id)?.modules : undefined),
    (all = []) => {
      const ids = new Set(all.map(({ moduleId }) => moduleId));
      for (const id of [...modules.keys()]) if (!ids.has(id)) modules.delete(id);
      for (const id of [...reported.keys()]) if (!ids.has(id)) reported.delete(id);
      for (const newest of all) {
        const { moduleId: id, runP50Ms: p50Ms, runP95Ms: p95Ms, runsPerSecond } = newest;
        const times = reported.get(id)?.times ?? [];
        if (runsPerSecond > 0) times.push({ timeMs: Date.now(), p50Ms, p95Ms });
        reported.set(id, { newest, times });
      }
    },
  );
  function drawModules(): void {
    for (const [id, { newest, times }] of reported) {
      modules.set(id, newest);
      if (times.length > 0)
        runTimes.set(id, [...(runTimes.get(id) ?? []), ...times].slice(-RUN_TIMES));
    }
    reported.clear();
  }

  return {
    isMoving,
    topic: (topic) => shown.get(topic),
    preview: (mux) => muxPreview(mux, known.value),
    module: (id) => modules.get(id),
    has: (id) => modules.has(id),
    runTimes: (id) => runTimes.get(id) ?? [],
    events,
  };
}

interface Report {
  readonly newest: ModuleStatistics;
  readonly times: RunTime[];
}

const rateText = ({ hz }: LiveTopic): string | undefined => hz?.toFixed(1);

function hasChanged(a: LiveTopic, b: LiveTopic): boolean {
  return (
    a.publisherId !== b.publisherId ||
    a.format !== b.format ||
    rateText(a) !== rateText(b) ||
    a.text !== b.text ||
    a.spark !== b.spark ||
    a.isStale !== b.isStale ||
    a.droppedPerSecond !== b.droppedPerSecond ||
    (b.isStale && a.ageMs !== b.ageMs)
  );
}

const knownTopic = ({ statistic }: TopicRate): KnownTopic => ({
  topic: statistic.topic,
  format: statistic.dataFormat,
  publisherId: statistic.publisherId,
});

/** The topic whose values flow through a wire; undefined for constants and many topics. */
export function topicOfWire({ nodes }: Graph, { from, to, via }: Wire): string | undefined {
  if (via !== undefined) return via;
  const source = nodes.get(from.node);
  if (source?.kind === 'topic') return source.topic;
  const target = nodes.get(to.node);
  return target?.kind === 'topic' ? target.topic : undefined;
}

/** Every topic that shows on the canvas. */
export function topicsOf(graph: Graph): ReadonlySet<string> {
  const names = new Set<string>();
  for (const node of graph.nodes.values()) if (node.kind === 'topic') names.add(node.topic);
  for (const { via } of graph.wires.values()) if (via !== undefined) names.add(via);
  return names;
}
