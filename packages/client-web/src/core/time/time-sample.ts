import { wallAheadMs } from './clock-reading.ts';
import type { ClockReading } from './clock-reading.ts';

/** One PING and its PONG, by both clocks: the four timestamps of NTP. [TS-2] */
export interface TimeExchange {
  readonly sent: ClockReading;
  readonly received: ClockReading;
  /** When the master had the PING, and when it sent the PONG: epoch milliseconds, master's clock. */
  readonly masterReceivedMs: number;
  readonly masterSentMs: number;
}

/** Result of one exchange. */
export interface TimeSample {
  /** The middle of the exchange: monotonic milliseconds. */
  readonly atMs: number;
  /** Master's clock minus the monotonic clock, milliseconds, had both ways taken the same time. */
  readonly offsetMs: number;
  /** Half the round trip and the grain of both clocks: the true offset is no further away. */
  readonly boundMs: number;
}

/** Less than this may lie between the clocks in one exchange: a grain of each, and a correction under way. */
const SAME_PACE_MS = 10;

/**
 * @param grainMs of both clocks together
 * @returns undefined for an exchange that says nothing: the machine slept or its clock was set meanwhile, or times run backwards
 */
export function sampleOf(exchange: TimeExchange, grainMs: number): TimeSample | undefined {
  const { sent, received, masterReceivedMs, masterSentMs } = exchange;
  const awayMs = received.monotonicMs - sent.monotonicMs;
  const insideMs = masterSentMs - masterReceivedMs;
  const isUsable =
    Number.isFinite(masterReceivedMs + masterSentMs) &&
    Math.abs(wallAheadMs(sent, received)) <= SAME_PACE_MS && // [TS-7]
    awayMs >= 0 &&
    insideMs >= 0 &&
    insideMs <= awayMs + grainMs;
  if (!isUsable) return undefined;
  return {
    atMs: (sent.monotonicMs + received.monotonicMs) / 2,
    offsetMs: (masterReceivedMs - sent.monotonicMs + masterSentMs - received.monotonicMs) / 2,
    boundMs: Math.max(0, awayMs - insideMs) / 2 + grainMs,
  };
}
