// @vitest-environment happy-dom
import { SessionState } from '@ubii/proto';
import { flushPromises, mount } from '@vue/test-utils';
import { expect, it } from 'vitest';
import { defineComponent, h, shallowRef } from 'vue';
import { aSession } from '../../sessions/testing/a-session.ts';
import { createToasts, provideToasts } from '../../ui/toasts/toasts.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';
import { useLife, type Life } from './useLife.ts';
import type { Saving } from './useSave.ts';

/** Returns the messages shown after one step was saved. */
async function said(
  intent: (life: Life) => Promise<void>,
  { isRunning, isStored }: { readonly isRunning: boolean; readonly isStored: boolean },
): Promise<string | undefined> {
  const { SESSION_RUNNING, SESSION_STOPPED } = SessionState;
  const session = aSession({ state: isRunning ? SESSION_RUNNING : SESSION_STOPPED });
  const changes = shallowRef(1);
  const editor = {
    changes,
    session: shallowRef({
      ...session,
      extension: { ...session.extension!, stored: isStored },
    }),
  } as unknown as GraphEditor;
  const save = async (): Promise<boolean> => {
    changes.value = 0;
    return true;
  };
  const saving = { save, act: save, failure: shallowRef() } as unknown as Saving;
  const toasts = createToasts();
  const wrapper = mount(
    defineComponent({
      setup() {
        void intent(useLife(editor, saving));
        return () => h('p');
      },
    }),
    { global: { plugins: [(app) => provideToasts(app, toasts)] } },
  );
  await flushPromises();
  const said = toasts.list.value.at(-1)?.text;
  wrapper.unmount();
  expect(toasts.list.value, 'toasts after the editor').toEqual([]);
  return said;
}

it('a save of a running session is told as applied, too', async () => {
  const save = (life: Life): Promise<void> => life.save();
  expect(await said(save, { isRunning: true, isStored: true })).toBe('Saved and applied');
  expect(await said(save, { isRunning: false, isStored: true })).toBe('Saved');
});

it('a session that is not stored is not told as saved', async () => {
  const start = (life: Life): Promise<void> => life.act('start');
  expect(await said((life) => life.save(), { isRunning: true, isStored: false })).toBe('Applied');
  expect(await said(start, { isRunning: false, isStored: false })).toBe('Started');
  expect(await said(start, { isRunning: false, isStored: true })).toBe('Saved and started');
});
