import { ServiceError, type Init, type Session } from '@ubii/proto';
import {
  computed,
  nextTick,
  onScopeDispose,
  shallowRef,
  watch,
  type ComputedRef,
  type ShallowRef,
} from 'vue';
import { refusalSentence, tryRequest, useAttempt } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useTabNode } from '../../tab-node/useTabNode.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { isAlive } from '../state/session-state.ts';
import { plannedSession, type SessionPlan } from './planned-session.ts';
import { removeOnPageHide } from './remove-on-page-hide.ts';

/** A session that lives with its page: kept as planned while the page is open, removed when it is left. */
export interface PageLife {
  readonly life: 'page';
  /** Returns `undefined` to end it. */
  readonly spec: () => SessionPlan | undefined;
  /** Called when a plan fails; the previous session continues. */
  readonly onFailure?: () => void;
  /** True for sessions from before a reload, which are removed before the first start. */
  readonly isLeftover?: (session: Session) => boolean;
  /** True while the session is not to be removed, because the user stored it or opens its page. */
  readonly isKept?: (session: Session) => boolean;
}

/** Session that a page starts, changes while it runs, and removes when it is left. */
export interface PageSession {
  /** `undefined` while there is none. */
  readonly session: ComputedRef<Session | undefined>;
  /** True from a new plan until its modules run. */
  readonly isStarting: ComputedRef<boolean>;
  /** Error of the last change, one sentence. */
  readonly failure: Readonly<ShallowRef<string | undefined>>;
  /** Error of the last change, or problem of the session, one sentence. */
  readonly trouble: ComputedRef<string | undefined>;
  /** Removes the session, and starts it again as it is planned now. Resolves when that is done, or has failed. */
  restart(): Promise<void>;
}

/** Keeps a session as planned, also after a restart of the master, which does not store it. */
export function keepPageSession(options: PageLife): PageSession {
  const {
    spec: plan,
    onFailure = () => undefined,
    isLeftover = () => false,
    isKept = () => false,
  } = options;
  const { client, isConnected, sessions, masterId } = useConnection();
  const tab = useTabNode();
  const toasts = useToasts();
  const id = shallowRef<string>();
  const { problem, attempt } = useAttempt({ sentenceOf: refusalSentence, catchesAll: true });
  const failure = shallowRef<string>();
  let releaseTab: (() => void) | undefined;
  let isOver = false;
  /** Run id of the master that has the session. */
  let runId = '';
  const session = computed(() => sessions.list.value?.find((one) => one.id === id.value));

  async function nodeId(place: string): Promise<string> {
    if (place === 'tab') {
      releaseTab ??= tab.need();
      await tab.whenOn();
      return client.id;
    }
    return place;
  }

  async function apply(): Promise<void> {
    const text = planText.value;
    appliedText = undefined;
    await applyPlan(plan());
    appliedText = text;
  }
  async function applyPlan(wanted: SessionPlan | undefined): Promise<void> {
    if (wanted === undefined) return end();
    const node = await nodeId(wanted.place);
    if (isOver) return;
    const known = id.value === undefined ? undefined : sessions.find(id.value);
    const next = plannedSession(wanted, known, node);
    const answer =
      (known && (await update(next))) ??
      (id.value === undefined
        ? await start(next)
        : await startAgain(plannedSession(wanted, undefined, node)));
    sessions.take(answer);
    id.value = answer.id;
    if (isOver) return end();
    if (wanted.place !== 'tab') release();
  }

  /** Returns `undefined` when the master has no such session, which this page may not know yet. */
  async function update(next: Init<Session>): Promise<Session | undefined> {
    try {
      return await client.call('sessionRuntimeUpdate', next);
    } catch (cause) {
      if (!(cause instanceof ServiceError && cause.code === 'not_found')) throw cause;
      const { elements } = await client.call('sessionRuntimeGetList');
      // The session exists; something else, such as the node, does not.
      if (elements.some((one) => one.id === next.id)) throw cause;
      sessions.drop(next.id!);
      return undefined;
    }
  }

  async function start(next: Init<Session>): Promise<Session> {
    runId = masterId.value;
    await removeLeftovers();
    return client.call('sessionRuntimeStart', next);
  }

  async function removeLeftovers(): Promise<void> {
    if (options.isLeftover === undefined) return;
    const { elements } = await client.call('sessionRuntimeGetList');
    for (const { id: left } of elements.filter(isLeftover)) {
      await tryRequest(() => client.call('sessionRuntimeRemove', { id: left }));
    }
  }

  /** Starts the session again after a restart of the master. */
  async function startAgain(next: Init<Session>): Promise<Session> {
    const { id: newest } = await client.call('serverConfiguration');
    if (newest === runId) throw new Error('Another client deleted the session of this page.');
    runId = newest;
    try {
      const started = await client.call('sessionRuntimeStart', next);
      toasts.show(
        `The master was restarted. This page started its session “${started.name}” again.`,
      );
      return started;
    } catch (cause) {
      if (!(cause instanceof ServiceError)) throw cause;
      throw new Error(
        `The restart of the master ended the session. It could not start again: ${cause.message}`,
        { cause },
      );
    }
  }

  function release(): void {
    releaseTab?.();
    releaseTab = undefined;
  }

  /** Id of the session when it is to be removed. */
  const toRemove = (): string | undefined =>
    session.value && isKept(session.value) ? undefined : id.value;

  async function end(): Promise<void> {
    const gone = toRemove();
    id.value = undefined;
    release();
    if (gone === undefined) return;
    sessions.drop(gone);
    await client.call('sessionRuntimeRemove', { id: gone }).catch(() => undefined); // it is gone already
  }

  /** Serialises changes, however fast the plan changes. */
  let changes: Promise<void> = Promise.resolve();
  /** Plans are recomputed often; only changes of their content count. */
  const planText = computed(() => JSON.stringify(plan()));
  /** Text of the plan that was carried out last; `undefined` after a failure. */
  let appliedText: string | undefined;
  /** True during a call of `onFailure`: a plan that it ends keeps the error on the screen. */
  let isTelling = false;
  function applySoon(isNeeded: () => boolean = () => true): Promise<void> {
    const keepsReason = isTelling;
    changes = changes.then(async () => {
      if (!isNeeded()) return;
      if (!keepsReason) failure.value = undefined;
      await attempt(apply);
      // The shell shows a lost connection; the plan is applied after reconnecting.
      if (problem.value === undefined) return;
      if (isGone()) id.value = undefined;
      failure.value = problem.value;
      isTelling = true;
      onFailure();
      void nextTick(() => (isTelling = false));
    });
    return changes;
  }
  watch(
    [planText, isConnected],
    ([wanted, connected], [before, wasConnected]) => {
      if (!connected || (wanted === undefined && before === undefined)) return;
      // A restart may have carried out the plan already.
      void applySoon(() => !wasConnected || planText.value !== appliedText);
    },
    { immediate: true },
  );
  const isGone = (): boolean => id.value !== undefined && sessions.find(id.value) === undefined;
  watch(sessions.list, (list) => {
    if (list !== undefined && isConnected.value && isGone()) void applySoon(isGone);
  });
  onScopeDispose(() => {
    isOver = true;
    void end();
  });
  removeOnPageHide(client, toRemove);

  return {
    session,
    isStarting: computed(
      () => plan() !== undefined && (session.value === undefined || !isAlive(session.value)),
    ),
    failure,
    restart() {
      changes = changes.then(end);
      return applySoon();
    },
    trouble: computed(
      () =>
        failure.value ?? session.value?.extension?.problems.find(({ isError }) => isError)?.message,
    ),
  };
}
