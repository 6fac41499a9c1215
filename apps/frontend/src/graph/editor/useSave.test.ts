// @vitest-environment happy-dom
import type { Session } from '@ubii/proto';
import { flushPromises, mount } from '@vue/test-utils';
import { expect, it } from 'vitest';
import { defineComponent, h, shallowRef } from 'vue';
import { CONNECTION, type Connection } from '../../connection/connection.ts';
import type { SessionActions } from '../../sessions/actions/useSessionActions.ts';
import { aSession } from '../../sessions/testing/a-session.ts';
import { createGraphEditor } from '../editing/graph-editor.ts';
import { useSave } from './useSave.ts';

it('saves a name that is given while the one before it is being saved', async () => {
  let revision = 3;
  const first = aSession({ name: 'First' });
  const editor = createGraphEditor(
    { ...first, extension: { ...first.extension!, revision } },
    () => 'uuid',
  );
  const renamed: { readonly name: string; arrive(): void }[] = [];
  const calls = {
    takenNames: async () => new Set<string>(),
    rename: (session: Session, name: string) =>
      new Promise<Session>((resolve) => {
        const extension = { ...session.extension!, revision: (revision += 1) };
        renamed.push({ name, arrive: () => resolve({ ...session, name, extension }) });
      }),
  };
  const actions = { calls, busy: shallowRef(new Set()), failures: shallowRef(new Map()) };
  const connection = { isConnected: shallowRef(true) };
  const wrapper = mount(
    defineComponent({
      setup() {
        useSave(editor, actions as unknown as SessionActions, () => false);
        return () => h('p');
      },
    }),
    { global: { provide: { [CONNECTION as symbol]: connection as unknown as Connection } } },
  );
  const rename = async (name: string): Promise<void> => {
    editor.apply({ kind: 'setDetails', changes: { name } });
    await flushPromises();
  };

  await rename('Second');
  await rename('First');
  expect(renamed.map(({ name }) => name)).toEqual(['Second']);
  renamed[0]!.arrive();
  await flushPromises();
  expect(renamed.map(({ name }) => name)).toEqual(['Second', 'First']);
  renamed[1]!.arrive();
  await flushPromises();
  expect(editor.session.value.name).toBe('First');
  expect(editor.changes.value).toBe(0);
  wrapper.unmount();
});
