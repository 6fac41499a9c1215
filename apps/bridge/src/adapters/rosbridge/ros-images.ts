import { Image2DDataFormat } from '@ubii/proto';
import type { Image2D } from '@ubii/proto';
import type { RosMessage } from './ros-message.ts';

interface Encoding {
  readonly channels: number;
  readonly dataFormat: Image2DDataFormat;
  /** Red and blue change places. */
  readonly isSwapped?: boolean;
}

/** Encodings of `sensor_msgs/Image` (sensor_msgs/image_encodings.hpp) that have a format of ours. */
const ENCODINGS: Readonly<Record<string, Encoding | undefined>> = {
  mono8: { channels: 1, dataFormat: Image2DDataFormat.GRAY8 },
  rgb8: { channels: 3, dataFormat: Image2DDataFormat.RGB8 },
  rgba8: { channels: 4, dataFormat: Image2DDataFormat.RGBA8 },
  bgr8: { channels: 3, dataFormat: Image2DDataFormat.RGB8, isSwapped: true },
  bgra8: { channels: 4, dataFormat: Image2DDataFormat.RGBA8, isSwapped: true },
};

/** Returns bytes, which JSON has in base64 and CBOR as they are. */
export function rosBytes(data: unknown): Uint8Array {
  if (data instanceof Uint8Array) return data;
  if (typeof data === 'string') return Buffer.from(data, 'base64');
  if (Array.isArray(data)) return Uint8Array.from(data as readonly number[]);
  throw new Error('Expected bytes in base64.');
}

/** Rows of ROS may have a gap at their end. */
export function fromRosImage({ width, height, encoding, step, data }: RosMessage): unknown {
  const known = ENCODINGS[String(encoding)];
  if (known === undefined) {
    throw new Error(`Pictures in ${String(encoding)} are not supported. Use rgb8, bgr8 or mono8.`);
  }
  const [columns, rows, rowBytes] = [Number(width), Number(height), Number(step)];
  const bytes = rosBytes(data);
  const length = columns * known.channels;
  if (
    !(
      columns > 0 &&
      rows > 0 &&
      rowBytes >= length &&
      bytes.length >= rowBytes * (rows - 1) + length
    )
  ) {
    throw new Error(
      `The picture has ${bytes.length} bytes, too few for ${String(width)} by ${String(height)}.`,
    );
  }
  const packed = new Uint8Array(length * rows);
  for (let row = 0; row < rows; row++) {
    packed.set(bytes.subarray(row * rowBytes, row * rowBytes + length), row * length);
  }
  if (known.isSwapped === true) {
    for (let at = 0; at < packed.length; at += known.channels) {
      const red = packed[at + 2]!;
      packed[at + 2] = packed[at]!;
      packed[at] = red;
    }
  }
  return { width: columns, height: rows, dataFormat: known.dataFormat, data: packed };
}

export function toRosImage(value: unknown): RosMessage {
  const { width, height, dataFormat, data } = value as Image2D;
  const found = Object.entries(ENCODINGS).find(([, known]) => known?.dataFormat === dataFormat);
  const [encoding, known] = found ?? [];
  if (known === undefined || data.length !== width * height * known.channels) {
    throw new Error('The picture is compressed. Use sensor_msgs/CompressedImage.');
  }
  return {
    height,
    width,
    encoding,
    is_bigendian: 0,
    step: width * known.channels,
    data: Buffer.from(data).toString('base64'),
  };
}
