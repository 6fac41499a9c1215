import type { MasterStatus, StatusEvent, StatusSample } from '@ubii/proto';
import { measureClock, type ClockOffset } from './clock-offset.ts';

/** Samples and events are shown this long, milliseconds; the master keeps them as long. [EX-17] */
export const HISTORY_MS = 10 * 60 * 1000;

/** What is known about the master: its newest status with the history put together. */
export interface MasterView {
  /** The newest reply; its samples and events are only what was new. */
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
 * Adds a reply to what is known. A master that was restarted starts over.
 * @param sentMs when the question left, and `receivedMs` when the reply came: this machine's clock,
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
 * Where to go on asking. One millisecond early, because an event may still follow in the millisecond
 * of the reply; `mergeMasterStatus` drops what comes twice.
 */
export function nextSinceMs(known: MasterView | undefined): number {
  return known === undefined ? 0 : known.latest.nowMs - 1;
}

/** The master's share of all processors of its machine now, percent; `undefined` before the first sample. */
export function cpuShare(view: MasterView | undefined): number | undefined {
  const sample = view?.samples.at(-1);
  return sample && sample.cpuPercent / Math.max(1, view!.latest.processors);
}

/** Records per second now; `undefined` before the first sample. */
export function recordsPerSecond(view: MasterView | undefined): number | undefined {
  return view?.samples.at(-1)?.recordsPerSecond;
}
