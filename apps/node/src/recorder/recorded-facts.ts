import type { EncodedRecord, UbiiClient } from '@ubii/client-web/node';
import type { RecordingEvent } from '@ubii/recording';
import { clientEvent, eventOf, sessionEvent } from '@ubii/recording/recorder';

/** Topics on which the master tells of clients and sessions. */
const NEWS = ['/ubii/client/**', '/info/session/**'];

/** Clients and sessions as they are, for the beginning of a recording. [RC-12] */
export async function presentFacts(client: UbiiClient): Promise<RecordingEvent[]> {
  const [clients, sessions] = await Promise.all([
    client.call('clientGetList'),
    client.call('sessionRuntimeGetList'),
  ]);
  const nowMs = client.masterTime.nowMs();
  return [
    ...clients.elements.map((one) => clientEvent(one, nowMs)),
    ...sessions.elements.map((one) => sessionEvent(one, nowMs)),
  ];
}

/** Tells of clients and sessions that change. @returns ends it */
export function followFacts(
  client: UbiiClient,
  onEvent: (event: RecordingEvent) => void,
): () => void {
  const onRecord = ({ bytes }: EncodedRecord): void => {
    const event = eventOf(bytes, client.masterTime.nowMs());
    if (event !== undefined) onEvent(event);
  };
  const listener = { onRecord, onGone: () => undefined };
  const ends = NEWS.map((glob) => client.subscribeEncoded({ glob }, listener));
  return () => {
    for (const end of ends) end();
  };
}
