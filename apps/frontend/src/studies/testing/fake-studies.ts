import type { Study, StudyRun, StudyStatus } from '@ubii/proto';
import { fromJson } from '@ubii/proto';
import { computed, shallowRef, type ShallowRef } from 'vue';
import { vi } from 'vitest';
import type { Studies } from '../useStudies.ts';

/** Studies of a master for tests, with requests that are counted and replies that can be set. */
export function fakeStudies() {
  const news: ShallowRef<StudyStatus | undefined> = shallowRef();
  const studies = {
    list: shallowRef<readonly Study[]>([]),
    runs: shallowRef<readonly StudyRun[]>([]),
    status: computed(() => news.value),
    problem: shallowRef<string>(),
    isBusy: shallowRef(false),
    load: vi.fn<Studies['load']>(),
    save: vi.fn<Studies['save']>(),
    remove: vi.fn<Studies['remove']>(),
    check: vi.fn<Studies['check']>(),
    startRun: vi.fn<Studies['startRun']>(),
    changeRun: vi.fn<Studies['changeRun']>(),
    loadRun: vi.fn<Studies['loadRun']>(),
    participants: vi.fn<Studies['participants']>(),
    deleteParticipant: vi.fn<Studies['deleteParticipant']>(),
    mark: vi.fn<Studies['mark']>(),
  } satisfies Studies;
  return {
    studies,
    /** Publishes a status, as JSON of the schema. */
    publish(json: object): void {
      news.value = fromJson('ubii.extension.StudyStatus', json);
    },
  };
}
