import { compileGlob, type PatternCompiler } from '@ubii/patterns';
import {
  demuxTopic,
  formatsFit,
  hasPlaceholder,
  identityOf,
  identityRule,
  muxNeedsPatterns,
  muxSelector,
  parseDemuxFormat,
} from '@ubii/pm-sandbox';
import { parseDataFormat, type Component, type TopicDemux, type TopicMux } from '@ubii/proto';

/** An existing topic. */
export interface LiveTopic {
  readonly topic: string;
  /** Data format in any spelling; empty: unknown. */
  readonly format: string;
  /** Id of the client that publishes it, if known. */
  readonly publisherId?: string;
  /** Id of the device that has its component, if known. */
  readonly deviceId?: string;
}

/** One element of a muxer's list. */
export interface MuxMatch {
  readonly topic: string;
  /** Undefined: none, so that the receiving module cannot identify the element. [PM-43] */
  readonly identity: string | undefined;
  /** False for another data format, which the muxer ignores. [PM-42] */
  readonly fits: boolean;
}

/** Topics that a muxer matches now, or the reason why it matches none. */
export type MuxPreview =
  | { readonly kind: 'matches'; readonly matches: readonly MuxMatch[] }
  | { readonly kind: 'fault'; readonly reason: string };

/**
 * Returns the existing topics that a muxer would match, by the rules of the nodes [PM-41] [PM-43].
 * @param patterns matches regular expressions; undefined while it is loading
 * @param topicsOf returns the topics of components that match a profile; default: profiles match nothing
 */
export function muxPreview(
  mux: TopicMux,
  topics: readonly LiveTopic[],
  patterns: PatternCompiler | undefined,
  topicsOf: (profile: Component) => ReadonlySet<string> = () => new Set(),
): MuxPreview {
  const selector = muxSelector(mux);
  if (selector === undefined) {
    return { kind: 'fault', reason: 'Enter a pattern to select topics.' };
  }
  if (patterns === undefined && muxNeedsPatterns(mux)) {
    return { kind: 'fault', reason: 'Searching for topics.' };
  }
  const compiler = patterns ?? NO_PATTERNS;
  try {
    const selects = selectionOf(selector, compiler, topicsOf);
    const rule = identityRule(mux, compiler);
    const format = parseDataFormat(mux.dataType);
    const matches = topics.filter(({ topic }) => selects(topic));
    return {
      kind: 'matches',
      matches: matches.map(({ topic, format: given, publisherId = '', deviceId = '' }) => ({
        topic,
        identity: identityOf(rule, {
          topic,
          bytes: NO_BYTES,
          valueField: 0,
          publisherId,
          deviceId,
        }),
        fits: formatsFit(parseDataFormat(given), format),
      })),
    };
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    return { kind: 'fault', reason: `The pattern cannot be used: ${reason}` };
  }
}

const NO_BYTES = new Uint8Array(0);

/** For muxers without regular expressions. */
const NO_PATTERNS: PatternCompiler = {
  compile(source) {
    throw new Error(`"${source}" was not expected`);
  },
};

function selectionOf(
  selector: NonNullable<ReturnType<typeof muxSelector>>,
  patterns: PatternCompiler,
  topicsOf: (profile: Component) => ReadonlySet<string>,
): (topic: string) => boolean {
  if (selector.kind === 'component') {
    const topics = topicsOf(selector.profile);
    return (topic) => topics.has(topic);
  }
  if (selector.kind === 'topic') return (topic) => topic === selector.topic;
  if (selector.kind === 'glob') return compileGlob(selector.glob);
  return patterns.compile(selector.source).test;
}

/**
 * Topics that a demuxer would publish on for elements with these identities, or the reason why it would not. [PM-45]
 */
export type DemuxPreview =
  | { readonly kind: 'topics'; readonly topics: readonly string[] }
  | { readonly kind: 'fault'; readonly reason: string };

export function demuxPreview(
  { outputTopicFormat }: Pick<TopicDemux, 'outputTopicFormat'>,
  identities: readonly string[],
): DemuxPreview {
  const format = parseDemuxFormat(outputTopicFormat);
  if (!hasPlaceholder(format)) {
    const reason =
      'All elements have the same topic. Add {{#0}} or {{identity}} to the topic format.';
    return { kind: 'fault', reason };
  }
  const topics: string[] = [];
  for (const identity of identities) {
    const result = demuxTopic(format, [identity], identity);
    if ('topic' in result) topics.push(result.topic);
    else return { kind: 'fault', reason: `An element cannot be published: ${result.lacks}.` };
  }
  return { kind: 'topics', topics };
}
