// @vitest-environment happy-dom
import type { Session } from '@ubii/proto';
import { flushPromises, mount } from '@vue/test-utils';
import { expect, it } from 'vitest';
import { defineComponent, h, shallowRef } from 'vue';
import { CONNECTION, type Connection } from '../../connection/connection.ts';
import type { SessionActions } from '../../sessions/actions/useSessionActions.ts';
import { aSession } from '../../sessions/testing/a-session.ts';
import { createGraphEditor, type GraphEditor } from '../editing/graph-editor.ts';
import { blankSession } from './blank-session.ts';
import { useSave, type Saving } from './useSave.ts';

/** Saving of an editor that is connected to a master with these calls. */
function savingOf(editor: GraphEditor, calls: object, isGone: () => boolean) {
  const actions = { calls, busy: shallowRef(new Set()), failures: shallowRef(new Map()) };
  const connection = { isConnected: shallowRef(true) };
  let saving: Saving | undefined;
  const wrapper = mount(
    defineComponent({
      setup() {
        saving = useSave(editor, actions as unknown as SessionActions, isGone);
        return () => h('p');
      },
    }),
    { global: { provide: { [CONNECTION as symbol]: connection as unknown as Connection } } },
  );
  return { wrapper, saving: saving! };
}

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
  const { wrapper } = savingOf(editor, calls, () => false);
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

it('gives a new session the next name when another one got its proposed name', async () => {
  const editor = createGraphEditor(blankSession('new', 'Session'), () => 'uuid');
  const stored: string[] = [];
  const calls = {
    takenNames: async () => new Set(['Session']),
    store: async (session: Session) => {
      stored.push(session.name);
      return { ...session, extension: { ...session.extension!, revision: 1 } };
    },
  };
  const { wrapper, saving } = savingOf(editor, calls, () => true);
  expect(await saving.save()).toBe(true);
  expect(stored).toEqual(['Session 2']);
  editor.apply({ kind: 'setDetails', changes: { name: 'Session' } });
  expect(await saving.save()).toBe(false);
  expect(saving.failure.value).toContain('Choose a different name.');
  wrapper.unmount();
});
