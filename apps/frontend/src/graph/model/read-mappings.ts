import type {
  IOMapping,
  ProcessingModule,
  Session,
  TopicDemux,
  TopicInputMapping,
  TopicMux,
  TopicOutputMapping,
} from '@ubii/proto';
import { moduleNodeId } from './make-node.ts';

/** Source of an input. */
export type InputSource =
  | { readonly kind: 'topic'; readonly topic: string }
  | { readonly kind: 'muxer'; readonly mux: TopicMux };

/** Target of an output. */
export type OutputTarget =
  | { readonly kind: 'topic'; readonly topic: string }
  | { readonly kind: 'demuxer'; readonly demux: TopicDemux };

/** All mappings of one input: usually one, but a session can have several. */
export interface InputEnds {
  readonly sources: readonly InputSource[];
  /** Empty: none. */
  readonly constantJson: string;
}

/** A module of a session with its mapping, if it has one. */
export interface MappedModule {
  readonly nodeId: string;
  readonly module: ProcessingModule;
  /** Index of its mapping in the session; -1: none. */
  readonly mappingIndex: number;
  readonly inputs: ReadonlyMap<string, InputEnds>;
  readonly outputs: ReadonlyMap<string, readonly OutputTarget[]>;
}

/**
 * Returns the modules of a session with their mappings, assigned by the rules of the master: by id, otherwise the next
 * mapping with the module's name and no id. [SE-2]
 */
export function readModules(session: Session): MappedModule[] {
  const { processingModules, ioMappings } = session;
  const indexById = new Map<string, number>();
  const indicesByName = new Map<string, number[]>();
  ioMappings.forEach(({ processingModuleId, processingModuleName }, index) => {
    if (processingModuleId !== '') {
      if (!indexById.has(processingModuleId)) indexById.set(processingModuleId, index);
      return;
    }
    const indices = indicesByName.get(processingModuleName);
    if (indices === undefined) indicesByName.set(processingModuleName, [index]);
    else indices.push(index);
  });
  const ids = new Set<string>();
  return processingModules.map((module, index) => {
    const isOwnId = module.id !== '' && !ids.has(module.id);
    ids.add(module.id);
    const byId = isOwnId ? indexById.get(module.id) : undefined;
    const mappingIndex = byId ?? indicesByName.get(module.name)?.shift() ?? -1;
    const mapping = ioMappings[mappingIndex];
    return {
      nodeId: isOwnId ? moduleNodeId(module.id) : `module#${index}`,
      module,
      mappingIndex,
      inputs: readInputs(mapping),
      outputs: readOutputs(mapping),
    };
  });
}

function readInputs(mapping: IOMapping | undefined): ReadonlyMap<string, InputEnds> {
  const ends = new Map<string, { sources: InputSource[]; constantJson: string }>();
  for (const one of mapping?.inputMappings ?? []) {
    let end = ends.get(one.inputName);
    if (end === undefined) ends.set(one.inputName, (end = { sources: [], constantJson: '' }));
    const source = sourceOf(one);
    if (source !== undefined) end.sources.push(source);
    end.constantJson ||= one.constantJson;
  }
  return ends;
}

export function sourceOf({ topic, topicMux }: TopicInputMapping): InputSource | undefined {
  if (topicMux) return { kind: 'muxer', mux: topicMux };
  return topic ? { kind: 'topic', topic } : undefined;
}

function readOutputs(mapping: IOMapping | undefined): ReadonlyMap<string, OutputTarget[]> {
  const ends = new Map<string, OutputTarget[]>();
  for (const one of mapping?.outputMappings ?? []) {
    let targets = ends.get(one.outputName);
    if (targets === undefined) ends.set(one.outputName, (targets = []));
    const target = targetOf(one);
    if (target !== undefined) targets.push(target);
  }
  return ends;
}

export function targetOf({ topic, topicDemux }: TopicOutputMapping): OutputTarget | undefined {
  if (topicDemux) return { kind: 'demuxer', demux: topicDemux };
  return topic ? { kind: 'topic', topic } : undefined;
}

/** Key of a source or target: equal for equal mappings. */
export function endKey(end: InputSource | OutputTarget): string {
  switch (end.kind) {
    case 'topic':
      return `topic ${end.topic}`;
    case 'muxer':
      return `muxer ${JSON.stringify(end.mux)}`;
    case 'demuxer':
      return `demuxer ${JSON.stringify(end.demux)}`;
  }
}
