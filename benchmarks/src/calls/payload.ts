import { decodeRecord, encodeRecord, Image2DDataFormat, type DataFormat } from '@ubii/proto';

/** Fixed, so that every record has the same length. */
const TIMESTAMP_MS = 1_750_000_000_000;
const WIDTH = 640;
const HEIGHT = 480;
const RGBA_BYTES = 4;
/** Bytes that do not occur elsewhere in the record, to find where the picture's data begins. */
const MARKER = new TextEncoder().encode('begin of picture');

/** Module code and record of a call, and the check of its result. */
export interface Payload {
  readonly title: string;
  /** Source text of a module with the input `in` and the output `out`. */
  readonly onProcessing: string;
  readonly outputFormat: DataFormat;
  /** A record of its own for call number `sequence`. */
  record(sequence: number): Uint8Array<ArrayBuffer>;
  /** The message of the same call for the bare worker. */
  bareMessage(record: Uint8Array<ArrayBuffer>): {
    message: unknown;
    transfer: ArrayBuffer[];
  };
  /** True when `answer` of the bare worker belongs to the call. */
  isBareAnswer(answer: unknown, sequence: number): boolean;
  /** True when the encoded output belongs to the call. */
  isOutput(bytes: Uint8Array, sequence: number): boolean;
}

const vectorOf = (sequence: number) => ({ x: sequence, y: Math.sin(sequence), z: -sequence });

function isVectorOf(bytes: unknown, sequence: number): boolean {
  if (!(bytes instanceof Uint8Array)) return false;
  const { value } = decodeRecord(bytes);
  const { x, y, z } = vectorOf(sequence);
  const { x: gotX, y: gotY, z: gotZ } = value as { x: number; y: number; z: number };
  return gotX === x && gotY === y && gotZ === z;
}

/** A small record: what goes in comes out. */
export const RECORD_PAYLOAD: Payload = {
  title: 'a vector in, the same vector out',
  onProcessing: '(deltaTime, inputs) => ({ outputs: { out: { vector3: inputs.in.vector3 } } })',
  outputFormat: 'vector3',
  record: (sequence) =>
    encodeRecord({
      topic: '/benchmark/call/in',
      format: 'vector3',
      value: vectorOf(sequence),
      timestampMs: TIMESTAMP_MS,
    }) as Uint8Array<ArrayBuffer>,
  bareMessage: (record) => ({ message: { record }, transfer: [] }),
  isBareAnswer: isVectorOf,
  isOutput: isVectorOf,
};

/** A picture, of which the module reads three bytes. */
export function picturePayload(): Payload {
  const length = WIDTH * HEIGHT * RGBA_BYTES;
  const data = new Uint8Array(length).map((_byte, index) => index * 31);
  data.set(MARKER);
  const template = encodeRecord({
    topic: '/benchmark/call/in',
    format: 'image2D',
    value: { width: WIDTH, height: HEIGHT, dataFormat: Image2DDataFormat.RGBA8, data },
    timestampMs: TIMESTAMP_MS,
  });
  const offset = template.findIndex((_byte, start) =>
    MARKER.every((byte, index) => template[start + index] === byte),
  );
  const places = [offset, offset + (length >> 1), offset + length - 1];
  const isNumberOf = (value: unknown, sequence: number): boolean => value === (sequence & 0xffffff);
  return {
    title: `a picture of ${WIDTH} x ${HEIGHT} RGBA in, a number made of three of its bytes out`,
    onProcessing: `(deltaTime, inputs) => {
      const { data } = inputs.in.image2D;
      const middle = data[data.length >> 1];
      return { outputs: { out: { double: data[0] + 256 * middle + 65536 * data[data.length - 1] } } };
    }`,
    outputFormat: 'double',
    record: (sequence) => {
      const record = template.slice() as Uint8Array<ArrayBuffer>;
      places.forEach((place, index) => (record[place] = sequence >> (8 * index)));
      return record;
    },
    bareMessage: (record) => ({
      message: { picture: { data: record, offset, length } },
      transfer: [record.buffer],
    }),
    isBareAnswer: isNumberOf,
    isOutput: (bytes, sequence) => isNumberOf(decodeRecord(bytes).value, sequence),
  };
}
