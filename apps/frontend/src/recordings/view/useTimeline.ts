import {
  computed,
  provide,
  shallowRef,
  watch,
  type ComputedRef,
  type InjectionKey,
  type Ref,
} from 'vue';
import { injectOrThrow } from '../../context/inject-or-throw.ts';
import type { OpenedPlayer } from '../opened/opened-player.ts';
import type { PlacedGap, PlacedMarker } from '../reading/recording-messages.ts';
import type { UnreadActivity } from '../timeline/draw/draw-activity.ts';
import type { SurveyedTrack } from '../timeline/survey.ts';
import {
  lengthOf,
  panSpan,
  spanBetween,
  spanShowing,
  zoomSpan,
  type Span,
} from '../timeline/span.ts';
import { moduleWriters, parseSession } from '../timeline/module-writers.ts';
import { tracksOf, type Track } from '../timeline/track.ts';

/** A recording on the timeline: what of it is in view and what is selected. */
export interface Timeline {
  readonly opened: OpenedPlayer;
  readonly durationMs: ComputedRef<number>;
  /** What is in view. */
  readonly span: Readonly<Ref<Span>>;
  readonly tracks: ComputedRef<readonly Track[]>;
  /** Tracks that are shown. */
  readonly shown: ComputedRef<readonly Track[]>;
  readonly hidden: Ref<ReadonlySet<string>>;
  readonly selected: ComputedRef<Track | undefined>;
  readonly markers: Readonly<Ref<readonly PlacedMarker[]>>;
  readonly loop: ComputedRef<Span | undefined>;
  surveyed(topic: string): SurveyedTrack | undefined;
  /** Undefined when the records of a topic were read. */
  unread(topic: string): UnreadActivity | undefined;
  /** Where records of a topic are missing; undefined: of all topics. */
  gapsOf(topic: string | undefined): readonly PlacedGap[];
  select(topic: string): void;
  /** Selects a track, also one that is hidden. */
  reveal(topic: string): void;
  fit(): void;
  show(span: Span): void;
  zoom(factor: number, aroundMs: number): void;
  pan(byMs: number): void;
  /** Sets one edge of the loop at the playhead; the other stays, or is the end of the recording. */
  setLoopEdge(edge: 'from' | 'until'): void;
  setLoop(loop: Span | undefined): void;
}

export const TIMELINE: InjectionKey<Timeline> = Symbol('timeline');

export function useTimeline(): Timeline {
  return injectOrThrow(TIMELINE, 'an opened recording above it');
}

/** A loop is at least this long, milliseconds: shorter ones are clicks. */
export const MIN_LOOP_MS = 5;

export function provideTimeline(
  opened: OpenedPlayer,
  markers: Readonly<Ref<readonly PlacedMarker[]>>,
): Timeline {
  const durationMs = computed(() => Math.max(1, opened.recording.value?.durationMs ?? 1));
  const whole = (): Span => ({ fromMs: 0, untilMs: durationMs.value });
  const span = shallowRef<Span>(whole());
  const hidden = shallowRef<ReadonlySet<string>>(new Set());
  const chosen = shallowRef<string>();
  const writers = computed(() => moduleWriters(opened.sessions.value.flatMap(parseSession)));
  const tracks = computed(() => {
    const { topics = [], clientNames } = opened.recording.value ?? {};
    return tracksOf(topics, durationMs.value, clientNames, writers.value);
  });
  const shown = computed(() => tracks.value.filter(({ topic }) => !hidden.value.has(topic)));
  const selected = computed(
    () => shown.value.find(({ topic }) => topic === chosen.value) ?? firstToLookAt(shown.value),
  );
  const surveyed = computed(
    () => new Map((opened.survey.value?.tracks ?? []).map((track) => [track.topic, track])),
  );
  watch(durationMs, () => (span.value = whole()));
  // While it plays, the view goes on by pages with the playhead.
  watch(opened.timeMs, (timeMs, beforeMs) => {
    if (opened.player.value.status !== 'playing') return;
    const wasInView = beforeMs >= span.value.fromMs && beforeMs <= span.value.untilMs;
    if (wasInView) span.value = spanShowing(span.value, timeMs, durationMs.value);
  });

  const loop = computed(() => opened.player.value.loop);
  function setLoop(next: Span | undefined): void {
    const inside = next && {
      fromMs: Math.max(0, next.fromMs),
      untilMs: Math.min(durationMs.value, next.untilMs),
    };
    opened.setLoop(inside && lengthOf(inside) >= MIN_LOOP_MS ? inside : undefined);
  }
  const timeline: Timeline = {
    opened,
    durationMs,
    span,
    tracks,
    shown,
    hidden,
    selected,
    markers,
    loop,
    setLoop,
    surveyed: (topic) => surveyed.value.get(topic),
    unread(topic) {
      const counts = opened.activity.value?.topics.get(topic);
      const { isWhole = false, readMs = 0 } = opened.survey.value ?? {};
      return counts && !isWhole ? { counts, durationMs: durationMs.value, readMs } : undefined;
    },
    gapsOf: (topic) => (opened.recording.value?.gaps ?? []).filter((gap) => gap.topic === topic),
    select: (topic) => (chosen.value = topic),
    reveal(topic) {
      hidden.value = new Set([...hidden.value].filter((one) => one !== topic));
      chosen.value = topic;
    },
    fit: () => (span.value = whole()),
    show: (next) => (span.value = panSpan(next, 0, durationMs.value)),
    zoom(factor, aroundMs) {
      span.value = zoomSpan(span.value, factor, aroundMs, durationMs.value);
    },
    pan(byMs) {
      span.value = panSpan(span.value, byMs, durationMs.value);
    },
    setLoopEdge(edge) {
      const nowMs = opened.timeMs.value;
      const other =
        edge === 'from' ? (loop.value?.untilMs ?? durationMs.value) : (loop.value?.fromMs ?? 0);
      setLoop(spanBetween(nowMs, other));
    },
  };
  provide(TIMELINE, timeline);
  return timeline;
}

/** Numbers say most beside the graph. */
const firstToLookAt = (tracks: readonly Track[]): Track | undefined =>
  tracks.find(({ kind }) => kind === 'lines') ?? tracks[0];
