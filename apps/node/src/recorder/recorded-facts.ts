import type { EncodedRecord, UbiiClient } from '@ubii/client-web/node';
import { INFO_TOPICS } from '@ubii/proto';
import type { RecordingEvent } from '@ubii/recording';
import { clientEvent, deviceEvent, eventOf, sessionEvent } from '@ubii/recording/recorder';

/** Topics on which the master tells of clients, devices and sessions. */
const NEWS = [
  { glob: '/ubii/client/**' },
  { glob: '/info/session/**' },
  INFO_TOPICS.newDevice,
  INFO_TOPICS.deleteDevice,
];

/** Clients, devices and sessions as they are, for the beginning of a recording. [RC-12] */
export async function presentFacts(client: UbiiClient): Promise<RecordingEvent[]> {
  const [clients, devices, sessions] = await Promise.all([
    client.call('clientGetList'),
    client.call('deviceGetList'),
    client.call('sessionRuntimeGetList'),
  ]);
  const nowMs = client.masterTime.nowMs();
  return [
    ...clients.elements.map((one) => clientEvent(one, nowMs)),
    ...devices.elements.map((one) => deviceEvent(one, nowMs, true)),
    ...sessions.elements.map((one) => sessionEvent(one, nowMs)),
  ];
}

/** Tells of clients, devices and sessions that change. @returns ends it */
export function followFacts(
  client: UbiiClient,
  onEvent: (event: RecordingEvent) => void,
): () => void {
  const onRecord = ({ topic, bytes }: EncodedRecord): void => {
    const event = eventOf(topic, bytes, client.masterTime.nowMs());
    if (event !== undefined) onEvent(event);
  };
  const listener = { onRecord, onGone: () => undefined };
  const ends = NEWS.map((topics) => client.subscribeEncoded(topics, listener));
  return () => {
    for (const end of ends) end();
  };
}
