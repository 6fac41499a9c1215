import type { Device } from '@ubii/proto';
import type { RecordingEvent } from '@ubii/recording';
import { clientEvent, deviceEvent, sessionEvent } from '@ubii/recording/recorder';
import type { Client } from '../clients/client.ts';
import type { Session } from '../sessions/session.ts';

/** Clients, devices and sessions as they are. */
export function presentEvents(
  clients: Iterable<Client>,
  devices: readonly Device[],
  sessions: Iterable<Session>,
  timeMs: number,
): RecordingEvent[] {
  return [
    ...[...clients].map((client) => clientEvent(client.toMessage(), timeMs)),
    ...devices.map((device) => deviceEvent(device, timeMs, true)),
    ...[...sessions].map((session) => sessionEvent(session.toMessage(), timeMs)),
  ];
}
