import { ServiceError } from '@ubii/proto';
import type { KeptRecording, Recorder } from '@ubii/recording/recorder';
import type { Clock } from '@ubii/timing';

/** A recorder that failed starts again within this time, milliseconds. */
const PATIENCE_MS = 15_000;
const STEP_MS = 1_000;

/**
 * Waits until a recording can be read: a recorder that failed repairs its files when it starts again.
 *
 * @throws ServiceError when there is no such recording, or no recorder for too long; the reason of the signal
 */
export async function keptFile(
  recorder: Pick<Recorder, 'get'>,
  id: string,
  clock: Clock,
  signal: AbortSignal,
): Promise<KeptRecording> {
  const untilMs = clock.monotonicMs() + PATIENCE_MS;
  for (;;) {
    signal.throwIfAborted();
    try {
      return await recorder.get(id);
    } catch (cause) {
      const isAway = cause instanceof ServiceError && cause.code === 'unavailable';
      if (!isAway || clock.monotonicMs() >= untilMs) throw cause;
    }
    await new Promise<void>((resolve) => void clock.after(STEP_MS, resolve));
  }
}
