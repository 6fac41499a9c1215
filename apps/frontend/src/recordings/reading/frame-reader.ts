import type { RecordsReader } from '@ubii/recording';
import { imageOf } from '../../graph/preview/image-of.ts';
import { thumbnail } from '../../graph/preview/thumbnail.ts';
import { decodeRecorded } from './decode-recorded.ts';
import { TimeBase } from './recording-time-base.ts';

/** Reads a picture of the film strip, as high as it is drawn. */
export async function readFrame(
  reader: RecordsReader,
  topic: string,
  timeMs: number,
): Promise<ImageBitmap | undefined> {
  const timeNs = new TimeBase(reader.summary.startNs).toNs(timeMs);
  const recorded = (await reader.latestAt(timeNs, [topic])).get(topic);
  const record = recorded && decodeRecorded(topic, recorded.record);
  const image = imageOf(record);
  if (image === undefined) return undefined;
  try {
    const small = await thumbnail(image);
    return small && (await createImageBitmap(small));
  } catch {
    return undefined;
  }
}
