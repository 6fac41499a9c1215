import type { Clock, UbiiClient } from '@ubii/client-web';
import { readJson } from '../read-json.ts';
import type { RoomView } from '../room-view.ts';
import { ROOM_TOPIC } from '../topics.ts';

/** A value that the master has comes right after the subscription. */
const WITHIN_MS = 500;

/** The room that another screen has led, with players; undefined when there is none. */
export async function roomOfBefore(
  client: UbiiClient,
  clock: Clock,
): Promise<RoomView | undefined> {
  const subscription = client.subscribe(ROOM_TOPIC, { format: 'string' });
  const text = await new Promise<string | undefined>((resolve) => {
    clock.after(WITHIN_MS, () => resolve(undefined));
    subscription.onRecord(({ value }) => resolve(value));
  });
  await subscription.close();
  const view = text === undefined ? undefined : readJson<RoomView>(text);
  const hasPlayers = Array.isArray(view?.room?.players) && view.room.players.length > 0;
  return hasPlayers ? (view as RoomView) : undefined;
}
