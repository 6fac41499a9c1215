import type { FlightRecorder } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
import { usePoll } from '../../connection/poll.ts';
import { refusalSentence, useAttempt } from '../../connection/useAttempt.ts';
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
  const { problem, attempt } = useAttempt({ sentenceOf: refusalSentence, keepsProblem: true });
  usePoll(
    async () => {
      const reply = await attempt(() => client.call('flightRecorderGet'));
      if (reply) flight.value = reply;
    },
    INTERVAL_MS,
    () => isConnected.value,
  );
  return { flight, problem };
}
