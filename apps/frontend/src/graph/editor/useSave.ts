import { ConnectionError } from '@ubii/client-web';
import { ServiceError, type Session, type SessionProblem } from '@ubii/proto';
import { computed, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';
import { tryRequest, type RequestError } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import type { SessionActions } from '../../sessions/actions/useSessionActions.ts';
import type { LifeAction } from '../../sessions/state/session-state.ts';
import { problemsInGraph, type PlacedProblem } from '../model/live/problems-in-graph.ts';
import { freeName } from '../../sessions/text/session-spec.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';

/** Saves changes on the master, and starts and stops the session. */
export interface Saving {
  readonly isBusy: ComputedRef<boolean>;
  /** Reason why the last request failed, one sentence. */
  readonly failure: Readonly<ShallowRef<string | undefined>>;
  /** True when the master refused the last save. */
  readonly isRefused: ComputedRef<boolean>;
  /** Problems that the master found in the session to save, with their nodes. [SE-3] */
  readonly problems: Readonly<ShallowRef<readonly PlacedProblem[]>>;
  /** True when a save was requested while disconnected; it is sent after reconnecting. */
  readonly isWaiting: Readonly<ShallowRef<boolean>>;
  /** Newest revision saved by this page. */
  readonly savedRevision: Readonly<ShallowRef<number>>;
  /** @returns whether everything is saved */
  save(): Promise<boolean>;
  /** Saves unsaved changes, then starts, pauses or stops the session. */
  act(action: LifeAction): Promise<void>;
  /** Runs another request; a refusal is shown as `failure`. */
  request<T>(work: () => Promise<T>): Promise<T | undefined>;
}

const isProblems = (value: unknown): value is readonly SessionProblem[] =>
  Array.isArray(value) && value.length > 0;

/** @param isGone whether the session is missing on the master, so that saving creates it */
export function useSave(
  editor: GraphEditor,
  actions: SessionActions,
  isGone: () => boolean,
): Saving {
  const { client, sessions, isConnected } = useConnection();
  const isSaving = shallowRef(false);
  const isWaiting = shallowRef(false);
  const failure = shallowRef<string>();
  const savedRevision = shallowRef(-1);
  const problems = shallowRef<readonly PlacedProblem[]>([]);

  function fail(cause: RequestError): void {
    failure.value = cause.message;
    const found = cause instanceof ServiceError ? cause.details['problems'] : undefined;
    problems.value = isProblems(found)
      ? problemsInGraph(editor.graph.value, editor.toSession(), found)
      : [];
  }

  function request<T>(work: () => Promise<T>): Promise<T | undefined> {
    failure.value = undefined;
    problems.value = [];
    return tryRequest(work, fail);
  }

  /** Sessions are stored by name: renaming must delete the one with the old name. [SE-21] */
  function send(next: Session): Promise<Session> {
    if (isGone()) return actions.calls.store(next);
    const { name } = editor.session.value;
    return next.name === name
      ? actions.calls.update(next, {})
      : actions.calls.rename({ ...next, name }, next.name, next);
  }

  /** Merges the master's version, which another client may have saved. @returns whether it was newer */
  async function catchUp(): Promise<boolean> {
    const before = editor.baseSession();
    const newest = await client.call('sessionRuntimeGet', { id: editor.session.value.id });
    sessions.take(newest);
    editor.handleSession(newest);
    return editor.baseSession() !== before;
  }
  const isNew = (): boolean => (editor.session.value.extension?.revision ?? 0) === 0;
  const isSettled = (): boolean => (editor.merged.value ?? []).length === 0;

  async function saveNow(): Promise<boolean> {
    const { name } = editor.graph.value.details;
    const isGiven = name !== editor.session.value.name;
    const taken = isGiven || isGone() ? await actions.calls.takenNames() : new Set<string>();
    if (taken.has(name) && !isGiven && isNew()) {
      // Another session got the proposed name since: take the next one.
      editor.apply({ kind: 'setDetails', changes: { name: freeName(name, taken) } });
    } else if (taken.has(name)) {
      failure.value = `Another session has the name "${name}". Choose a different name.`;
      return false;
    }
    const mark = editor.mark();
    const sent = editor.toSession();
    const release = editor.hold(sent);
    try {
      const saved = await send(sent);
      savedRevision.value = saved.extension?.revision ?? -1;
      editor.handleSaved(saved, mark);
      release();
      return true;
    } catch (cause) {
      release();
      const isOld = cause instanceof ServiceError && cause.code === 'failed_precondition';
      // The user has to resolve conflicts first.
      if (!isOld || !(await catchUp())) throw cause;
      return isSettled() ? saveNow() : false;
    }
  }

  /** Saves run one after the other: a second save of the same revision would be refused. */
  let last: Promise<boolean> | undefined;
  async function save(): Promise<boolean> {
    while (last !== undefined) await last;
    const own = saveOnce();
    last = own;
    try {
      return await own;
    } finally {
      last = undefined;
    }
  }

  async function saveOnce(): Promise<boolean> {
    failure.value = undefined;
    problems.value = [];
    if (editor.changes.value === 0 && !isGone()) return true;
    if (!isConnected.value) {
      isWaiting.value = true;
      return false;
    }
    isSaving.value = true;
    try {
      const isSaved = await tryRequest(saveNow, (cause) => {
        // The connection was lost during the save, which may have arrived: check after reconnecting.
        if (cause instanceof ConnectionError) isWaiting.value = true;
        else fail(cause);
      });
      return isSaved === true;
    } finally {
      isSaving.value = false;
    }
  }

  // Other pages show the name: save it at once, also after an undo.
  watch(
    () => editor.graph.value.details.name,
    async () => {
      // Compare with the saved name only after pending saves.
      while (last !== undefined) await last;
      if (!isGone() && isConnected.value && editor.isOnlyRenamed()) await save();
    },
  );

  watch(isConnected, async (connected) => {
    if (!connected || !isWaiting.value) return;
    // A new session exists only here.
    const isNewest = isNew() || (await tryRequest(catchUp)) !== undefined;
    // The connection was lost again, or the session was deleted, which the page shows.
    if (!isNewest) return;
    isWaiting.value = false;
    if (isSettled()) await save();
  });

  return {
    isBusy: computed(() => isSaving.value || actions.busy.value.has(editor.session.value.id)),
    failure: computed(
      () => failure.value ?? actions.failures.value.get(editor.session.value.id),
    ) as Saving['failure'],
    isRefused: computed(() => failure.value !== undefined),
    problems,
    isWaiting,
    savedRevision,
    save,
    request,
    async act(action) {
      const needsSaving = action === 'start' || action === 'restart' || action === 'resume';
      if (needsSaving && editor.toSession().processingModules.length === 0) {
        failure.value = 'The session has no module. Add one to start it.';
        return;
      }
      if (needsSaving && !(await save())) return;
      await actions.act(editor.session.value, action);
    },
  };
}
