import { REPLAYS_TOPIC, type Replay } from '@ubii/proto';
import { shallowRef, watch, type ShallowRef } from 'vue';
import { useTopic } from './useTopic.ts';
import { useConnection } from '../useConnection.ts';

/** Recordings that the master plays into live topics now; none while disconnected. [RP-7] */
export function useReplays(): Readonly<ShallowRef<readonly Replay[]>> {
  const { isConnected } = useConnection();
  const replays = shallowRef<readonly Replay[]>([]);
  useTopic(REPLAYS_TOPIC, {
    format: 'replayList',
    keep: 0,
    onRecord: ({ value }) => (replays.value = value.elements),
  });
  watch(isConnected, () => (replays.value = []));
  return replays;
}
