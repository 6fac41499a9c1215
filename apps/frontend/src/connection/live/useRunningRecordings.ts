import { RECORDING_STATUS_TOPIC, type Recording } from '@ubii/proto';
import { shallowRef, watch, type ShallowRef } from 'vue';
import { useTopic } from './useTopic.ts';
import { useConnection } from '../useConnection.ts';

/** Recordings that run now; none while disconnected. [RC-8] */
export function useRunningRecordings(): Readonly<ShallowRef<readonly Recording[]>> {
  const { isConnected } = useConnection();
  const running = shallowRef<readonly Recording[]>([]);
  useTopic(RECORDING_STATUS_TOPIC, {
    format: 'recordingStatus',
    keep: 0,
    onRecord: ({ value }) => (running.value = value.running),
  });
  watch(isConnected, () => (running.value = []));
  return running;
}
