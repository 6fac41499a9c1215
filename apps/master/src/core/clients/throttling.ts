import { StatusEventKind } from '@ubii/proto';
import { TokenBucket, type Clock } from '@ubii/timing';
import type { EventLog } from '../counters/event-log.ts';
import type { Client } from './client.ts';
import { describeThrottle, type Throttle } from '../counters/throttle.ts';

/** Dependencies of throttling. */
export interface ThrottlingContext {
  readonly clock: Clock;
  readonly events: EventLog;
}

/** Limits what a client publishes; another throttle takes the place of the one before [EX-31]. */
export function throttleClient(
  { clock, events }: ThrottlingContext,
  client: Client,
  wish: Pick<Throttle, 'recordsPerSecond' | 'byPolicy' | 'byName' | 'reason'>,
): void {
  const { recordsPerSecond } = wish;
  const sinceMs = clock.nowMs();
  const dropped = client.throttle?.dropped ?? 0;
  const nowMs = clock.monotonicMs();
  client.throttle = { ...wish, sinceMs, dropped };
  // A rate below one still lets a record pass, after a while.
  client.recordBudget = new TokenBucket(recordsPerSecond, nowMs, Math.max(1, recordsPerSecond));
  const text = describeThrottle(client.throttle);
  events.add(StatusEventKind.CLIENT_THROTTLED, `${client.label} is ${text}`, client.id);
  client.socket?.sendError(
    'resource_exhausted',
    `This client is ${text}. Records above this rate are dropped.`,
  ); // [EX-33]
}

/** Lets a client publish as much as others. Does nothing when it may. */
export function unthrottleClient(
  { clock, events }: ThrottlingContext,
  client: Client,
  byName: string,
): void {
  if (client.throttle === undefined) return;
  client.endThrottle(clock.monotonicMs());
  const who = byName === '' ? '' : `, says ${byName}`;
  const text = `${client.label} is no longer throttled${who}`;
  events.add(StatusEventKind.CLIENT_THROTTLED, text, client.id);
}
