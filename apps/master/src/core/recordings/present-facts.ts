import {
  ClientState,
  decodeRecord,
  toJson,
  type Client as ClientMessage,
  type Session as SessionMessage,
} from '@ubii/proto';
import type { RecordingEvent } from '@ubii/recording';
import { nsOf } from '../recorder/nanoseconds.ts';
import type { Client } from '../clients/client.ts';
import type { Session } from '../sessions/session.ts';
import { SESSION_LIVES } from '../sessions/session-states.ts';

const STATES: Readonly<Record<number, string>> = {
  [ClientState.ACTIVE]: 'active',
  [ClientState.INACTIVE]: 'inactive',
  [ClientState.UNAVAILABLE]: 'unavailable',
};

/** What a record of the master tells of a client or a session; undefined for other records. [RC-12] */
export function eventOf(record: Uint8Array, timeMs: number): RecordingEvent | undefined {
  const { format, value } = decodeRecord(record);
  if (format === 'client') return clientEvent(value, timeMs);
  return format === 'session' ? sessionEvent(value, timeMs) : undefined;
}

/** Clients and sessions as they are. */
export function presentEvents(
  clients: Iterable<Client>,
  sessions: Iterable<Session>,
  timeMs: number,
): RecordingEvent[] {
  return [
    ...[...clients].map((client) => clientEvent(client.toMessage(), timeMs)),
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

function sessionEvent(message: SessionMessage, timeMs: number): RecordingEvent {
  const { id, name, extension } = message;
  const state = SESSION_LIVES[extension?.state ?? 0] ?? '';
  const session = JSON.stringify(toJson('ubii.sessions.Session', message));
  return { kind: 'session', timeNs: nsOf(timeMs), value: { id, name, state, session } };
}
