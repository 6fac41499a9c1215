import type {
  IOMapping,
  ProcessingModule,
  TopicInputMapping,
  TopicOutputMapping,
} from '@ubii/proto';
import type { ModuleEnds } from './module-ends.ts';
import {
  endKey,
  sourceOf,
  targetOf,
  type InputEnds,
  type InputSource,
  type MappedModule,
  type OutputTarget,
} from './read-mappings.ts';

/**
 * Returns the mapping of a module; unchanged parts keep their form and order.
 * @param old the previous module, and `mapping` at that time
 * @returns undefined when the mapping is empty and there was none
 */
export function writeMapping(
  module: ProcessingModule,
  ends: ModuleEnds,
  old: MappedModule | undefined,
  mapping: IOMapping | undefined,
): IOMapping | undefined {
  const inputMappings = writePorts(
    mapping?.inputMappings ?? [],
    ({ inputName }) => inputName,
    [...union(ends.inputs, old?.inputs)],
    (name, written) => writeInput(name, ends.inputs.get(name), old?.inputs.get(name), written),
  );
  const outputMappings = writePorts(
    mapping?.outputMappings ?? [],
    ({ outputName }) => outputName,
    [...union(ends.outputs, old?.outputs)],
    (name, written) => writeOutput(name, ends.outputs.get(name), old?.outputs.get(name), written),
  );
  if (mapping === undefined) {
    if (inputMappings.length + outputMappings.length === 0) return undefined;
    const { id: processingModuleId, name: processingModuleName } = module;
    return { processingModuleId, inputMappings, outputMappings, processingModuleName };
  }
  // Keep the form of the reference to the module: id, name or both.
  const { processingModuleId: id, processingModuleName: name } = mapping;
  const processingModuleId = id !== '' && id === old?.module.id ? module.id : id;
  const processingModuleName = name !== '' && name === old?.module.name ? module.name : name;
  return { ...mapping, processingModuleId, inputMappings, outputMappings, processingModuleName };
}

const union = (a: ReadonlyMap<string, unknown>, b?: ReadonlyMap<string, unknown>): Set<string> =>
  new Set([...(b?.keys() ?? []), ...a.keys()]);

/** Replaces mappings port by port, at the position of the port's first mapping. */
function writePorts<M>(
  written: readonly M[],
  nameOf: (mapping: M) => string,
  names: readonly string[],
  write: (name: string, written: readonly M[]) => readonly M[],
): M[] {
  const byName = new Map<string, M[]>();
  for (const mapping of written) {
    const name = nameOf(mapping);
    const ofPort = byName.get(name);
    if (ofPort === undefined) byName.set(name, [mapping]);
    else ofPort.push(mapping);
  }
  const next = new Map<string, readonly M[]>();
  for (const name of names) next.set(name, write(name, byName.get(name) ?? []));
  const result: M[] = [];
  const used = new Map<string, number>();
  for (const mapping of written) {
    const name = nameOf(mapping);
    const count = used.get(name) ?? 0;
    used.set(name, count + 1);
    const ofPort = next.get(name) ?? [];
    const isLast = count + 1 === byName.get(name)?.length;
    result.push(...ofPort.slice(count, isLast ? undefined : count + 1));
  }
  for (const [name, ofPort] of next) if (!used.has(name)) result.push(...ofPort);
  return result;
}

function writeInput(
  inputName: string,
  ends: InputEnds = { sources: [], constantJson: '' },
  old: InputEnds | undefined,
  written: readonly TopicInputMapping[],
): readonly TopicInputMapping[] {
  const isSame =
    old !== undefined &&
    ends.constantJson === old.constantJson &&
    haveSameEnds(ends.sources, old.sources);
  if (isSame) return written;
  const { sources, constantJson } = ends;
  if (sources.length === 0 && constantJson === '') return [];
  const wanted = sources.length === 0 ? [undefined] : sources;
  return assign(wanted, written, sourceOf).map(({ end, mapping }, index) => ({
    ...withoutSource(mapping),
    inputName,
    ...sourceMember(end),
    constantJson: index === 0 ? constantJson : '',
  }));
}

function withoutSource(mapping: TopicInputMapping | undefined): object {
  const { topic: _topic, topicMux: _mux, ...rest } = mapping ?? {};
  return rest;
}

function sourceMember(source: InputSource | undefined): object {
  if (source === undefined) return {};
  return source.kind === 'topic' ? { topic: source.topic } : { topicMux: source.mux };
}

function writeOutput(
  outputName: string,
  targets: readonly OutputTarget[] = [],
  old: readonly OutputTarget[] | undefined,
  written: readonly TopicOutputMapping[],
): readonly TopicOutputMapping[] {
  if (old !== undefined && haveSameEnds(targets, old)) return written;
  return assign(targets, written, targetOf).map(({ end, mapping }) => {
    const { topic: _topic, topicDemux: _demux, ...rest } = mapping ?? {};
    const member = end.kind === 'topic' ? { topic: end.topic } : { topicDemux: end.demux };
    return { ...rest, outputName, ...member };
  });
}

type End = InputSource | OutputTarget;

function haveSameEnds(a: readonly End[], b: readonly End[]): boolean {
  if (a.length !== b.length) return false;
  const keys = a.map(endKey).sort();
  return b
    .map(endKey)
    .sort()
    .every((key, index) => key === keys[index]);
}

/** Assigns each end the mapping with the same content, otherwise a remaining one. */
function assign<M, E extends End | undefined>(
  ends: readonly E[],
  written: readonly M[],
  endOf: (mapping: M) => End | undefined,
): { end: E; mapping: M | undefined }[] {
  const keyOf = (end: End | undefined): string => (end === undefined ? '' : endKey(end));
  const left = new Set(written);
  const same = ends.map((end) => {
    const mapping = [...left].find((one) => keyOf(endOf(one)) === keyOf(end));
    if (mapping !== undefined) left.delete(mapping);
    return mapping;
  });
  return ends.map((end, index) => {
    const mapping = same[index] ?? [...left][0];
    if (mapping !== undefined) left.delete(mapping);
    return { end, mapping };
  });
}
