import { isCompressedImage } from '@ubii/proto';
import type { DataFormat, Image2D } from '@ubii/proto';
import { NUMBER_MEMBERS } from '../../core/payload/members.ts';
import { parseBoundedJson } from '../../core/payload/parse-bounded-json.ts';
import type { PayloadCodec, TypedValue } from '../../core/payload/payload-codec.ts';
import { fromValue, toValue } from '../../core/payload/plain-values.ts';

/** An argument of OSC: int32, float32, string, blob, true, false, nil. */
export interface OscArgument {
  readonly type: 'i' | 'f' | 's' | 'b' | 'T' | 'F' | 'N';
  readonly value: number | string | boolean | Uint8Array | null;
}

/** What an OSC message has beside its address. */
export interface OscContent {
  readonly args: readonly OscArgument[];
  /** Time tag of its bundle, milliseconds since the Unix epoch; `undefined`: none. */
  readonly timestampMs: number | undefined;
}

const LISTS: readonly DataFormat[] = [
  ...(['doubleList', 'floatList', 'int32List', 'boolList', 'stringList'] as const),
];

/** Values of topics as arguments of OSC, and back. [BR-60] */
export const oscCodec: PayloadCodec<OscContent> = {
  read({ args, timestampMs }, { format }): TypedValue {
    if (format === undefined) throw new Error('The mapping has no data format.');
    return { format, value: toValue(format, jsonOf(format, args)), timestampMs };
  },
  write({ format, value, timestampMs = Date.now() }, { timeTag }) {
    return { args: argumentsOf(format, value), timestampMs: timeTag ? timestampMs : undefined };
  },
};

function jsonOf(format: DataFormat, args: readonly OscArgument[]): unknown {
  const values = args.map(({ value }) => value);
  const members = NUMBER_MEMBERS[format];
  if (members !== undefined) {
    if (values.length !== members.length) {
      throw new Error(`Expected ${members.length} arguments for ${format}, got ${values.length}.`);
    }
    return Object.fromEntries(members.map((member, index) => [member, values[index]]));
  }
  if (LISTS.includes(format)) return { elements: values };
  const [value] = values;
  if (values.length !== 1) throw new Error(`Expected 1 argument, got ${values.length}.`);
  if (format === 'image2D') return { width: 0, height: 0, dataFormat: 0, data: value };
  const isPlain = ['double', 'float', 'int32', 'bool', 'string'].includes(format);
  if (isPlain) return typeof value === 'boolean' && format !== 'bool' ? Number(value) : value;
  if (typeof value !== 'string') throw new Error(`Expected ${format} as JSON in a string.`);
  return parseBoundedJson(new TextEncoder().encode(value));
}

function argumentsOf(format: DataFormat, value: unknown): readonly OscArgument[] {
  const members = NUMBER_MEMBERS[format];
  if (members !== undefined) {
    const numbers = value as Readonly<Record<string, number>>;
    return members.map((member) => argument('double', numbers[member] ?? 0));
  }
  if (LISTS.includes(format)) {
    const { elements } = value as { readonly elements: readonly unknown[] };
    const single = format.replace('List', '') as DataFormat;
    return elements.map((element) => argument(single, element));
  }
  if (format === 'image2D') {
    const { data } = value as Image2D;
    if (!isCompressedImage(data)) throw new Error('Only compressed pictures are sent over OSC.');
    return [{ type: 'b', value: data }];
  }
  return [argument(format, value)];
}

function argument(format: DataFormat, value: unknown): OscArgument {
  const json = fromValue(format, value);
  if (typeof json === 'boolean') return { type: json ? 'T' : 'F', value: json };
  if (typeof json === 'number') return { type: format === 'int32' ? 'i' : 'f', value: json };
  return { type: 's', value: typeof json === 'string' ? json : JSON.stringify(json) };
}
