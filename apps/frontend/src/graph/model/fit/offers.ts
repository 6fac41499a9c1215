import { formatsFit, parseModule } from '@ubii/pm-sandbox';
import { UUID_PATTERN, type DataFormat, type ProcessingModule } from '@ubii/proto';
import { freeTopic } from '../commands/free-topic.ts';
import type { Graph } from '../graph.ts';
import { wiresAt } from '../wires-of.ts';
import type { Adapter } from './adapter.ts';
import { fieldsOf } from './fields.ts';
import type { WireEnd } from './wire-end.ts';

/** Name of the library module that extracts a part of a value. */
export const PICK_FIELD = 'pick-field';
/** Names of its inputs. */
export const PICK_VALUE = 'value';
export const PICK_PATH = 'path';

/** Most parts of a value that are offered. */
const MAX_FIELDS = 8;
const MAX_MODULES = 5;

/** Adapters between single records and lists. */
export function listOffers(graph: Graph, from: WireEnd, to: WireEnd): Adapter[] {
  const dataType = from.format ?? to.format ?? '';
  if (!formatsFit(from.format, to.format)) return [];
  if (from.port.isList && to.port.isList) {
    const topic = freeTopic(graph, from.ref);
    return [
      {
        kind: 'spread',
        label: 'One topic for each element',
        outputTopicFormat: `${topic}/{{#0}}`,
        topicGlob: `${topic}/*`,
        dataType,
      },
    ];
  }
  if (from.port.isList && from.node.kind === 'module') {
    const base = to.node.kind === 'topic' ? to.node.topic : freeTopic(graph, from.ref);
    const outputTopicFormat = `${base}/{{#0}}`;
    return [{ kind: 'demuxer', label: `Demuxer to ${base}/…`, outputTopicFormat, dataType }];
  }
  if (to.port.isList && to.node.kind === 'module') {
    const topic = topicAt(graph, from);
    const alike = topic === undefined ? undefined : globOfAlike(topic);
    const offers: Adapter[] = [];
    for (const topicGlob of new Set([alike, topic])) {
      if (topicGlob === undefined) continue;
      offers.push({ kind: 'muxer', label: `Muxer of ${topicGlob}`, topicGlob, dataType });
    }
    return offers;
  }
  return [];
}

/** Topic of an output, or the one it would get. */
function topicAt(graph: Graph, { node, ref }: WireEnd): string | undefined {
  if (node.kind === 'topic') return node.topic;
  if (node.kind !== 'module') return undefined;
  for (const { via, to } of wiresAt(graph, ref)) {
    const target = graph.nodes.get(to.node);
    if (via !== undefined) return via;
    if (target?.kind === 'topic') return target.topic;
  }
  return freeTopic(graph, ref);
}

// eslint-disable-next-line ubii/no-native-patterns -- our own pattern, linear
const UUID = new RegExp(UUID_PATTERN, 'i');

/** True when a level of the topic identifies a client or device. */
export const isOfClient = (topic: string): boolean =>
  topic.split('/').some((part) => UUID.test(part));

/** Glob for the same topic of all clients or devices; undefined when no level identifies a client or device. */
export function globOfAlike(topic: string): string | undefined {
  const parts = topic.split('/');
  const glob = parts.map((part) => (UUID.test(part) ? '*' : part)).join('/');
  return glob === topic ? undefined : glob;
}

/** Adapters between data formats. */
export function formatOffers(
  from: WireEnd,
  to: WireEnd,
  library: readonly ProcessingModule[],
): Adapter[] {
  if (from.port.isList || to.port.isList || to.format === undefined) return [];
  return [...fieldOffers(from.format, to.format, library), ...moduleOffers(from, to, library)];
}

function fieldOffers(
  from: DataFormat | undefined,
  to: DataFormat,
  library: readonly ProcessingModule[],
): Adapter[] {
  const module = library.find(({ name }) => name === PICK_FIELD);
  if (module === undefined || from === undefined) return [];
  const { outputs } = parseModule(module);
  return fieldsOf(from)
    .filter(({ format }) => formatsFit(format, to))
    .slice(0, MAX_FIELDS)
    .flatMap(({ path, format }): Adapter[] => {
      const output = outputs.find((one) => one.format === format)?.name;
      if (output === undefined) return [];
      return [{ kind: 'field', label: path, path, module, input: PICK_VALUE, output }];
    });
}

function moduleOffers(from: WireEnd, to: WireEnd, library: readonly ProcessingModule[]): Adapter[] {
  return library
    .flatMap((module) => {
      if (module.name === PICK_FIELD) return [];
      const { inputs, outputs } = parseModule(module);
      const takes = (io: { format: DataFormat | undefined; isList: boolean }): boolean =>
        !io.isList && io.format !== undefined && formatsFit(io.format, from.format);
      const gives = (io: { format: DataFormat | undefined; isList: boolean }): boolean =>
        !io.isList && io.format !== undefined && formatsFit(io.format, to.format);
      // The first input takes the data; the others are parameters.
      const [input] = inputs;
      const output = outputs.find(gives);
      if (input === undefined || output === undefined || !takes(input)) return [];
      const ports = inputs.length + outputs.length;
      return [{ module, input: input.name, output: output.name, ports }];
    })
    .sort((a, b) => a.ports - b.ports)
    .slice(0, MAX_MODULES)
    .map(({ module, input, output }) => ({
      kind: 'module',
      label: `${module.name} · ${output}`,
      module,
      input,
      output,
    }));
}
