import {
  MuxIdentity,
  UUID_PATTERN,
  type Session,
  type ProcessingModule,
  type TopicDemux,
  type TopicInputMapping,
  type TopicMux,
  type TopicOutputMapping,
} from '@ubii/proto';

/** Source of an input or target of an output. */
export type MappingEnd =
  | { readonly kind: 'topic'; readonly topic: string }
  /** Several topics: their pattern, and how elements are identified. */
  | { readonly kind: 'muxer'; readonly pattern: string; readonly words: string }
  | { readonly kind: 'demuxer'; readonly pattern: string; readonly words: string }
  /** Value as JSON text, without the name of its data format. */
  | { readonly kind: 'constant'; readonly value: string }
  | { readonly kind: 'none' };

/** Input or output of a module, with its mappings. */
export interface MappedIO {
  readonly name: string;
  readonly format: string;
  readonly isList: boolean;
  /** False when the mapping has it, but not the module. [SE-4] */
  readonly isDeclared: boolean;
  readonly end: MappingEnd;
}

const IDENTITIES: Readonly<Record<MuxIdentity, string>> = {
  [MuxIdentity.MUX_IDENTITY_PATTERN]: 'identified by publisher',
  [MuxIdentity.MUX_IDENTITY_CLIENT_ID]: 'identified by client',
  [MuxIdentity.MUX_IDENTITY_DEVICE_ID]: 'identified by device',
  [MuxIdentity.MUX_IDENTITY_TOPIC]: 'identified by topic',
};

function muxPattern({ component, topicGlob, topicSelector }: TopicMux): string {
  if (component) {
    const wanted = [
      component.messageFormat,
      component.name && `named ${component.name}`,
      component.tags.length > 0 ? `tagged ${component.tags.join(', ')}` : '',
    ].filter((word) => word !== '');
    return wanted.length > 0 ? `components: ${wanted.join(', ')}` : 'all components';
  }
  return topicGlob || topicSelector;
}

/** Formats a muxer. [PM-41, PM-43] */
function muxWords(mux: TopicMux): string {
  const { identitySource, identityMatchPattern } = mux;
  if (identitySource === MuxIdentity.MUX_IDENTITY_PATTERN && identityMatchPattern !== '') {
    const isId = identityMatchPattern === UUID_PATTERN;
    return `identified by ${isId ? 'the id in the topic' : identityMatchPattern}`;
  }
  return IDENTITIES[identitySource] ?? '';
}

const inputEnd = (mapping: TopicInputMapping | undefined): MappingEnd => {
  if (mapping?.topic) return { kind: 'topic', topic: mapping.topic };
  const mux = mapping?.topicMux;
  if (mux) return { kind: 'muxer', pattern: muxPattern(mux), words: muxWords(mux) };
  if (mapping?.constantJson)
    return { kind: 'constant', value: constantValue(mapping.constantJson) };
  return { kind: 'none' };
};

/** Formats a constant: `{"double":0.5}` as `0.5`; invalid ones unchanged. [PM-34] */
function constantValue(json: string): string {
  try {
    const record: unknown = JSON.parse(json);
    if (typeof record !== 'object' || record === null) return json;
    const values: unknown[] = Object.values(record);
    return values.length === 1 ? JSON.stringify(values[0]) : json;
  } catch {
    return json;
  }
}

const demuxEnd = ({ outputTopicFormat }: TopicDemux): MappingEnd => ({
  kind: 'demuxer',
  pattern: outputTopicFormat,
  words: 'one topic for each element',
});

const outputEnd = (mapping: TopicOutputMapping | undefined): MappingEnd => {
  if (mapping?.topic) return { kind: 'topic', topic: mapping.topic };
  return mapping?.topicDemux ? demuxEnd(mapping.topicDemux) : { kind: 'none' };
};

/** Inputs and outputs of a session's module: declared ones, then undeclared ones with a mapping. */
export interface MappedModule {
  readonly inputs: readonly MappedIO[];
  readonly outputs: readonly MappedIO[];
}

export function mappedModule(
  module: ProcessingModule,
  { ioMappings }: Pick<Session, 'ioMappings'>,
): MappedModule {
  const mapping = ioMappings.find(({ processingModuleId }) => processingModuleId === module.id);
  const inputs = mapping?.inputMappings ?? [];
  const outputs = mapping?.outputMappings ?? [];
  return {
    inputs: join(module.inputs, inputs, ({ inputName }) => inputName, inputEnd),
    outputs: join(module.outputs, outputs, ({ outputName }) => outputName, outputEnd),
  };
}

function join<M>(
  declared: ProcessingModule['inputs'],
  mappings: readonly M[],
  nameOf: (mapping: M) => string,
  endOf: (mapping: M | undefined) => MappingEnd,
): MappedIO[] {
  const known = declared.map(({ internalName, messageFormat, isRecordList }) => ({
    name: internalName,
    format: messageFormat,
    isList: isRecordList,
    isDeclared: true,
    end: endOf(mappings.find((mapping) => nameOf(mapping) === internalName)),
  }));
  const names = new Set(known.map(({ name }) => name));
  const unknown = mappings
    .filter((mapping) => !names.has(nameOf(mapping)))
    .map((mapping) => ({
      name: nameOf(mapping),
      format: '',
      isList: false,
      isDeclared: false,
      end: endOf(mapping),
    }));
  return [...known, ...unknown];
}
