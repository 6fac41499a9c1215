import type { RecordsReader } from '@ubii/recording';
import {
  compareOutputs,
  type OutputDifference,
  type TopicComparison,
} from '@ubii/recording/compare';
import type { TopicRecord } from '@ubii/proto';
import { formatValue } from '../../topics/values/format-value.ts';
import { TimeBase } from '../reading/recording-time-base.ts';
import { differing } from './compare-words.ts';
import type {
  ComparedTopic,
  CompareRequest,
  ListedDifference,
  SessionComparison,
} from './compare-messages.ts';

/** Two outputs belong together up to this distance, milliseconds: a few ticks of the replay, and the time modules take. */
const TOLERANCE_MS = 100;
/** Numbers that differ by less are the same on another processor as well. */
const RELATIVE_TOLERANCE = 1e-6;
/** Differences of each topic and kind that are marked and that one can go to. Pictures are held in memory for that. */
const MAX_LISTED = { usual: 2000, images: 20 };
const IMAGES: ReadonlySet<string> = new Set(['image2D', 'image2DList']);

/** Compares the recorded outputs of a session with those of a run of today's modules. */
export async function compareSession(
  recorded: RecordsReader,
  rerun: RecordsReader,
  request: Omit<CompareRequest, 'recordedFile' | 'rerunFile'>,
  onProgress: (outputs: number) => void,
): Promise<SessionComparison> {
  const { inputPrefix, outputPrefix, span } = request;
  const base = new TimeBase(recorded.summary.startNs);
  const written = topicsBelow(rerun, outputPrefix);
  const formats = new Map(recorded.summary.topics.map(({ topic, format }) => [topic, format]));
  const outputs = request.outputs.filter((topic) => formats.has(topic));
  const isImage = (topic: string): boolean => IMAGES.has(formats.get(topic) ?? '');
  const results = await compareOutputs(recorded, rerun, {
    topics: [...new Set([...outputs, ...written])],
    mapTopic: (topic) => outputPrefix + topic,
    inputs: topicsBelow(rerun, inputPrefix),
    mapInput: (topic) => inputPrefix + topic,
    ...(span && { span: { fromNs: base.toNs(span.fromMs), untilNs: base.toNs(span.untilMs) } }),
    toleranceMs: TOLERANCE_MS,
    relativeTolerance: RELATIVE_TOLERANCE,
    onProgress,
    maxDifferences: (topic) => (isImage(topic) ? MAX_LISTED.images : MAX_LISTED.usual),
  });
  return {
    topics: results.map(countsOf).sort(byDifferences),
    differences: results
      .flatMap(({ topic, differences }) => differences.map((one) => listed(topic, one, base)))
      .sort((a, b) => a.timeMs - b.timeMs),
  };
}

/** Other values first: a run on a busy master has missing outputs in all topics. */
const byDifferences = (a: ComparedTopic, b: ComparedTopic): number =>
  b.different - a.different || differing(b) - differing(a);

/** Recorded topics that a run has below a prefix. */
function topicsBelow({ summary }: RecordsReader, prefix: string): string[] {
  const below = summary.topics.filter(({ topic }) => topic.startsWith(`${prefix}/`));
  return [...new Set(below.map(({ topic }) => topic.slice(prefix.length)))];
}

const countsOf = ({ differences, atEdges, ...counts }: TopicComparison): ComparedTopic => counts;

function listed(
  topic: string,
  { kind, path, timeNs, recorded, rerun }: OutputDifference,
  base: TimeBase,
): ListedDifference {
  return {
    kind,
    topic,
    path,
    timeMs: base.toMs(timeNs),
    recorded: textOf(recorded),
    today: textOf(rerun),
  };
}

const textOf = (record: TopicRecord | undefined): string | undefined =>
  record && formatValue(record.format, record.value as never);
