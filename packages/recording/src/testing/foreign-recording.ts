import { McapWriter } from '@mcap/core';
import { MemoryFile } from './memory-file.ts';
import { SAMPLE_START_NS } from './sample-records.ts';

const at = (ms: number): bigint => SAMPLE_START_NS + BigInt(ms) * 1_000_000n;

/** Size of the picture that is attached to `foreignRecording`. */
export const FOREIGN_PICTURE_BYTES = 3 * 1024 * 1024;

/**
 * A file of another program: messages of `/plain` at 0 and 20 ms; attached are a picture at 10 ms, a note at 20 ms and a
 * calibration without time; two metadata records.
 */
export async function foreignRecording(): Promise<MemoryFile> {
  const file = new MemoryFile();
  const writer = new McapWriter({ writable: file });
  await writer.start({ profile: 'ros2', library: 'other' });
  const schemaId = 0;
  const channelId = await writer.registerChannel({
    schemaId,
    topic: '/plain',
    messageEncoding: 'json',
    metadata: new Map(),
  });
  const attach = (name: string, logTime: bigint, mediaType: string, data: Uint8Array) =>
    writer.addAttachment({ name, logTime, createTime: logTime + 3n, mediaType, data });
  const message = (ms: number) =>
    writer.addMessage({
      channelId,
      sequence: 0,
      data: Uint8Array.of(ms),
      logTime: at(ms),
      publishTime: at(ms),
    });
  await attach('calibration.yaml', 0n, '', Uint8Array.of(1));
  await message(0);
  const picture = Uint8Array.from({ length: FOREIGN_PICTURE_BYTES }, (_, i) => (i * 7) % 251);
  await attach('frame.png', at(10), 'image/png', picture);
  await message(20);
  await attach('note.txt', at(20), 'text/plain', Uint8Array.of(2));
  await writer.addMetadata({ name: 'car', metadata: new Map([['plate', 'M-AX 1']]) });
  await writer.addMetadata({ name: 'car', metadata: new Map([['plate', 'M-AX 2']]) });
  await writer.end();
  return file;
}
