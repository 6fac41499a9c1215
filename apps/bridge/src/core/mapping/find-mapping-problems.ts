import type { DataFormat } from '@ubii/proto';
import * as v from 'valibot';
import { BRIDGE_LIMITS } from '../limits.ts';
import { isPattern, parseSides } from './address-path.ts';
import { parseField } from './field-path.ts';
import { MappingFault, faultOf } from './mapping-fault.ts';
import type { Mapping, PayloadKind, Protocol, Qos } from './mapping.ts';
import { type WrittenMapping, WRITTEN_MAPPINGS } from './written-mapping.ts';

/** Values of numbers, truth values and texts need no structure. */
const PLAIN: readonly DataFormat[] = ['double', 'float', 'int32', 'bool', 'string'];
const BYTES: readonly DataFormat[] = ['image2D', 'int32List'];

/** The mapping that is meant, with its defaults. @throws MappingFault */
function compileMapping(written: WrittenMapping, protocol: Protocol): Mapping {
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
    direction,
    format,
    payload,
    field: readField(written.field ?? ''),
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

/** Most problems that are returned for one list. */
const MAX_PROBLEMS = 200;

/** What is wrong with one of several mappings, and where. */
export interface MappingProblem {
  readonly index: number;
  /** Member of the mapping; empty for the mapping as a whole. */
  readonly member: string;
  /** One sentence for a view that shows the member. */
  readonly message: string;
  /** One sentence with the place: `mappings[2].qos must be 0, 1 or 2, but is 3.` */
  readonly sentence: string;
}

/** Mappings of a list, and what is wrong with it. */
interface ReadMappings {
  readonly problems: readonly MappingProblem[];
  /** In the order of the list; `undefined` for one that is wrong. */
  readonly mappings: readonly (Mapping | undefined)[];
  /** Those that are switched off, by index. */
  readonly disabled: ReadonlySet<number>;
}

/** Reads a list of mappings as they are written. A file and a page are checked by this. [BR-1] [BR-81] */
export function findMappingProblems(list: readonly unknown[], protocol: Protocol): ReadMappings {
  const problems: MappingProblem[] = [];
  const names = new Set<string>();
  const disabled = new Set<number>();
  const mappings = list.map((written, index) => {
    const add = ({ member, words, message }: MappingFault): void => {
      if (problems.length >= MAX_PROBLEMS) return;
      const sentence = `mappings[${index}]${message}`;
      problems.push({ index, member, message: words, sentence });
    };
    const mapping = readMapping(written, protocol, add);
    if ((written as WrittenMapping | null)?.enabled === false) disabled.add(index);
    if (mapping === undefined) return undefined;
    const { name } = mapping;
    if (!names.has(name)) {
      names.add(name);
      return mapping;
    }
    const taken = `"${name}" is the name of another mapping. Choose another one.`;
    return void add(new MappingFault('name', taken));
  });
  return { problems, mappings, disabled };
}

function readMapping(
  written: unknown,
  protocol: Protocol,
  add: (fault: MappingFault) => void,
): Mapping | undefined {
  const result = v.safeParse(WRITTEN_MAPPINGS[protocol], written, { abortPipeEarly: true });
  if (!result.success) {
    for (const issue of result.issues) add(faultOf(issue));
    return undefined;
  }
  try {
    return compileMapping(result.output as WrittenMapping, protocol);
  } catch (error) {
    if (!(error instanceof MappingFault)) throw error;
    add(error);
    return undefined;
  }
}
