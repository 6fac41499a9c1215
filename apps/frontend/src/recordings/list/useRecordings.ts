import {
  RECORDING_STATUS_TOPIC,
  type FlightRecorder,
  type Init,
  type Recording,
  type RecordingList,
  type RecordingMarker,
  type RecordingStartRequest,
  type RecordingStatus,
} from '@ubii/proto';
import {
  computed,
  provide,
  shallowRef,
  watch,
  type ComputedRef,
  type InjectionKey,
  type ShallowRef,
} from 'vue';
import { injectOrThrow } from '../../context/inject-or-throw.ts';
import { useTopic } from '../../connection/live/useTopic.ts';
import { useAttempt } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useMayRecord } from '../rights/useMayRecord.ts';
import { uploadRecording } from './upload-recording.ts';

/** The recordings of the master, and what people do with them. */
export interface Recordings {
  /** Undefined until they are known. */
  readonly list: Readonly<ShallowRef<RecordingList | undefined>>;
  /** The newest first, with what runs as it is now. */
  readonly all: ComputedRef<readonly Recording[]>;
  readonly status: ComputedRef<RecordingStatus | undefined>;
  /** Why the last request failed, one sentence. */
  readonly problem: ShallowRef<string | undefined>;
  readonly isBusy: Readonly<ShallowRef<boolean>>;
  find(id: string): Recording | undefined;
  /** @returns undefined when it failed, as the others */
  start(request: Init<RecordingStartRequest>): Promise<Recording | undefined>;
  stop(id: string): Promise<Recording | undefined>;
  /** Changes name and notes. */
  describe(id: string, name: string, notes: string): Promise<Recording | undefined>;
  /** @returns whether it is deleted */
  remove(id: string): Promise<boolean>;
  mark(marker: Init<RecordingMarker>): Promise<RecordingMarker | undefined>;
  /** Asks the node that has it to upload it again. */
  fetch(id: string): Promise<Recording | undefined>;
  /** Gives a file of this device to the master. */
  upload(file: File): Promise<Recording | undefined>;
  setFlight(settings: FlightChoice): Promise<FlightRecorder | undefined>;
  refresh(): Promise<void>;
}

/** What people set of the flight recorder. */
export type FlightChoice = Pick<FlightRecorder, 'isOn' | 'minutes' | 'maxBytes' | 'withImages'>;

/** For viewers and players, who have no recordings. */
const NONE: RecordingList = { elements: [], sizeBytes: 0, maxBytes: 0, freeBytes: 0 };

const RECORDINGS: InjectionKey<Recordings> = Symbol('recordings');

export function useRecordings(): Recordings {
  return injectOrThrow(RECORDINGS, 'the page of recordings above it');
}

export function provideRecordings(): Recordings {
  const { client, isConnected } = useConnection();
  const list = shallowRef<RecordingList>();
  const { problem, isBusy, attempt } = useAttempt();
  const { newest } = useTopic(RECORDING_STATUS_TOPIC, { format: 'recordingStatus' });
  const status = computed(() => newest.value?.value);
  const all = computed(() => withRunning(list.value?.elements ?? [], status.value?.running ?? []));

  const mayRecord = useMayRecord();
  /** Those that started or ended, also of others. */
  const runningIds = computed(() => status.value?.running.map(({ id }) => id).join(' '));

  async function refresh(): Promise<void> {
    const next = mayRecord.value ? await attempt(() => client.call('recordingList')) : NONE;
    if (next) list.value = next;
  }
  watch(
    [isConnected, () => status.value?.listRevision, runningIds],
    ([connected]) => connected && void refresh(),
    { immediate: true },
  );
  async function changed<T>(work: () => Promise<T>): Promise<T | undefined> {
    const reply = await attempt(work);
    if (reply !== undefined) await refresh();
    return reply;
  }

  const recordings: Recordings = {
    list,
    all,
    status,
    problem,
    isBusy,
    refresh,
    find: (id) => all.value.find((one) => one.id === id),
    start: (request) =>
      changed(() => client.call('recordingStart', { ...request, clientId: client.id })),
    stop: (id) => changed(() => client.call('recordingStop', { id })),
    describe: (id, name, notes) =>
      changed(() => client.call('recordingChange', { id, name, notes })),
    remove: async (id) =>
      (await changed(async () => {
        await client.call('recordingDelete', { id });
        return true;
      })) === true,
    mark: (marker) =>
      changed(() => client.call('recordingMark', { ...marker, clientId: client.id })),
    fetch: (id) => changed(() => client.call('recordingUpload', { id })),
    upload: (file) => changed(() => uploadRecording(file, client)),
    setFlight: (settings) => attempt(() => client.call('flightRecorderSet', settings)),
  };
  provide(RECORDINGS, recordings);
  return recordings;
}

/** The list with those that run as they are now. The status is for everybody: it has recordings of others, and no notes. */
export function withRunning(
  list: readonly Recording[],
  running: readonly Recording[],
): readonly Recording[] {
  const now = new Map(running.map((one) => [one.id, one]));
  const known = ({ name, notes, study }: Recording) => ({ name, notes, study });
  return list.map((one) => ({ ...one, ...now.get(one.id), ...known(one) }));
}
