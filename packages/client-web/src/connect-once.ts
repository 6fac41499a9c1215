import type { Clock } from '@ubii/timing';
import { systemClock } from '@ubii/timing/system';
import type { UbiiClient } from './core/client/ubii-client.ts';

/**
 * Connects, and gives up when the first attempt fails: then the client is closed. From the first connection on, it
 * reconnects as usual.
 * @param clock that of the client
 * @throws {ConnectionError} of the first attempt
 */
export async function connectOnce(
  client: UbiiClient,
  clock: Pick<Clock, 'nowMs'> = systemClock,
): Promise<void> {
  let stop = (): void => undefined;
  const failed = new Promise<never>((_resolve, reject) => {
    stop = client.onState((state) => {
      // An attempt that follows without delay is part of the first: the reply of the master says how to register.
      if (state.status === 'reconnecting' && state.nextAttemptMs > clock.nowMs()) {
        reject(state.error);
      }
    });
  });
  try {
    await Promise.race([client.connect(), failed]);
  } catch (error) {
    void client.close().catch(() => undefined);
    throw error;
  } finally {
    stop();
  }
}
