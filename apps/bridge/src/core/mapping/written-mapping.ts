import { isDataFormat } from '@ubii/proto';
import type { DataFormat } from '@ubii/proto';
import * as v from 'valibot';
import { BRIDGE_LIMITS } from '../limits.ts';
import { PAYLOADS } from './mapping.ts';
import type { Mapping, PayloadKind } from './mapping.ts';

const name = (what: string) =>
  v.pipe(v.string(what), v.minLength(1, what), v.maxLength(200, what), v.regex(/^\P{Cc}*$/u, what));
/** A text that names or selects something. */
export const address = name('must be a text of 1 to 200 characters without control characters');
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
  enabled: v.optional(flag),
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

/** Mappings as they are written, by protocol. */
export const WRITTEN_MAPPINGS = {
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

/** A mapping as it is written, whatever the protocol. */
export interface WrittenMapping {
  readonly name?: string | undefined;
  readonly enabled?: boolean | undefined;
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
