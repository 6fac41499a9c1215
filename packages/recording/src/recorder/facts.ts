import {
  ClientState,
  ComponentIOType,
  decodeRecord,
  INFO_TOPICS,
  SessionState,
  toJson,
  type Client,
  type ClientClock,
  type Component,
  type Device,
  type Session,
} from '@ubii/proto';
import type { RecordedComponent, RecordingEvent } from '../records/recording-event.ts';
import { nsOf } from '../records/recorded-record.ts';

const CLIENT_STATES: Readonly<Record<number, string>> = {
  [ClientState.ACTIVE]: 'active',
  [ClientState.INACTIVE]: 'inactive',
  [ClientState.UNAVAILABLE]: 'unavailable',
};

/** Words for the states of sessions, such as `running` for `SESSION_RUNNING`. */
const SESSION_STATES: ReadonlyMap<number, string> = new Map(
  Object.entries(SessionState).map(([name, value]) => [
    value,
    name.replace('SESSION_', '').toLowerCase(),
  ]),
);

/** The event of a record of the master about a client, a device or a session; undefined for other records. [RC-12] */
export function eventOf(
  topic: string,
  record: Uint8Array,
  timeMs: number,
): RecordingEvent | undefined {
  const { format, value } = decodeRecord(record);
  if (format === 'client') return clientEvent(value, timeMs);
  if (format === 'device') return deviceEvent(value, timeMs, topic !== INFO_TOPICS.deleteDevice);
  return format === 'session' ? sessionEvent(value, timeMs) : undefined;
}

/** A client as it is. */
export function clientEvent(
  { id, name, tags, state }: Pick<Client, 'id' | 'name' | 'tags' | 'state'>,
  timeMs: number,
): RecordingEvent {
  const value = { id, name, tags, state: CLIENT_STATES[state] ?? '' };
  return { kind: 'client', timeNs: nsOf(timeMs), value };
}

/** A device with its components, registered or gone. */
export function deviceEvent(
  { id, clientId, name, tags, components }: Device,
  timeMs: number,
  isRegistered: boolean,
): RecordingEvent {
  const state = isRegistered ? 'registered' : 'deregistered';
  const value = { id, clientId, name, tags, state, components: components.map(recordedComponent) };
  return { kind: 'device', timeNs: nsOf(timeMs), value };
}

function recordedComponent({ id, name, topic, messageFormat, ioType, tags }: Component) {
  const direction = ioType === ComponentIOType.SUBSCRIBER ? 'subscriber' : 'publisher';
  return { id, name, topic, format: messageFormat, direction, tags } satisfies RecordedComponent;
}

/** A session as it is, with the code of its modules. */
export function sessionEvent(message: Session, timeMs: number): RecordingEvent {
  const { id, name, extension } = message;
  const state = SESSION_STATES.get(extension?.state ?? 0) ?? '';
  const session = JSON.stringify(toJson('ubii.sessions.Session', message));
  return { kind: 'session', timeNs: nsOf(timeMs), value: { id, name, state, session } };
}

/** The clock of a client, as it reported it. [RC-14] */
export function clockEvent(
  clientId: string,
  { offsetMs, errorMs, driftPpm }: Pick<ClientClock, 'offsetMs' | 'errorMs' | 'driftPpm'>,
  timeMs: number,
): RecordingEvent {
  // A client reports how far the master is ahead; files say how far the client is.
  const value = { clientId, offsetMs: -offsetMs, errorMs, driftPpm };
  return { kind: 'clock', timeNs: nsOf(timeMs), value };
}

/** Records that are missing. [RC-19] @param reason one sentence */
export function gapEvent(
  fromMs: number,
  untilMs: number,
  records: number,
  reason: string,
): RecordingEvent {
  return { kind: 'gap', timeNs: nsOf(untilMs), value: { fromMs, untilMs, records, reason } };
}
