import { muxNeedsPatterns } from '@ubii/pm-sandbox';
import { type ModuleEvent, type ModuleStatistics, type Session, type TopicMux } from '@ubii/proto';
import { computed, shallowReactive, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useSessionEvents } from '../../sessions/live/useSessionEvents.ts';
import { useSessionStatistics } from '../../sessions/live/useSessionStatistics.ts';
import { isWatched } from '../../sessions/state/session-state.ts';
import { usePatterns } from '../../patterns/usePatterns.ts';
import { usePageFrames } from '../../topics/history/page-clock.ts';
import { useRowValues } from '../../topics/rows/useRowValues.ts';
import { isPublisherAway } from '../../topics/names/publisher.ts';
import { useFindPublisher } from '../../topics/names/useFindPublisher.ts';
import type { Graph } from '../model/graph.ts';
import {
  muxPreview,
  type LiveTopic as KnownTopic,
  type MuxPreview,
} from '../model/live/mux-preview.ts';
import { DrawSlices } from './draw-slices.ts';
import { drawUnits, type DrawUnit } from './draw-units.ts';
import { createFrameTimer } from './frame-timer.ts';
import { hasChanged, liveTopic, type LiveTopic } from './live-topic.ts';
import { Overruns } from './overruns.ts';
import { topicsOf } from './topics-in-graph.ts';

/** Interval of requests for statistics, milliseconds. */
const STATISTICS_MS = 250;
/** Rate at which pictures on topic nodes are renewed, Hz. */
const PICTURE_HZ = 2;
/** Run times kept for a module's chart: one minute at five reports a second. */
const RUN_TIMES = 300;

export interface RunTime {
  readonly timeMs: number;
  readonly p50Ms: number;
  readonly p95Ms: number;
}

/** Live values and statistics of a session for the views; requests nothing while the page is hidden. */
export interface LiveGraph {
  /** Set while the canvas moves: values are then drawn less often. */
  readonly isMoving: ShallowRef<boolean>;
  /** Set while the values on the canvas are paused; the session goes on. */
  readonly isPaused: ShallowRef<boolean>;
  /** Returns whether a node is visible; values of others are drawn less often. */
  readonly isInView: ShallowRef<(node: string) => boolean>;
  topic(topic: string): LiveTopic | undefined;
  /** Name of who publishes a topic, where that is not one of the clients of now. */
  ownerOf?(topic: string): string | undefined;
  /** Topics that a muxer matches now, or the reason why it matches none. */
  preview(mux: TopicMux): MuxPreview;
  module(id: string): ModuleStatistics | undefined;
  /** Whether the module is slower than its frequency, so that runs are left out. */
  isLate(id: string): boolean;
  /** Whether the module has statistics. */
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
  const { topics } = useConnection();
  const findPublisher = useFindPublisher();
  const patterns = usePatterns();
  topics.watch(STATISTICS_MS);
  const statistics = useSessionStatistics(session.value.id);
  const events = useSessionEvents(session.value.id);
  const shown = shallowReactive(new Map<string, LiveTopic>());
  const values = useRowValues(PICTURE_HZ);
  const wanted = computed(() => topicsOf(graph.value));
  const known = shallowRef<readonly KnownTopic[]>([]);

  watch(
    [topics.rates, wanted],
    ([rates, names]) => {
      values.showNamed(names, (name) => rates?.get(name));
      if (rates !== undefined && rates.size !== known.value.length)
        known.value = [...rates.values()].map(knownTopic);
    },
    { immediate: true },
  );
  topics.onChanges(({ added, removed }) => {
    if (added.length + removed.length > 0) known.value = [];
  });

  const isMoving = shallowRef(false);
  const isPaused = shallowRef(false);
  const isInView = shallowRef<(node: string) => boolean>(() => true);
  const units = computed(() => drawUnits(graph.value));
  const slices = new DrawSlices(
    () => units.value,
    ({ shownAt }: DrawUnit) => shownAt.some((node) => isInView.value(node)),
  );
  const timeFrame = createFrameTimer((frameMs) => slices.took(frameMs));
  usePageFrames(({ isReading, readMs }) => {
    if (isReading) values.sample(readMs);
    if (isPaused.value) return;
    const slice = slices.next(performance.now(), isMoving.value);
    if (slice.length === 0) return;
    timeFrame();
    for (const { topics: names, module } of slice) {
      for (const name of names) drawTopic(name);
      if (module !== undefined) drawModule(module);
    }
  });
  watch(wanted, (names) => {
    for (const topic of shown.keys()) if (!names.has(topic)) shown.delete(topic);
  });
  function drawTopic(topic: string): void {
    const rate = topics.rates.value?.get(topic);
    const value = values.get(topic);
    // A subscription of this page is enough for a topic to have statistics.
    const isPublished = rate !== undefined && rate.statistic.publishedMs > 0;
    if (!isPublished && value?.record === undefined) {
      shown.delete(topic);
      return;
    }
    const isAway = isPublisherAway(topic, rate?.statistic.publisherId ?? '', findPublisher);
    const next = liveTopic(rate, value, isAway, topics.masterTimeMs.value);
    const old = shown.get(topic);
    if (old === undefined || hasChanged(old, next)) shown.set(topic, next);
  }

  const modules = shallowReactive(new Map<string, ModuleStatistics>());
  const runTimes = shallowReactive(new Map<string, readonly RunTime[]>());
  const overruns = new Overruns();
  const late = shallowReactive(new Set<string>());
  /** Newest report of each module that is not drawn yet. */
  const reported = new Map<string, Report>();
  watch(
    () => (isWatched(session.value) ? statistics.value.get(session.value.id)?.modules : undefined),
    (all = []) => {
      const ids = new Set(all.map(({ moduleId }) => moduleId));
      for (const id of [...modules.keys()]) {
        if (ids.has(id)) continue;
        modules.delete(id);
        late.delete(id);
        overruns.forget(id);
      }
      for (const id of [...reported.keys()]) if (!ids.has(id)) reported.delete(id);
      for (const newest of all) {
        const { moduleId: id, runP50Ms: p50Ms, runP95Ms: p95Ms, runsPerSecond } = newest;
        const times = reported.get(id)?.times ?? [];
        if (!overruns.report(newest, Date.now())) late.delete(id);
        else if (!late.has(id)) late.add(id);
        if (runsPerSecond > 0) times.push({ timeMs: Date.now(), p50Ms, p95Ms });
        reported.set(id, { newest, times });
      }
    },
  );
  function drawModule(id: string): void {
    const report = reported.get(id);
    if (report === undefined) return;
    const { newest, times } = report;
    reported.delete(id);
    modules.set(id, newest);
    if (times.length > 0)
      runTimes.set(id, [...(runTimes.get(id) ?? []), ...times].slice(-RUN_TIMES));
  }

  return {
    isMoving,
    isPaused,
    isInView,
    topic: (topic) => shown.get(topic),
    preview: (mux) =>
      muxPreview(mux, known.value, muxNeedsPatterns(mux) ? patterns.compiler : undefined),
    module: (id) => modules.get(id),
    isLate: (id) => late.has(id),
    has: (id) => modules.has(id),
    runTimes: (id) => runTimes.get(id) ?? [],
    events,
  };
}

interface Report {
  readonly newest: ModuleStatistics;
  readonly times: RunTime[];
}

const knownTopic = ({ statistic }: TopicRate): KnownTopic => ({
  topic: statistic.topic,
  format: statistic.dataFormat,
  publisherId: statistic.publisherId,
});
