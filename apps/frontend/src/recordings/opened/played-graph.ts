import { muxNeedsPatterns } from '@ubii/pm-sandbox';
import { computed, shallowRef } from 'vue';
import type { LiveGraph } from '../../graph/live/live-graph.ts';
import type { LiveTopic } from '../../graph/live/live-topic.ts';
import type { OwnPad } from '../../graph/live/own-pad.ts';
import { muxPreview } from '../../graph/model/live/mux-preview.ts';
import type { Patterns } from '../../patterns/usePatterns.ts';
import { NO_SPARK, type SparkLine } from '../../topics/rows/sparkline.ts';
import type { SurveyedTrack } from '../timeline/survey.ts';
import type { Track } from '../timeline/track.ts';
import type { PlayedValues } from './played-values.ts';

/** What a graph shows of a recording. */
export interface PlayedSources {
  readonly values: PlayedValues;
  tracks(): readonly Track[];
  surveyed(topic: string): SurveyedTrack | undefined;
}

/** A line over the last seconds before the playhead. */
const SPARK = { ms: 5000, samples: 40 };

/** The values of a recording at its playhead, as a graph shows values. */
export function playedGraph(sources: PlayedSources, patterns: Patterns): LiveGraph {
  const tracks = computed(() => new Map(sources.tracks().map((track) => [track.topic, track])));
  const known = computed(() =>
    sources.tracks().map(({ topic, formatText }) => ({ topic, format: formatText })),
  );
  function topic(name: string): LiveTopic | undefined {
    const track = tracks.value.get(name);
    const played = sources.values.get(name);
    if (track === undefined || played === undefined) return undefined;
    return {
      hz: track.hz,
      text: played.text,
      record: played.record,
      spark: sparkBefore(sources.surveyed(name), played.timeMs),
      ageMs: 0,
      isStale: false,
      droppedPerSecond: 0,
      format: track.formatText,
      publisherId: '',
    };
  }
  return {
    isMoving: shallowRef(false),
    isPaused: shallowRef(false),
    isInView: shallowRef(() => true),
    topic,
    ownerOf: (name) => tracks.value.get(name)?.owner,
    preview: (mux) =>
      muxPreview(mux, known.value, muxNeedsPatterns(mux) ? patterns.compiler : undefined),
    module: () => undefined,
    isLate: () => false,
    has: () => false,
    runTimes: () => [],
    events: shallowRef([]),
  };
}

/** There is no finger on a recording. */
export const NO_PAD: OwnPad = {
  isOffered: computed(() => false),
  isOpen: shallowRef(false),
  isResting: () => false,
};

/** @returns none where the survey is too coarse to show seconds */
export function sparkBefore(surveyed: SurveyedTrack | undefined, timeMs: number): SparkLine {
  const line = surveyed?.tile.lines[0];
  if (surveyed === undefined || line === undefined) return NO_SPARK;
  const { bucketMs } = surveyed.tile.grid;
  const stepMs = SPARK.ms / SPARK.samples;
  if (bucketMs > stepMs) return NO_SPARK;
  const values = Array.from({ length: SPARK.samples }, (_, index) => {
    const at = timeMs - (SPARK.samples - 1 - index) * stepMs;
    const value = line.high[Math.floor(at / bucketMs)];
    return value === undefined || Number.isNaN(value) ? undefined : value;
  });
  const numbers = values.filter((value) => value !== undefined);
  if (numbers.length < 2) return NO_SPARK;
  return { values, min: Math.min(...numbers), max: Math.max(...numbers) };
}
