import type { UbiiClient } from '@ubii/client-web';
import type { RecordingTopic } from '@ubii/proto';

/** Reads all topics of a recording, page by page. [RC-54] */
export async function readTopics(
  client: Pick<UbiiClient, 'call'>,
  id: string,
): Promise<RecordingTopic[]> {
  const all: RecordingTopic[] = [];
  for (;;) {
    const { topics, topicsTotal } = await client.call('recordingGet', {
      id,
      topicsFrom: all.length,
    });
    all.push(...topics);
    if (topics.length === 0 || all.length >= topicsTotal) return all;
  }
}
