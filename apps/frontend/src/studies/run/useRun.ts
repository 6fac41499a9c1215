import type {
  Init,
  StudyRun,
  StudyRunAction,
  StudyRunChangeRequest,
  StudyRunNews,
} from '@ubii/proto';
import { computed, shallowRef, watch, type ComputedRef, type Ref, type ShallowRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { useStudies } from '../useStudies.ts';

/** A run as it is now, also when another device leads it. */
export interface LiveRun {
  readonly run: Readonly<ShallowRef<StudyRun | undefined>>;
  /** The block that runs; undefined when the run is not open. */
  readonly news: ComputedRef<StudyRunNews | undefined>;
  /** @returns whether the master did it */
  act(
    action: StudyRunAction,
    details?: Omit<Init<StudyRunChangeRequest>, 'runId' | 'action'>,
  ): Promise<boolean>;
}

/** @param id of the run; undefined for none */
export function useRun(id: Readonly<Ref<string | undefined>>): LiveRun {
  const { isConnected } = useConnection();
  const studies = useStudies();
  const run = shallowRef<StudyRun>();
  const news = computed(() => studies.status.value?.runs.find(({ runId }) => runId === id.value));

  /** Replies can overtake each other: an older one is ignored. */
  function take(next: StudyRun | undefined): boolean {
    if (next === undefined || next.id !== id.value) return false;
    const isNewer = run.value?.id !== next.id || next.revision >= run.value.revision;
    if (isNewer) run.value = next;
    return true;
  }
  watch(
    [id, isConnected, () => news.value?.revision, () => studies.status.value?.listRevision],
    async ([runId, connected, revision]) => {
      if (runId === undefined) run.value = undefined;
      if (runId === undefined || !connected) return;
      if (run.value?.id === runId && run.value.revision === revision) return;
      take(await studies.loadRun(runId));
    },
    { immediate: true },
  );
  return {
    run,
    news,
    async act(action, details = {}) {
      if (id.value === undefined) return false;
      return take(await studies.changeRun({ ...details, runId: id.value, action }));
    },
  };
}
