import { ConnectionError } from '@ubii/client-web';
import { ServiceError, type FlightRecorder } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
import { usePoll } from '../../connection/poll.ts';
import { useConnection } from '../../connection/useConnection.ts';

/** The flight recorder as the master describes it, asked for while the page is seen. */
export interface FlightRecorderView {
  readonly flight: ShallowRef<FlightRecorder | undefined>;
  /** Why it is not known, one sentence. */
  readonly problem: Readonly<ShallowRef<string | undefined>>;
}

const INTERVAL_MS = 2000;

export function useFlightRecorder(): FlightRecorderView {
  const { client, isConnected } = useConnection();
  const flight = shallowRef<FlightRecorder>();
  const problem = shallowRef<string>();
  usePoll(
    async () => {
      try {
        flight.value = await client.call('flightRecorderGet');
        problem.value = undefined;
      } catch (cause) {
        if (cause instanceof ConnectionError) return;
        if (!(cause instanceof ServiceError)) throw cause;
        problem.value = cause.message;
      }
    },
    INTERVAL_MS,
    () => isConnected.value,
  );
  return { flight, problem };
}
