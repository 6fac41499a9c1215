import {
  ClientState,
  ComponentIOType,
  decodeRecord,
  INFO_TOPICS,
  toJson,
  type Client as ClientMessage,
  type Component,
  type Device,
  type Session as SessionMessage,
} from '@ubii/proto';
import type { RecordedComponent, RecordingEvent } from '@ubii/recording';
import { nsOf } from '../recorder/nanoseconds.ts';
import type { Client } from '../clients/client.ts';
import type { Session } from '../sessions/session.ts';
import { SESSION_LIVES } from '../sessions/session-states.ts';

/** States of devices. */
const REGISTERED = 'registered';
const GONE = 'deregistered';

const STATES: Readonly<Record<number, string>> = {
  [ClientState.ACTIVE]: 'active',
  [ClientState.INACTIVE]: 'inactive',
  [ClientState.UNAVAILABLE]: 'unavailable',
};

/** What a record of the master tells of a client, a device or a session; undefined for other records. [RC-12] */
export function eventOf(
  topic: string,
  record: Uint8Array,
  timeMs: number,
): RecordingEvent | undefined {
  const { format, value } = decodeRecord(record);
  if (format === 'client') return clientEvent(value, timeMs);
  if (format === 'device') {
    return deviceEvent(value, timeMs, topic === INFO_TOPICS.deleteDevice ? GONE : REGISTERED);
  }
  return format === 'session' ? sessionEvent(value, timeMs) : undefined;
}

/** Clients, devices and sessions as they are. */
export function presentEvents(
  clients: Iterable<Client>,
  devices: readonly Device[],
  sessions: Iterable<Session>,
  timeMs: number,
): RecordingEvent[] {
  return [
    ...[...clients].map((client) => clientEvent(client.toMessage(), timeMs)),
    ...devices.map((device) => deviceEvent(device, timeMs, REGISTERED)),
    ...[...sessions].map((session) => sessionEvent(session.toMessage(), timeMs)),
  ];
}

/** The clock of a client, as it reported it. [RC-14] */
export function clockEvent({ id, clock }: Client, timeMs: number): RecordingEvent | undefined {
  if (clock === undefined) return undefined;
  const { offsetMs, errorMs, driftPpm } = clock;
  // A client reports how far the master is ahead; files say how far the client is.
  const value = { clientId: id, offsetMs: -offsetMs, errorMs, driftPpm };
  return { kind: 'clock', timeNs: nsOf(timeMs), value };
}

/** Records that are missing. [RC-19] */
export function gapEvent(fromMs: number, untilMs: number, records: number): RecordingEvent {
  const reason = 'The recorder could not take records as fast as they came.';
  return { kind: 'gap', timeNs: nsOf(untilMs), value: { fromMs, untilMs, records, reason } };
}

function clientEvent(
  { id, name, tags, state }: Pick<ClientMessage, 'id' | 'name' | 'tags' | 'state'>,
  timeMs: number,
): RecordingEvent {
  const value = { id, name, tags, state: STATES[state] ?? '' };
  return { kind: 'client', timeNs: nsOf(timeMs), value };
}

function deviceEvent(
  { id, clientId, name, tags, components }: Device,
  timeMs: number,
  state: string,
): RecordingEvent {
  const value = { id, clientId, name, tags, state, components: components.map(recordedComponent) };
  return { kind: 'device', timeNs: nsOf(timeMs), value };
}

function recordedComponent({ id, name, topic, messageFormat, ioType, tags }: Component) {
  const direction = ioType === ComponentIOType.SUBSCRIBER ? 'subscriber' : 'publisher';
  return { id, name, topic, format: messageFormat, direction, tags } satisfies RecordedComponent;
}

function sessionEvent(message: SessionMessage, timeMs: number): RecordingEvent {
  const { id, name, extension } = message;
  const state = SESSION_LIVES[extension?.state ?? 0] ?? '';
  const session = JSON.stringify(toJson('ubii.sessions.Session', message));
  return { kind: 'session', timeNs: nsOf(timeMs), value: { id, name, state, session } };
}
