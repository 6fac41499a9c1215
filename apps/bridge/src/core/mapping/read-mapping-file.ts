import { isDataFormat } from '@ubii/proto';
import type { DataFormat } from '@ubii/proto';
import * as v from 'valibot';
import { BRIDGE_LIMITS } from '../limits.ts';
import { isPattern, parseSides } from './address-path.ts';
import { parseField } from './field-path.ts';
import { PAYLOADS } from './mapping.ts';
import type { Mapping, PayloadKind, Protocol, Qos } from './mapping.ts';

/** Discovery of Home Assistant: `prefix` of its topics, `topics` for the values. */
export interface HomeAssistantSettings {
  readonly prefix: string;
  readonly topics: string;
}

/** A mapping file. */
export interface MappingFile {
  /** Name of the other system, for bridges that reach the same one under different addresses. [BR-22] */
  readonly system: string | undefined;
  /** Address at which the bridge says whether it is there; MQTT only. */
  readonly availability: string | undefined;
  readonly homeAssistant: HomeAssistantSettings | undefined;
  readonly mappings: readonly Mapping[];
}

/** Values of numbers, truth values and texts need no structure. */
const PLAIN: readonly DataFormat[] = ['double', 'float', 'int32', 'bool', 'string'];
const BYTES: readonly DataFormat[] = ['image2D', 'int32List'];

const name = (what: string) =>
  v.pipe(v.string(what), v.minLength(1, what), v.maxLength(200, what), v.regex(/^\P{Cc}*$/u, what));
const address = name('must be a text of 1 to 200 characters without control characters');
const count = (least: number, most: number, noun = 'number') => {
  const what = `must be a ${noun} from ${least} to ${most}`;
  return v.pipe(v.number(what), v.minValue(least, what), v.maxValue(most, what));
};
const whole = (least: number, most: number) =>
  v.pipe(
    count(least, most, 'whole number'),
    v.integer(`must be a whole number from ${least} to ${most}`),
  );
const flag = v.boolean('must be true or false');

const COMMON = {
  name: v.optional(address),
  direction: v.picklist(['in', 'out', 'both'], 'must be "in", "out" or "both"'),
  foreign: address,
  topic: address,
  format: v.optional(
    v.custom<DataFormat>(
      (text) => typeof text === 'string' && isDataFormat(text),
      'must be a data format, such as "double", "bool", "string" or "vector3"',
    ),
  ),
  maxRateHz: v.optional(count(0, 10_000)),
  maxTopics: v.optional(whole(1, BRIDGE_LIMITS.mostTopicsPerMapping)),
  maxBytes: v.optional(whole(1, BRIDGE_LIMITS.messageBytes)),
};

const MAPPINGS = {
  mqtt: v.strictObject({
    ...COMMON,
    payload: v.optional(
      v.picklist(PAYLOADS, 'must be "json", "text", "number", "bytes" or "protobuf"'),
    ),
    field: v.optional(v.string('must be a text, such as "values[0].celsius"')),
    qos: v.optional(v.picklist([0, 1, 2], 'must be 0, 1 or 2')),
    retained: v.optional(flag),
  }),
  osc: v.strictObject({ ...COMMON, timeTag: v.optional(flag) }),
  rosbridge: v.strictObject({
    ...COMMON,
    type: v.pipe(
      v.string('must be a message type, such as "std_msgs/Float64"'),
      v.regex(
        /^\w+\/(msg\/)?\w+$/,
        'must be a message type with its package, such as "std_msgs/Float64"',
      ),
    ),
    compression: v.optional(v.picklist(['none', 'cbor'], 'must be "none" or "cbor"')),
    queueLength: v.optional(whole(0, 1_000)),
    retained: v.optional(flag),
  }),
};

const FILES = {
  mqtt: fileOf(MAPPINGS.mqtt, {
    availability: v.optional(address),
    homeAssistant: v.optional(
      v.strictObject({ prefix: v.optional(address), topics: v.optional(address) }),
    ),
  }),
  osc: fileOf(MAPPINGS.osc, {}),
  rosbridge: fileOf(MAPPINGS.rosbridge, {}),
};

function fileOf<M extends v.GenericSchema, E extends v.ObjectEntries>(mapping: M, entries: E) {
  const most = `must be a list of at most ${BRIDGE_LIMITS.mappings} mappings`;
  return v.strictObject({
    version: v.literal(1, 'must be 1'),
    system: v.optional(address),
    mappings: v.pipe(v.array(mapping, most), v.maxLength(BRIDGE_LIMITS.mappings, most)),
    ...entries,
  });
}

interface WrittenMapping {
  readonly name?: string | undefined;
  readonly direction: Mapping['direction'];
  readonly foreign: string;
  readonly topic: string;
  readonly format?: DataFormat | undefined;
  readonly payload?: PayloadKind | undefined;
  readonly field?: string | undefined;
  readonly qos?: number | undefined;
  readonly retained?: boolean | undefined;
  readonly type?: string | undefined;
  readonly timeTag?: boolean | undefined;
  readonly compression?: Mapping['compression'] | undefined;
  readonly queueLength?: number | undefined;
  readonly maxRateHz?: number | undefined;
  readonly maxTopics?: number | undefined;
  readonly maxBytes?: number | undefined;
}

interface WrittenFile {
  readonly system?: string | undefined;
  readonly availability?: string | undefined;
  readonly homeAssistant?:
    { readonly prefix?: string | undefined; readonly topics?: string | undefined } | undefined;
  readonly mappings: readonly WrittenMapping[];
}

/**
 * Reads a mapping file. [BR-1]
 *
 * @throws Error with one sentence: where, what, and what to write instead
 */
export function readMappingFile(text: string, protocol: Protocol): MappingFile {
  const written = parseFile(text, protocol);
  const names = new Set<string>();
  const mappings = written.mappings.map((mapping, index) => {
    const place = `mappings[${index}]`;
    const read = compile(mapping, protocol, place);
    if (names.has(read.name)) {
      throw new Error(
        `${place}.name: "${read.name}" is the name of another mapping. Choose another one.`,
      );
    }
    names.add(read.name);
    return read;
  });
  const { system, availability, homeAssistant } = written;
  if (availability !== undefined) expectTopicName(availability, 'availability');
  return {
    ...{ system, availability, mappings },
    homeAssistant: homeAssistant && {
      prefix: homeAssistant.prefix ?? 'homeassistant',
      topics: homeAssistant.topics ?? 'ubii',
    },
  };
}

function parseFile(text: string, protocol: Protocol): WrittenFile {
  if (text.length > BRIDGE_LIMITS.mappingFileChars) {
    throw new Error(
      `The mapping has more than ${BRIDGE_LIMITS.mappingFileChars} characters. Divide it between several bridges.`,
    );
  }
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch (error) {
    throw new Error(`The mapping is not JSON: ${(error as Error).message}.`, { cause: error });
  }
  const result = v.safeParse(FILES[protocol], json, { abortEarly: true });
  if (!result.success) throw new Error(sentence(result.issues[0]));
  return result.output as WrittenFile;
}

function compile(written: WrittenMapping, protocol: Protocol, place: string): Mapping {
  const { direction, format } = written;
  const payload = written.payload ?? 'json';
  const takesIn = direction !== 'out';
  const at = <T>(member: string, read: () => T, start = ''): T => {
    try {
      return read();
    } catch (error) {
      throw new Error(`${place}${member}: ${start}${(error as Error).message}`, { cause: error });
    }
  };
  const sides = at('', () => parseSides(written.foreign, written.topic, direction));
  at('.topic', () => expectTopicOfClients(written.topic));
  if (protocol === 'mqtt') checkPayload(written, payload, place);
  if (protocol === 'rosbridge' && takesIn && isPattern(sides.foreign)) {
    throw new Error(
      `${place}.foreign: rosbridge subscribes to single topics. Write a mapping for each.`,
    );
  }
  if (takesIn && format === undefined && payload !== 'protobuf') {
    throw new Error(
      `${place}.format is missing. Set the data format of the topics, such as "double".`,
    );
  }
  const field = at('.field', () => parseField(written.field ?? ''), 'must be ');
  return {
    name: written.name ?? `${written.foreign} ${direction} ${written.topic}`,
    ...sides,
    ...{ direction, format, payload, field },
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

function checkPayload({ format, field }: WrittenMapping, payload: PayloadKind, place: string) {
  const expect = (formats: readonly DataFormat[]): void => {
    if (format !== undefined && formats.includes(format)) return;
    throw new Error(
      `${place}.format: the payload "${payload}" carries ${formats.join(', ')}. Choose one of them, or the payload "json".`,
    );
  };
  if (payload === 'text') expect(PLAIN);
  if (payload === 'number') expect(['double', 'float', 'int32', 'bool']);
  if (payload === 'bytes') expect(BYTES);
  if (field !== undefined && payload !== 'json') {
    throw new Error(`${place}.field is for the payload "json" only. Remove it.`);
  }
}

function expectTopicOfClients(topic: string): void {
  const path = topic.startsWith('/') ? topic : `/${topic}`;
  if (/^\/(info|ubii)\//.test(path)) {
    throw new Error('topics below /info/ and /ubii/ are those of the master. Choose other topics.');
  }
}

function expectTopicName(topic: string, place: string): void {
  if (!/[+#]/.test(topic)) return;
  throw new Error(`${place}: "${topic}" has a wildcard. Write one topic.`);
}

/** Says where and what: `mappings[2].qos must be 0, 1 or 2.` */
function sentence(issue: v.BaseIssue<unknown>): string {
  const steps = issue.path?.map(({ key }) =>
    typeof key === 'number' ? `[${key}]` : `.${String(key)}`,
  );
  const place = (steps ?? []).join('').replace(/^\./, '');
  if (issue.type === 'strict_object' && issue.expected === 'never') {
    return `${place} is unknown. Check how it is written, or remove it.`;
  }
  if (issue.type === 'strict_object' && issue.received === 'undefined')
    return `${place} is missing.`;
  if (issue.type === 'strict_object') return `${place || 'The mapping'} must be an object.`;
  return `${place} ${issue.message}, but is ${JSON.stringify(issue.input)?.slice(0, 100) ?? 'missing'}.`;
}
