import type { Image2D, TopicRecord } from '@ubii/proto';

/** Returns the picture of a record; of a list of pictures, the first. */
export function imageOf(record: TopicRecord | undefined): Image2D | undefined {
  if (record?.format === 'image2D') return record.value;
  return record?.format === 'image2DList' ? record.value.elements[0] : undefined;
}
