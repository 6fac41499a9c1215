/** Facts of a stream for its header. */
export interface StreamFacts {
  readonly name: string;
  /** Such as `vector3` or `Markers`. */
  readonly type: string;
  readonly channels: readonly string[];
  readonly format: 'double64' | 'string';
  /** The publisher: identifies the stream in other recordings. */
  readonly sourceId: string;
  readonly host: string;
}

/** Header of a stream as programs of the Lab Streaming Layer write it; irregular rate. */
export function headerXml({ name, type, channels, format, sourceId, host }: StreamFacts): string {
  const labels = channels.map((label) => `<channel>${element('label', label)}</channel>`);
  return info(
    element('name', name) +
      element('type', type) +
      element('channel_count', String(channels.length)) +
      element('nominal_srate', '0') +
      element('channel_format', format) +
      element('source_id', sourceId) +
      element('hostname', host) +
      `<desc><channels>${labels.join('')}</channels></desc>`,
  );
}

/** @param first @param last times of the samples, seconds */
export function footerXml(first: number, last: number, count: number): string {
  return info(
    element('first_timestamp', String(first)) +
      element('last_timestamp', String(last)) +
      element('sample_count', String(count)),
  );
}

function info(content: string): string {
  return `<?xml version="1.0"?><info>${content}</info>`;
}

function element(name: string, content: string): string {
  return `<${name}>${escaped(content)}</${name}>`;
}

const ENTITIES: Readonly<Record<string, string>> = { '&': '&amp;', '<': '&lt;', '>': '&gt;' };

/** Characters that XML 1.0 does not have, such as control characters, are left out. */
function escaped(content: string): string {
  return content
    .replace(/[^\t\n\r\u0020-\uD7FF\uE000-\uFFFD\u{10000}-\u{10FFFF}]/gu, '')
    .replace(/[&<>]/g, (character) => ENTITIES[character]!);
}

/** Kinds of chunks of an XDF file. Source: the specification "XDF 1.0", https://github.com/sccn/xdf/wiki/Specifications */
const TAG = {
  fileHeader: 1,
  streamHeader: 2,
  samples: 3,
  clockOffset: 4,
  streamFooter: 6,
} as const;

/** Timestamps are doubles of 8 bytes. */
const TIME_BYTES = 8;

const text = new TextEncoder();

/** One sample: its time in seconds, and its values: numbers of a stream of `double64`, else texts. */
export interface Sample {
  readonly time: number;
  readonly values: readonly (number | string)[];
}

/** Beginning of the file. */
export function fileHeader(): Uint8Array {
  const header = chunk(
    TAG.fileHeader,
    text.encode('<?xml version="1.0"?><info><version>1.0</version></info>'),
  );
  return concat([text.encode('XDF:'), header]);
}

export function streamHeader(stream: number, xml: string): Uint8Array {
  return chunk(TAG.streamHeader, concat([uint32(stream), text.encode(xml)]));
}

export function streamFooter(stream: number, xml: string): Uint8Array {
  return chunk(TAG.streamFooter, concat([uint32(stream), text.encode(xml)]));
}

/** @param time of the measurement, seconds @param offset is added to the times of the stream, seconds */
export function clockOffset(stream: number, time: number, offset: number): Uint8Array {
  return chunk(TAG.clockOffset, concat([uint32(stream), float64(time), float64(offset)]));
}

export function samples(stream: number, list: readonly Sample[]): Uint8Array {
  const parts: Uint8Array[] = [uint32(stream), variableLength(list.length)];
  for (const { time, values } of list) {
    parts.push(Uint8Array.of(TIME_BYTES), float64(time), ...values.map(valueBytes));
  }
  return chunk(TAG.samples, concat(parts));
}

function valueBytes(value: number | string): Uint8Array {
  if (typeof value === 'number') return float64(value);
  const bytes = text.encode(value);
  return concat([variableLength(bytes.byteLength), bytes]);
}

/** Length, tag, content; the length counts the two bytes of the tag. */
function chunk(tag: number, content: Uint8Array): Uint8Array {
  return concat([
    variableLength(content.byteLength + 2),
    Uint8Array.of(tag & 0xff, tag >> 8),
    content,
  ]);
}

/** A number with the number of its bytes before it: 1, 4 or 8, little-endian. */
function variableLength(value: number): Uint8Array {
  if (value < 0x100) return Uint8Array.of(1, value);
  if (value < 0x1_0000_0000) return concat([Uint8Array.of(4), uint32(value)]);
  const bytes = new Uint8Array(9);
  bytes[0] = 8;
  new DataView(bytes.buffer).setBigUint64(1, BigInt(value), true);
  return bytes;
}

function uint32(value: number): Uint8Array {
  const bytes = new Uint8Array(4);
  new DataView(bytes.buffer).setUint32(0, value, true);
  return bytes;
}

function float64(value: number): Uint8Array {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, value, true);
  return bytes;
}

function concat(parts: readonly Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((sum, { byteLength }) => sum + byteLength, 0));
  let offset = 0;
  for (const part of parts) {
    whole.set(part, offset);
    offset += part.byteLength;
  }
  return whole;
}
