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

/** A topic that is there, with what is known of it. */
export interface LiveTopic {
  readonly topic: string;
  /** In any spelling; empty: not known. */
  readonly format: string;
  /** Id of the client that publishes it, if that is known. */
  readonly publisherId?: string;
  /** Id of the device whose component has it, if that is known. */
  readonly deviceId?: string;
}

/** One element the list of a muxer has now. */
export interface MuxMatch {
  readonly topic: string;
  /** Undefined: none, so that what it goes to cannot tell it apart. [PM-43] */
  readonly identity: string | undefined;
  /** False: another data format, which the muxer leaves out. [PM-42] */
  readonly fits: boolean;
}

/** What a muxer selects at the moment, or why it selects nothing. */
export type MuxPreview =
  | { readonly kind: 'matches'; readonly matches: readonly MuxMatch[] }
  | { readonly kind: 'fault'; readonly reason: string };

/**
 * What a muxer would gather of the topics that are there, by the rules of the nodes [PM-41] [PM-43].
 * @param patterns matches regular expressions; undefined: that is being loaded
 * @param topicsOf topics of the components that match a profile; without it profiles match nothing
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

/** For muxers that need none. */
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

/** Topics a demuxer would publish on for elements with these identities, or why it would not. [PM-45] */
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
