// @vitest-environment happy-dom
import { flushPromises, mount } from '@vue/test-utils';
import { afterEach, expect, it } from 'vitest';
import { shallowRef } from 'vue';
import { CONNECTION } from '../../connection/connection.ts';
import { aRun, aStudy } from '../testing/a-study.ts';
import { fakeStudies } from '../testing/fake-studies.ts';
import { STUDIES } from '../useStudies.ts';
import RunPart from './RunPart.vue';

const wrappers: { unmount(): void }[] = [];
afterEach(() => wrappers.splice(0).forEach((wrapper) => wrapper.unmount()));

const open = (...ids: string[]) => ({
  runs: ids.map((runId) => ({ runId, studyId: 'study', revision: 1 })),
});

/** A device that shows the runs of a study, and follows them. */
function follow() {
  const { studies, publish } = fakeStudies();
  studies.loadRun.mockImplementation(async (id) => aRun([2], { id, state: ended.has(id) ? 3 : 1 }));
  const ended = new Set<string>();
  const wrapper = mount(RunPart, {
    props: { study: aStudy() },
    global: {
      stubs: { RunView: { props: ['run'], template: '<p>{{ run.id }}</p>' }, StartRun: true },
      provide: {
        [CONNECTION as symbol]: { isConnected: shallowRef(true) },
        [STUDIES as symbol]: studies,
      },
    },
  });
  wrappers.push(wrapper);
  return {
    /** @returns the run that is shown then */
    async news(status: object, ...endedRuns: string[]): Promise<string> {
      endedRuns.forEach((id) => ended.add(id));
      publish(status);
      await flushPromises();
      return wrapper.text();
    },
  };
}

it('the end of a run stays until another device starts the next one', async () => {
  const { news } = follow();
  expect(await news({ ...open('p1'), listRevision: 1 })).toBe('p1');
  expect(await news({ listRevision: 2 }, 'p1')).toBe('p1');
  expect(await news({ ...open('p2'), listRevision: 3 })).toBe('p2');
});

it('the run of another experimenter does not replace the end of this one', async () => {
  const { news } = follow();
  await news({ ...open('p1', 'p2'), listRevision: 1 });
  expect(await news({ ...open('p2'), listRevision: 2 }, 'p1')).toBe('p1');
  expect(await news({ ...open('p2', 'p3'), listRevision: 3 })).toBe('p3');
});
