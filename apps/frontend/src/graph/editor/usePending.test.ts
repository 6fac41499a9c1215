// @vitest-environment happy-dom
import { SessionState, type Session } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { defineComponent, h, shallowRef, type ShallowRef } from 'vue';
import { CONNECTION, type Connection } from '../../connection/connection.ts';
import { aSession } from '../../sessions/testing/a-session.ts';
import { createGraphEditor, type GraphEditor } from '../editing/graph-editor.ts';
import type { PendingChanges } from '../live/useGraphContext.ts';
import { usePending } from './usePending.ts';
import type { Saving } from './useSave.ts';

beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
afterEach(() => void vi.useRealTimers());

interface World {
  readonly editor: GraphEditor;
  readonly pending: PendingChanges;
  readonly saved: Session[];
  readonly isRefused: ShallowRef<boolean>;
  settle(): Promise<void>;
}

function open(state: SessionState = SessionState.SESSION_RUNNING): World {
  const editor = createGraphEditor(aSession({ state }), () => 'uuid');
  const saved: Session[] = [];
  const isRefused = shallowRef(false);
  const save = async (): Promise<boolean> => {
    saved.push(editor.toSession());
    if (isRefused.value) return false;
    const { extension, ...session } = editor.toSession();
    const revision = (extension?.revision ?? 0) + 1;
    editor.handleSaved({ ...session, extension: { ...extension!, revision } }, editor.mark());
    return true;
  };
  const saving = { save, isRefused } as unknown as Saving;
  let pending!: PendingChanges;
  const setup = () => {
    pending = usePending(editor, saving);
    return () => h('p');
  };
  const connection = { isConnected: shallowRef(true) } as unknown as Connection;
  mount(defineComponent({ setup }), {
    global: { provide: { [CONNECTION as symbol]: connection } },
  });
  return { editor, pending, saved, isRefused, settle: () => vi.runAllTimersAsync().then() };
}

const describeAs = (editor: GraphEditor, description: string): void =>
  editor.apply({ kind: 'setDetails', changes: { description } }, 'description');
const moduleOf = (editor: GraphEditor) =>
  [...editor.graph.value.nodes.values()].find(({ kind }) => kind === 'module')!;
const changeCode = (editor: GraphEditor): void => {
  const changes = { name: 'another', onProcessingStringified: '() => {}' };
  editor.apply({ kind: 'setModule', node: moduleOf(editor).id, changes });
};

it('applies changes that restart nothing, once for a word that is typed [SE-15]', async () => {
  const { editor, pending, saved, settle } = open();
  describeAs(editor, 'a');
  describeAs(editor, 'ab');
  expect(pending.waits.value).toBe(false);
  await settle();
  expect(saved.map(({ description }) => description)).toEqual(['ab']);
  expect(editor.changes.value).toBe(0);
});

it('asks before modules restart, and says how many [SE-15]', async () => {
  const { editor, pending, saved, settle } = open();
  changeCode(editor);
  await settle();
  expect(saved).toEqual([]);
  expect([pending.waits.value, pending.restarts.value]).toEqual([true, 1]);
});

it('sends nothing while the session does not run', async () => {
  const { editor, pending, saved, settle } = open(SessionState.SESSION_STOPPED);
  describeAs(editor, 'a');
  await settle();
  expect([saved, pending.waits.value]).toEqual([[], false]);
});

it('sends what was refused again only after another change', async () => {
  const { editor, pending, saved, isRefused, settle } = open();
  isRefused.value = true;
  describeAs(editor, 'a');
  await settle();
  editor.handleSession({ ...editor.session.value });
  await settle();
  expect(saved).toHaveLength(1);
  expect(pending.waits.value).toBe(true);
  describeAs(editor, 'ab');
  await settle();
  expect(saved).toHaveLength(2);
});
