import { compileGlob, type PatternCompiler } from '@ubii/patterns';
import {
  decode,
  encode,
  MuxIdentity,
  type IOMapping,
  type ProcessingModule,
  type Session,
  type TopicMux,
} from '@ubii/proto';
import { topicsOfProfile, type RecordedDevice } from '@ubii/recording';
import type { SelectedTopics } from './rerun-inputs.ts';

/**
 * Returns a regular expression that finds in a topic below a prefix what the given one finds in the topic itself, with the same
 * capture groups.
 *
 * @param prefix letters, digits, `-` and `/`, which mean themselves in an expression
 */
function prefixedPattern(source: string, prefix: string): string {
  return alternativesOf(source)
    .map((part) =>
      part.startsWith('^') ? `^${prefix}${part.slice(1)}` : `^${prefix}.*?(?:${part})`,
    )
    .join('|');
}

/** The alternatives of an expression that are in no group. */
function alternativesOf(source: string): string[] {
  const alternatives: string[] = [];
  let start = 0;
  let depth = 0;
  let isInClass = false;
  for (let at = 0; at < source.length; at++) {
    const char = source[at];
    if (char === '\\') at++;
    else if (isInClass) isInClass = char !== ']';
    else if (char === '[') isInClass = true;
    else if (char === '(') depth++;
    else if (char === ')') depth--;
    else if (char === '|' && depth === 0) {
      alternatives.push(source.slice(start, at));
      start = at + 1;
    }
  }
  return [...alternatives, source.slice(start)];
}

/** Where a session that runs again reads and writes, and what it is made of. */
interface RerunOptions {
  /** Id of the replay, a UUID. */
  readonly replayId: string;
  readonly inputPrefix: string;
  readonly outputPrefix: string;
  /** Devices that were registered while the inputs were recorded. */
  readonly devices: readonly RecordedDevice[];
  readonly patterns: PatternCompiler;
  /** Whether the library has a module of this name. */
  isInLibrary(name: string): boolean;
}

/** A recorded session as it runs again. */
export interface RerunSession {
  readonly session: Session;
  /** Names of modules that run with their recorded code. */
  readonly recordedModules: readonly string[];
  /** Inputs that select components, of which the recording has none that fits: they stay empty. */
  readonly emptyInputs: readonly string[];
  /** Topics, as the session reads them, of the components that its inputs select. */
  readonly selected: readonly SelectedTopics[];
  /** Whether it reads this recorded topic, and does not write it itself. */
  readsTopic(topic: string): boolean;
}

type TopicTest = (topic: string) => boolean;

/** Makes a session of a recorded one: with modules of the library, and topics below the prefixes. [RP-40] */
export function rerunSession(recorded: Session, options: RerunOptions): RerunSession {
  const { isInLibrary } = options;
  const written = new Set(
    recorded.ioMappings.flatMap(({ outputMappings }) =>
      outputMappings.flatMap(({ topic }) => topic || []),
    ),
  );
  const chosen = chosenTopics(recorded, options);
  const tests = recorded.ioMappings.flatMap((mapping) =>
    readTests(mapping, chosen, options.patterns),
  );
  const pathOf = (topic: string): string =>
    (written.has(topic) ? options.outputPrefix : options.inputPrefix) + topic;
  const { lockstepHertz = 0 } = recorded.extension ?? {};
  const session = {
    name: `Replay of ${recorded.name}`,
    tags: ['replay'],
    description: recorded.description,
    authors: recorded.authors,
    extension: { lockstepHertz },
    processingModules: recorded.processingModules.map((module) =>
      isInLibrary(module.name) ? withCodeOfLibrary(module) : { ...module, nodeId: '' },
    ),
    ioMappings: recorded.ioMappings.map((mapping) =>
      moved(mapping, { pathOf, chosen, ...options }),
    ),
  };
  return {
    session: decode('ubii.sessions.Session', encode('ubii.sessions.Session', session)),
    recordedModules: recorded.processingModules
      .map(({ name }) => name)
      .filter((name) => !isInLibrary(name)),
    emptyInputs: recorded.ioMappings.flatMap(({ inputMappings }) =>
      inputMappings.flatMap(({ inputName, topicMux }) =>
        topicMux && chosen.get(topicMux)?.topics.length === 0 ? inputName : [],
      ),
    ),
    selected: [...chosen.values()].map(({ tag, topics }) => ({ tag, topics: topics.map(pathOf) })),
    readsTopic: (topic) => !written.has(topic) && tests.some((test) => test(topic)),
  };
}

/** The master completes it by its name: only what the session chose stays. [SE-1] */
function withCodeOfLibrary({ id, name, processingMode }: ProcessingModule) {
  return { id, name, processingMode };
}

/** Recorded topics of the components that muxers select, by muxer. [RP-42] */
type ChosenTopics = ReadonlyMap<TopicMux, SelectedTopics>;

function chosenTopics(recorded: Session, { replayId, devices }: RerunOptions): ChosenTopics {
  const chosen = new Map<TopicMux, SelectedTopics>();
  for (const { topicMux } of recorded.ioMappings.flatMap((mapping) => mapping.inputMappings)) {
    if (topicMux?.component === undefined) continue;
    const tag = `replay ${replayId} ${chosen.size}`;
    chosen.set(topicMux, { tag, topics: topicsOfProfile(topicMux.component, devices) });
  }
  return chosen;
}

/** A profile wins over a glob, a glob over an expression. [PM-41] */
function readTests(
  { inputMappings }: IOMapping,
  chosen: ChosenTopics,
  patterns: PatternCompiler,
): TopicTest[] {
  return inputMappings.flatMap(({ topic, topicMux }) => {
    if (topic) return [(other: string) => other === topic];
    const ofComponents = topicMux && chosen.get(topicMux);
    if (ofComponents) {
      const topics = new Set(ofComponents.topics);
      return [(other: string) => topics.has(other)];
    }
    if (topicMux?.topicGlob) return [compileGlob(topicMux.topicGlob)];
    if (!topicMux?.topicSelector) return [];
    const pattern = patterns.compile(topicMux.topicSelector);
    return [(other: string) => pattern.test(other)];
  });
}

/** How a session is moved to the topics of its replay. */
interface Move extends Pick<RerunOptions, 'inputPrefix' | 'outputPrefix'> {
  readonly chosen: ChosenTopics;
  /** The topic where a recorded one is read. */
  pathOf(topic: string): string;
}

function moved(mapping: IOMapping, { chosen, pathOf, inputPrefix, outputPrefix }: Move) {
  const { inputMappings, outputMappings } = mapping;
  return {
    ...mapping,
    inputMappings: inputMappings.map((input) => {
      const { topic, topicMux } = input;
      if (topic) return { ...input, topic: pathOf(topic) };
      if (topicMux === undefined) return input;
      const tag = chosen.get(topicMux)?.tag;
      return { ...input, topicMux: movedMux(topicMux, inputPrefix, tag) };
    }),
    outputMappings: outputMappings.map((output) => {
      const { topic, topicDemux } = output;
      if (topic) return { ...output, topic: outputPrefix + topic };
      if (topicDemux === undefined) return output;
      const outputTopicFormat = outputPrefix + topicDemux.outputTopicFormat;
      return { ...output, topicDemux: { ...topicDemux, id: '', outputTopicFormat } };
    }),
  };
}

/** @param tag of the components that the muxer selects; undefined when it selects topics */
function movedMux(mux: TopicMux, prefix: string, tag: string | undefined) {
  const { topicGlob, topicSelector } = mux;
  return {
    ...mux,
    id: '',
    topicGlob: topicGlob === '' ? '' : prefix + topicGlob,
    topicSelector: topicSelector === '' ? '' : prefixedPattern(topicSelector, prefix),
    component: tag === undefined ? undefined : { tags: [tag] },
    ...movedIdentity(mux, prefix),
  };
}

/** Identities are those of the recording. [RP-43] */
function movedIdentity({ identitySource, identityMatchPattern }: TopicMux, prefix: string) {
  if (identitySource === MuxIdentity.MUX_IDENTITY_TOPIC) {
    return {
      identitySource: MuxIdentity.MUX_IDENTITY_PATTERN,
      identityMatchPattern: `^${prefix}(.*)$`,
      identityGroup: 1,
    };
  }
  if (identityMatchPattern === '') return {};
  return { identityMatchPattern: prefixedPattern(identityMatchPattern, prefix) };
}
