import {
  STUDY_STATUS_TOPIC,
  type Init,
  type Study,
  type StudyDeletion,
  type StudyParticipant,
  type StudyRun,
  type StudyRunChangeRequest,
  type StudyRunStartRequest,
  type StudyStatus,
} from '@ubii/proto';
import {
  computed,
  provide,
  shallowRef,
  watch,
  type ComputedRef,
  type InjectionKey,
  type Ref,
  type ShallowRef,
} from 'vue';
import { injectOrThrow } from '../context/inject-or-throw.ts';
import { useTopic } from '../connection/live/useTopic.ts';
import { useAttempt } from '../connection/useAttempt.ts';
import { useConnection } from '../connection/useConnection.ts';
import { useRole } from '../connection/useRole.ts';

/** The studies of the master, and the requests about them. A failed request returns undefined and sets `problem`. */
export interface Studies {
  /** Without texts, by name; undefined until they are known. */
  readonly list: Readonly<ShallowRef<readonly Study[] | undefined>>;
  /** Runs of all studies, the newest first. */
  readonly runs: Readonly<ShallowRef<readonly StudyRun[]>>;
  /** Open runs and check lists. */
  readonly status: ComputedRef<StudyStatus | undefined>;
  /** Why the last action failed, or what the page loaded last. */
  readonly problem: Readonly<Ref<string | undefined>>;
  readonly isBusy: Readonly<ShallowRef<boolean>>;
  /** With its texts. */
  load(id: string): Promise<Study | undefined>;
  save(study: Init<Study>): Promise<Study | undefined>;
  /** @returns whether it is deleted */
  remove(id: string): Promise<boolean>;
  /** Asks for the check list on the topic of the status, for the next ten seconds. */
  check(studyId: string): Promise<void>;
  startRun(request: Init<StudyRunStartRequest>): Promise<StudyRun | undefined>;
  changeRun(request: Init<StudyRunChangeRequest>): Promise<StudyRun | undefined>;
  loadRun(id: string): Promise<StudyRun | undefined>;
  participants(studyId: string): Promise<readonly StudyParticipant[] | undefined>;
  /** In one study: the same code in another one may be another person. */
  deleteParticipant(studyId: string, code: string): Promise<StudyDeletion | undefined>;
  /** Adds a marker to a recording. @returns whether it was added */
  mark(recordingId: string, text: string): Promise<boolean>;
}

export const STUDIES: InjectionKey<Studies> = Symbol('studies');

export function useStudies(): Studies {
  return injectOrThrow(STUDIES, 'the page of studies above it');
}

export function provideStudies(): Studies {
  const { client, isConnected } = useConnection();
  const { isViewerOrPlayer } = useRole();
  const list = shallowRef<readonly Study[]>();
  const runs = shallowRef<readonly StudyRun[]>([]);
  const { problem, isBusy, attempt } = useAttempt();
  // What the page loads by itself leaves the reply to the last action.
  const loading = useAttempt();
  const { newest } = useTopic(STUDY_STATUS_TOPIC, { format: 'studyStatus' });
  const status = computed(() => newest.value?.value);

  async function refresh(): Promise<void> {
    const replies = await loading.attempt(() =>
      Promise.all([client.call('studyList'), client.call('studyRunList', {})]),
    );
    if (replies === undefined) return;
    list.value = replies[0].elements;
    runs.value = replies[1].elements;
  }
  watch(
    [isConnected, () => status.value?.listRevision],
    ([connected]) => connected && !isViewerOrPlayer.value && void refresh(),
    { immediate: true },
  );

  const studies: Studies = {
    list,
    runs,
    status,
    isBusy,
    problem: computed(() => problem.value ?? loading.problem.value),
    load: (id) => loading.attempt(() => client.call('studyGet', { id })),
    async save(study) {
      const saved = await attempt(() => client.call('studySave', study));
      if (saved) list.value = withStudy(list.value ?? [], saved);
      return saved;
    },
    remove: async (id) =>
      (await attempt(async () => {
        await client.call('studyDelete', { id });
        return true;
      })) === true,
    // It is repeated: a failure now is no news.
    check: (id) => client.call('studyCheck', { id }).then(ignore, ignore),
    startRun: (request) =>
      attempt(() => client.call('studyRunStart', { ...request, clientId: client.id })),
    changeRun: (request) =>
      attempt(() => client.call('studyRunChange', { ...request, clientId: client.id })),
    loadRun: (id) => loading.attempt(() => client.call('studyRunGet', { id })),
    participants: async (studyId) =>
      (await loading.attempt(() => client.call('studyParticipantList', { studyId })))?.elements,
    deleteParticipant: (studyId, participantCode) =>
      attempt(() => client.call('studyParticipantDelete', { studyId, participantCode })),
    mark: async (recordingId, text) =>
      (await attempt(() =>
        client.call('recordingMark', { recordingId, text, clientId: client.id }),
      )) !== undefined,
  };
  provide(STUDIES, studies);
  return studies;
}

/** The list with a study in it, by name, before the master has published that it changed. */
export function withStudy(list: readonly Study[], saved: Study): readonly Study[] {
  const others = list.filter(({ id }) => id !== saved.id);
  return [...others, saved].sort((a, b) => a.name.localeCompare(b.name, 'en'));
}

const ignore = (): void => undefined;
