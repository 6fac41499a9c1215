import {
  ClusterMasterState,
  type MasterStatus,
  type StatusEvent,
  type StatusSample,
} from '@ubii/proto';
import { measureClock, type ClockOffset } from './clock-offset.ts';

/** Length of the history, milliseconds; the master keeps the same. [EX-17] */
export const HISTORY_MS = 10 * 60 * 1000;

/** Newest status of the master, with the accumulated history. */
export interface MasterView {
  /** Newest reply; its samples and events are only those since the previous one. */
  readonly latest: MasterStatus;
  /** Oldest first. */
  readonly samples: readonly StatusSample[];
  /** Oldest first. */
  readonly events: readonly StatusEvent[];
  readonly clock: ClockOffset;
}

const eventKey = ({ timeMs, kind, clientId, text }: StatusEvent): string =>
  `${timeMs} ${kind} ${clientId} ${text}`;

/**
 * Adds a reply to the history. After a restart of the master, the history starts over.
 * @param sentMs time of the request, and `receivedMs` time of the reply: this computer's clock,
 * epoch milliseconds
 */
export function mergeMasterStatus(
  known: MasterView | undefined,
  reply: MasterStatus,
  sentMs: number,
  receivedMs: number,
): MasterView {
  const isSame =
    known !== undefined &&
    known.latest.masterId === reply.masterId &&
    known.latest.startedMs === reply.startedMs;
  const from = reply.nowMs - HISTORY_MS;
  const samples = isSame ? known.samples.filter(({ timeMs }) => timeMs > from) : [];
  const events = isSame ? known.events.filter(({ timeMs }) => timeMs > from) : [];
  const newestSampleMs = samples.at(-1)?.timeMs ?? 0;
  const seen = new Set(events.map(eventKey));
  return {
    latest: reply,
    samples: [...samples, ...reply.samples.filter(({ timeMs }) => timeMs > newestSampleMs)],
    events: [...events, ...reply.events.filter((event) => !seen.has(eventKey(event)))],
    clock: measureClock(isSame ? known.clock : undefined, sentMs, receivedMs, reply.nowMs),
  };
}

/**
 * Start time for the next request. One millisecond early, because further events may have the same millisecond as the
 * reply; `mergeMasterStatus` drops duplicates.
 */
export function nextSinceMs(known: MasterView | undefined): number {
  return known === undefined ? 0 : known.latest.nowMs - 1;
}

/** CPU use of the master, percent of all processors of its computer; `undefined` before the first sample. */
export function cpuShare(view: MasterView | undefined): number | undefined {
  const sample = view?.samples.at(-1);
  return sample && sample.cpuPercent / Math.max(1, view!.latest.processors);
}

/** Number of connected clients, in a cluster at all masters that are there. */
export function countActive(latest: MasterStatus | undefined): number {
  if (latest === undefined) return 0;
  const { clientsActive, cluster } = latest;
  const others = cluster?.masters.filter(({ state }) => state === ClusterMasterState.PRESENT) ?? [];
  return others.reduce((sum, { clients }) => sum + clients, clientsActive);
}

/** Records per second now; `undefined` before the first sample. */
export function recordsPerSecond(view: MasterView | undefined): number | undefined {
  return view?.samples.at(-1)?.recordsPerSecond;
}
