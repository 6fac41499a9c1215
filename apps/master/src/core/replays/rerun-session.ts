import { compileGlob, type PatternCompiler } from '@ubii/patterns';
import {
  decode,
  encode,
  type IOMapping,
  type ProcessingModule,
  type Session,
  type TopicMux,
} from '@ubii/proto';
import { prefixedPattern } from './prefixed-pattern.ts';

/** Where a session that runs again reads and writes, and what it is made of. */
export interface RerunOptions {
  readonly inputPrefix: string;
  readonly outputPrefix: string;
  readonly patterns: PatternCompiler;
  /** Whether the library has a module of this name. */
  isInLibrary(name: string): boolean;
}

/** A recorded session as it runs again. */
export interface RerunSession {
  readonly session: Session;
  /** Names of modules that run with their recorded code. */
  readonly recordedModules: readonly string[];
  /** Inputs that are chosen by components: these are not recorded, so the inputs stay empty. */
  readonly emptyInputs: readonly string[];
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
  const tests = recorded.ioMappings.flatMap((mapping) => readTests(mapping, options.patterns));
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
    ioMappings: recorded.ioMappings.map((mapping) => moved(mapping, written, options)),
  };
  return {
    session: decode('ubii.sessions.Session', encode('ubii.sessions.Session', session)),
    recordedModules: recorded.processingModules
      .map(({ name }) => name)
      .filter((name) => !isInLibrary(name)),
    emptyInputs: recorded.ioMappings.flatMap(({ inputMappings }) =>
      inputMappings.flatMap(({ inputName, topicMux }) => (topicMux?.component ? inputName : [])),
    ),
    readsTopic: (topic) => !written.has(topic) && tests.some((test) => test(topic)),
  };
}

/** The master completes it by its name: only what the session chose stays. [SE-1] */
function withCodeOfLibrary({ id, name, processingMode }: ProcessingModule) {
  return { id, name, processingMode };
}

function readTests({ inputMappings }: IOMapping, patterns: PatternCompiler): TopicTest[] {
  return inputMappings.flatMap(({ topic, topicMux }) => {
    if (topic) return [(other: string) => other === topic];
    if (topicMux?.topicGlob) return [compileGlob(topicMux.topicGlob)];
    if (!topicMux?.topicSelector) return [];
    const pattern = patterns.compile(topicMux.topicSelector);
    return [(other: string) => pattern.test(other)];
  });
}

function moved(
  mapping: IOMapping,
  written: ReadonlySet<string>,
  { inputPrefix, outputPrefix }: RerunOptions,
) {
  const { inputMappings, outputMappings } = mapping;
  return {
    ...mapping,
    inputMappings: inputMappings.map((input) => {
      const { topic, topicMux } = input;
      if (topic) {
        return { ...input, topic: (written.has(topic) ? outputPrefix : inputPrefix) + topic };
      }
      return topicMux === undefined
        ? input
        : { ...input, topicMux: movedMux(topicMux, inputPrefix) };
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

function movedMux(mux: TopicMux, prefix: string): TopicMux {
  const { topicGlob, topicSelector, identityMatchPattern } = mux;
  return {
    ...mux,
    id: '',
    topicGlob: topicGlob === '' ? '' : prefix + topicGlob,
    topicSelector: topicSelector === '' ? '' : prefixedPattern(topicSelector, prefix),
    identityMatchPattern:
      identityMatchPattern === '' ? '' : prefixedPattern(identityMatchPattern, prefix),
  };
}
