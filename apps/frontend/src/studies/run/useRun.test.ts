// @vitest-environment happy-dom
import { StudyRunAction } from '@ubii/proto';
import { flushPromises, mount } from '@vue/test-utils';
import { expect, it } from 'vitest';
import { defineComponent, h, shallowRef } from 'vue';
import { CONNECTION } from '../../connection/connection.ts';
import { aRun } from '../testing/a-study.ts';
import { fakeStudies } from '../testing/fake-studies.ts';
import { STUDIES } from '../useStudies.ts';
import { useRun, type LiveRun } from './useRun.ts';

function follow(id: string) {
  const { studies, publish } = fakeStudies();
  let live!: LiveRun;
  const component = defineComponent(() => {
    live = useRun(shallowRef<string | undefined>(id));
    return () => h('p');
  });
  const connection = { isConnected: shallowRef(true) };
  const provide = { [CONNECTION as symbol]: connection, [STUDIES as symbol]: studies };
  studies.loadRun.mockResolvedValue(aRun([0, 0]));
  mount(component, { global: { provide } });
  return { live, studies, publish };
}
const news = (revision: number) => ({ runs: [{ runId: 'run', studyId: 'study', revision }] });

it('a run is loaded again when another device has changed it, and only then', async () => {
  const { live, studies, publish } = follow('run');
  await flushPromises();
  expect(live.run.value?.revision).toBe(1);
  publish(news(1));
  await flushPromises();
  expect(studies.loadRun).toHaveBeenCalledTimes(1);
  studies.loadRun.mockResolvedValue(aRun([1, 0], { revision: 2 }));
  publish(news(2));
  await flushPromises();
  expect(live.run.value?.blocks[0]?.state).toBe(1);
});

it('an action shows its reply at once, and an older reply changes nothing', async () => {
  const { live, studies, publish } = follow('run');
  await flushPromises();
  studies.changeRun.mockResolvedValue(aRun([1, 0], { revision: 3 }));
  const action = StudyRunAction.STUDY_RUN_ACTION_BEGIN_BLOCK;
  expect(await live.act(action, { block: 1, isForced: true })).toBe(true);
  expect(studies.changeRun).toHaveBeenCalledWith({
    runId: 'run',
    action,
    block: 1,
    isForced: true,
  });
  studies.loadRun.mockResolvedValue(aRun([0, 0], { revision: 2 }));
  publish(news(4));
  await flushPromises();
  expect(live.run.value?.revision).toBe(3);
});

it('an action that the master refused leaves the run as it was', async () => {
  const { live, studies } = follow('run');
  await flushPromises();
  studies.changeRun.mockResolvedValue(undefined);
  expect(await live.act(StudyRunAction.STUDY_RUN_ACTION_END)).toBe(false);
  expect(live.run.value?.revision).toBe(1);
});
