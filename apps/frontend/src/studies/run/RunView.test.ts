// @vitest-environment happy-dom
import { StudyRunAction, type StudyRun } from '@ubii/proto';
import { flushPromises, mount } from '@vue/test-utils';
import { afterAll, afterEach, describe, expect, it, vi } from 'vitest';
import { computed, shallowRef } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import { CONNECTION } from '../../connection/connection.ts';
import { createShell, SHELL } from '../../page/shell.ts';
import { createToasts, provideToasts } from '../../ui/toasts/toasts.ts';
import { aRun, aStudy } from '../testing/a-study.ts';
import { fakeStudies } from '../testing/fake-studies.ts';
import { STUDIES } from '../useStudies.ts';
import RunView from './RunView.vue';

// Test files share modules: reset them before and after mocking.
vi.hoisted(() => vi.resetModules());
afterAll(() => void vi.resetModules());
vi.mock('../../connection/live/useTopic.ts', () => ({
  useTopic: () => ({ newest: { value: undefined } }),
}));

const wrappers: { unmount(): void }[] = [];
afterEach(() => wrappers.splice(0).forEach((wrapper) => wrapper.unmount()));

function show(run: StudyRun, status: object, study: object = {}) {
  const { studies, publish } = fakeStudies();
  publish(status);
  const act = vi.fn(async () => true);
  const connection = {
    isConnected: shallowRef(true),
    client: { id: 'me' },
    state: shallowRef({ status: 'connected' }),
  };
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [{ path: '/:path(.*)*', component: { template: '<p />' } }],
  });
  const live = {
    run: shallowRef(run),
    news: computed(() => studies.status.value?.runs[0]),
    act,
  };
  const wrapper = mount(RunView, {
    attachTo: document.body,
    props: { study: aStudy(study), run, live },
    global: {
      plugins: [router, { install: (app) => provideToasts(app, createToasts()) }],
      provide: {
        [CONNECTION as symbol]: connection,
        [STUDIES as symbol]: studies,
        [SHELL as symbol]: createShell(),
      },
    },
  });
  wrappers.push(wrapper);
  const button = (text: string, within: ParentNode = document.body): HTMLButtonElement =>
    [...within.querySelectorAll('button')].find((one) => one.textContent?.trim() === text)!;
  return { wrapper, studies, act, button };
}
const ready = { checkLists: [{ studyId: 'study', isReady: true }] };
const missing = {
  checkLists: [
    {
      studyId: 'study',
      rows: [{ name: 'Phone', state: 1, items: [{ kind: 0, state: 1, text: '0 of 1' }] }],
    },
  ],
};
const running = {
  runs: [{ runId: 'run', studyId: 'study', block: 1, recordingId: 'rec', elapsedMs: 65_000 }],
};

describe('a run', () => {
  it('names the block that was interrupted by a restart of the master, also when no other is left', () => {
    const { wrapper } = show(aRun([2, 4], { state: 2 }), ready);
    expect(wrapper.text()).toContain('Block 2 was interrupted');
    expect(wrapper.text()).toContain('Continue the run.');
    expect(wrapper.text()).not.toContain('All blocks are done');
  });

  it('begins its next block at once when all devices are ready', async () => {
    const { act, button } = show(aRun([2, 0]), ready);
    button('Start').click();
    await flushPromises();
    expect(act).toHaveBeenCalledWith(StudyRunAction.STUDY_RUN_ACTION_BEGIN_BLOCK, { block: 2 });
  });

  it('asks before a block begins without a device, and says what is missing', async () => {
    const { wrapper, act, button } = show(aRun([0, 0]), missing);
    expect(wrapper.find('[role=status]').text()).toBe('Not ready: Phone (missing).');
    button('Start').click();
    await flushPromises();
    expect(act).not.toHaveBeenCalled();
    const dialog = document.querySelector('[role=dialog]')!;
    expect(dialog.textContent).toContain('Phone, missing');
    button('Start anyway', dialog).click();
    await flushPromises();
    expect(act).toHaveBeenCalledWith(StudyRunAction.STUDY_RUN_ACTION_BEGIN_BLOCK, {
      block: 1,
      isForced: true,
    });
  });

  it('shows the consent text first, and confirms its version after the box is ticked', async () => {
    const study = { consentText: 'You tap.', consentVersion: 3 };
    const { act, button } = show(aRun([0]), ready, study);
    button('Show the consent text').click();
    await flushPromises();
    const dialog = document.querySelector('[role=dialog]')!;
    expect(dialog.textContent).toContain('You tap.');
    button('I agree', dialog).click();
    expect(act).not.toHaveBeenCalled();
    dialog.querySelector('input')!.click();
    await flushPromises();
    button('I agree', dialog).click();
    await flushPromises();
    expect(act).toHaveBeenCalledWith(StudyRunAction.STUDY_RUN_ACTION_CONSENT, {
      consentVersion: 3,
    });
  });

  it('marks the recording of its block with a label, and stops it', async () => {
    const { wrapper, studies, act, button } = show(aRun([1, 0]), running);
    studies.mark.mockResolvedValue(true);
    expect(wrapper.find('[role=timer]').text()).toBe('1:05');
    button('Error').click();
    await flushPromises();
    expect(studies.mark.mock.calls).toEqual([['rec', 'Error']]);
    button('Stop').click();
    expect(act).toHaveBeenCalledWith(StudyRunAction.STUDY_RUN_ACTION_END_BLOCK);
  });

  it('offers an interrupted block before the end of the run', async () => {
    const { wrapper, act, button } = show(aRun([2, 4]), ready);
    expect(wrapper.find('.now').text()).toContain('Block 2 was interrupted');
    button('Repeat block 2').click();
    await flushPromises();
    expect(act).toHaveBeenCalledWith(StudyRunAction.STUDY_RUN_ACTION_REPEAT_BLOCK, { block: 2 });
  });

  it('keeps the focus on its button, and ignores a press that was meant for the action before', async () => {
    vi.useFakeTimers();
    const { wrapper, act, button } = show(aRun([0]), ready);
    const main = button('Start');
    main.focus();
    await wrapper.setProps({ run: aRun([1]) });
    expect(document.activeElement).toBe(button('Stop'));
    button('Stop').click();
    expect(act).not.toHaveBeenCalled();
    await vi.advanceTimersByTimeAsync(500);
    button('Stop').click();
    expect(act).toHaveBeenCalledWith(StudyRunAction.STUDY_RUN_ACTION_END_BLOCK);
    vi.useRealTimers();
  });

  it('closes the consent text when the participant agreed on another device', async () => {
    const study = { consentText: 'You tap.', consentVersion: 1 };
    const { wrapper, button } = show(aRun([0]), ready, study);
    button('Show the consent text').click();
    await flushPromises();
    expect(document.querySelector('[role=dialog]')).not.toBeNull();
    await wrapper.setProps({ run: aRun([0], { consent: { version: 1, timeMs: 1 } }) });
    expect(document.querySelector('[role=dialog]')).toBeNull();
  });

  it('says how a block that is repeated can stay as it is, and changes none of an interrupted run', () => {
    const takes = [{ recordingId: 'rec', name: 'run-01', endedMs: 9 }];
    const blocks = [{ condition: 'Left', repetition: 1, state: 0, takes }];
    const labels = (run: StudyRun) =>
      [...show(run, ready).wrapper.element.querySelectorAll('.blocks li button')].map((one) =>
        one.getAttribute('aria-label'),
      );
    expect(labels(aRun([], { blocks }))).toEqual(['Keep block 1']);
    expect(labels(aRun([2, 4, 0], { state: 2 }))).toEqual([]);
  });

  it('that ended early does not say that the participant is done', () => {
    const { wrapper } = show(aRun([2, 0], { state: 3 }), ready);
    expect(wrapper.find('h3').text()).toContain('The run of P07 ended early.');
  });

  it('ends with the names of its files', () => {
    const takes = [{ recordingId: 'rec', name: 'sub-P07_run-01' }];
    const blocks = [{ condition: 'Left', repetition: 1, state: 2, takes }];
    const { wrapper } = show(aRun([], { state: 3, blocks }), ready);
    expect(wrapper.find('[aria-label="Recordings of the run"]').text()).toContain('sub-P07_run-01');
    expect(wrapper.find('[aria-label="Download sub-P07_run-01"]').attributes('href')).toBe(
      '/recordings/rec.mcap',
    );
  });
});
