import {
  parseDataFormat,
  type DataFormat,
  type ModuleIO,
  type ProcessingModule,
  type TopicDemux,
  type TopicMux,
} from '@ubii/proto';
import type { Port } from './graph.ts';

/** Ids of the ports of topics, muxers, demuxers and constants. */
export const IN = 'in';
export const OUT = 'out';

/** Port id of a module's input. */
export const inputPort = (name: string): string => `in:${name}`;

/** Port id of a module's output. */
export const outputPort = (name: string): string => `out:${name}`;

/** Internal name of a module's input or output. */
export const ioName = (portId: string): string => portId.slice(portId.indexOf(':') + 1);

interface Direction {
  readonly direction: 'in' | 'out';
}

const plain = (
  { direction }: Direction,
  format: DataFormat | undefined,
  { isList = false, formatText = format ?? '' } = {},
): Port => ({
  id: direction,
  name: '',
  direction,
  format,
  formatText,
  isList,
  isDeclared: true,
});

export function topicPorts(format: DataFormat | undefined): readonly Port[] {
  return [plain({ direction: 'in' }, format), plain({ direction: 'out' }, format)];
}

export function muxerPorts({ dataType }: TopicMux): readonly Port[] {
  const options = { isList: true, formatText: dataType };
  return [plain({ direction: 'out' }, parseDataFormat(dataType), options)];
}

export function demuxerPorts({ dataType }: TopicDemux): readonly Port[] {
  const options = { isList: true, formatText: dataType };
  return [plain({ direction: 'in' }, parseDataFormat(dataType), options)];
}

export function constantPorts(json: string): readonly Port[] {
  return [plain({ direction: 'out' }, constantFormat(json))];
}

/** Data format of a constant; undefined for other JSON. [PM-34] */
export function constantFormat(json: string): DataFormat | undefined {
  try {
    const value: unknown = JSON.parse(json);
    const [member, ...more] = typeof value === 'object' && value !== null ? Object.keys(value) : [];
    return member === undefined || more.length > 0 ? undefined : parseDataFormat(member);
  } catch {
    return undefined;
  }
}

/**
 * Ports of a module: declared ones without duplicates, then undeclared ones that occur in mappings.
 * @param mapped names of inputs and of outputs in mappings and constants
 */
export function modulePorts(
  module: ProcessingModule,
  mapped: { readonly inputs: Iterable<string>; readonly outputs: Iterable<string> },
): readonly Port[] {
  return [
    ...sidePorts(module.inputs, mapped.inputs, { direction: 'in' }),
    ...sidePorts(module.outputs, mapped.outputs, { direction: 'out' }),
  ];
}

function sidePorts(
  declared: readonly ModuleIO[],
  mapped: Iterable<string>,
  { direction }: Direction,
): Iterable<Port> {
  const idOf = direction === 'in' ? inputPort : outputPort;
  const ports = new Map<string, Port>();
  for (const io of declared) {
    const { internalName, messageFormat, isRecordList } = io;
    if (ports.has(internalName)) continue;
    ports.set(internalName, {
      id: idOf(internalName),
      name: internalName,
      direction,
      format: parseDataFormat(messageFormat),
      formatText: messageFormat,
      isList: isRecordList,
      isDeclared: true,
      defaultJson: io.defaultJson || undefined,
      description: io.description || undefined,
      choices: io.choices.length > 0 ? io.choices : undefined,
    });
  }
  for (const name of mapped) {
    if (ports.has(name)) continue;
    ports.set(name, {
      ...plain({ direction }, undefined),
      id: idOf(name),
      name,
      isDeclared: false,
    });
  }
  return ports.values();
}
