import type { DataFormat } from '@ubii/proto';
import { BRIDGE_LIMITS } from '../limits.ts';
import { isPattern, parseSides } from './address-path.ts';
import { parseField } from './field-path.ts';
import { MappingFault } from './mapping-fault.ts';
import type { Mapping, PayloadKind, Protocol, Qos } from './mapping.ts';
import type { WrittenMapping } from './written-mapping.ts';

/** Values of numbers, truth values and texts need no structure. */
const PLAIN: readonly DataFormat[] = ['double', 'float', 'int32', 'bool', 'string'];
const BYTES: readonly DataFormat[] = ['image2D', 'int32List'];

/** The mapping that is meant, with its defaults. @throws MappingFault */
export function compileMapping(written: WrittenMapping, protocol: Protocol): Mapping {
  const { direction, format } = written;
  const payload = written.payload ?? 'json';
  const takesIn = direction !== 'out';
  const sides = readSides(written);
  expectTopicOfClients(written.topic);
  if (protocol === 'mqtt') checkPayload(written, payload);
  if (protocol === 'rosbridge' && takesIn && isPattern(sides.foreign)) {
    throw new MappingFault(
      'foreign',
      'rosbridge subscribes to single topics. Write a mapping for each.',
    );
  }
  if (takesIn && format === undefined && payload !== 'protobuf') {
    const words = 'Set the data format of the topics, such as "double".';
    throw new MappingFault('format', words, `.format is missing. ${words}`);
  }
  return {
    name: nameOf(written),
    ...sides,
    ...{ direction, format, payload, field: readField(written.field ?? '') },
    qos: (written.qos ?? 0) as Qos,
    retained: written.retained ?? false,
    // ROS 2 writes std_msgs/msg/Float64 for what ROS 1 calls std_msgs/Float64.
    rosType: (written.type ?? '').replace('/msg/', '/'),
    timeTag: written.timeTag ?? false,
    compression: written.compression ?? 'none',
    queueLength: written.queueLength ?? 1,
    maxRateHz: written.maxRateHz ?? 0,
    maxTopics: written.maxTopics ?? BRIDGE_LIMITS.topicsPerMapping,
    maxBytes: written.maxBytes ?? BRIDGE_LIMITS.messageBytes,
  };
}

/** A mapping without a name has one made of both sides. */
function nameOf({ name, foreign, direction, topic }: WrittenMapping): string {
  return name ?? `${foreign} ${direction} ${topic}`;
}

function readSides({ foreign, topic, direction }: WrittenMapping) {
  try {
    return parseSides(foreign, topic, direction);
  } catch (error) {
    const { message } = error as Error;
    // Its sentences name the side that is wrong; one about both does not.
    const [, side = ''] = /`(foreign|topic)`/.exec(message) ?? [];
    throw new MappingFault(side, side === '' ? message : withoutSides(message), `: ${message}`);
  }
}

/** The same sentence for a view that shows the side. */
function withoutSides(message: string): string {
  return message
    .replace(/^`(foreign|topic)` | of `(foreign|topic)`/g, '')
    .replace(/`(foreign|topic)`/, 'the other pattern');
}

function readField(text: string): Mapping['field'] {
  try {
    return parseField(text);
  } catch (error) {
    throw new MappingFault('field', `must be ${(error as Error).message}`);
  }
}

function checkPayload({ format, field }: WrittenMapping, payload: PayloadKind): void {
  const expect = (formats: readonly DataFormat[]): void => {
    if (format !== undefined && formats.includes(format)) return;
    throw new MappingFault(
      'format',
      `the payload "${payload}" carries ${formats.join(', ')}. Choose one of them, or the payload "json".`,
    );
  };
  if (payload === 'text') expect(PLAIN);
  if (payload === 'number') expect(['double', 'float', 'int32', 'bool']);
  if (payload === 'bytes') expect(BYTES);
  if (field !== undefined && payload !== 'json') {
    const predicate = 'is for the payload "json" only. Remove it.';
    throw new MappingFault('field', predicate, `.field ${predicate}`);
  }
}

function expectTopicOfClients(topic: string): void {
  const path = topic.startsWith('/') ? topic : `/${topic}`;
  if (!/^\/(info|ubii)\//.test(path)) return;
  throw new MappingFault(
    'topic',
    'topics below /info/ and /ubii/ are those of the master. Choose other topics.',
  );
}
