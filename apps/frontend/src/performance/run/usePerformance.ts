import { ServiceError } from '@ubii/proto';
import { systemClock } from '@ubii/timing/system';
import { useEventListener } from '@vueuse/core';
import { onScopeDispose, provide, shallowRef, watch, type InjectionKey } from 'vue';
import { injectOrThrow } from '../../context/inject-or-throw.ts';
import { randomUuid } from '../../connection/random-uuid.ts';
import { sendAtPageHide } from '../../connection/send-at-page-hide.ts';
import { useConnection } from '../../connection/useConnection.ts';
import type { Findings, TestKind } from '../measure/findings.ts';
import type { TestRun } from '../measure/test-run.ts';
import { createKeptResults, type KeptResults } from '../results/kept-results.ts';
import { openResultStore } from '../results/result-store.ts';
import type { Parameter, TestEnd, TestResult } from '../results/test-result.ts';
import { TEST_TITLES } from '../words/test-words.ts';
import { circumstances } from './circumstances.ts';
import { createLeavings, removalRequest, type Leaving, type Leavings } from './leavings.ts';
import type { RunState } from './run-state.ts';
import { isAbandoned } from './test-session.ts';

/** Tests of the page and their results. */
export interface Performance {
  readonly run: Readonly<{ value: RunState }>;
  readonly results: KeptResults;
  readonly leavings: Leavings;
  /** Starts a test, unless one is running. Its result is stored. */
  start(
    kind: TestKind,
    parameters: readonly Parameter[],
    measure: (run: TestRun) => Promise<Findings>,
  ): void;
  /** Ends the running test; its measurements are stored. */
  stop(): void;
}

const PERFORMANCE: InjectionKey<Performance> = Symbol('performance');

export function usePerformance(): Performance {
  return injectOrThrow(PERFORMANCE, 'providePerformance() on the page above it');
}

/** Reason why a test ended early. */
type EndCause = Exclude<TestEnd, 'complete'> | 'left';

const HIDDEN_NOTE =
  'The page was hidden for a part of the test. Browsers slow hidden pages down, so the figures may be wrong.';

/** Provides tests and results; a test that runs when the page is left ends with it. */
export function providePerformance(): Performance {
  const connection = useConnection();
  const { client, isConnected } = connection;
  const run = shallowRef<RunState>({ status: 'idle' });
  const results = createKeptResults(openResultStore);
  const leavings = createLeavings(sessionStorage);
  let ending: AbortController | undefined;
  let hasBeenHidden = false;

  function end(cause: EndCause): void {
    ending?.abort(cause);
    if (run.value.status === 'running') run.value = { ...run.value, isEnding: true };
  }

  function start(
    kind: TestKind,
    parameters: readonly Parameter[],
    measure: (run: TestRun) => Promise<Findings>,
  ): void {
    if (run.value.status === 'running') return;
    const mine = new AbortController();
    ending = mine;
    hasBeenHidden = document.hidden;
    const startedMs = Date.now();
    const around = circumstances(connection, { navigator, location });
    run.value = {
      status: 'running',
      kind,
      progress: { share: 0, words: 'Preparing' },
      isEnding: false,
    };
    const test: TestRun = {
      clock: systemClock,
      signal: mine.signal,
      report(progress) {
        if (run.value.status === 'running') run.value = { ...run.value, progress };
      },
    };

    async function work(): Promise<void> {
      const findings = await measure(test);
      const cause = mine.signal.aborted ? (mine.signal.reason as EndCause) : 'complete';
      if (cause === 'left') return;
      if (findings.figures.length === 0) {
        run.value =
          cause === 'disconnected'
            ? {
                status: 'failed',
                kind,
                reason: 'The page lost its connection before the first measurement.',
              }
            : { status: 'idle' };
        return;
      }
      const id = randomUuid();
      await results.put({
        id,
        kind,
        name: freeName(nameOf(kind, parameters), results.list.value ?? []),
        startedMs,
        durationMs: Date.now() - startedMs,
        ended: cause,
        parameters,
        circumstances: around,
        findings: hasBeenHidden
          ? { ...findings, notes: [HIDDEN_NOTE, ...findings.notes] }
          : findings,
      });
      run.value = { status: 'done', kind, resultId: id };
    }
    work()
      .catch((cause: unknown) => {
        if (mine.signal.reason === 'left') return;
        const reason = cause instanceof Error ? cause.message : String(cause);
        run.value = { status: 'failed', kind, reason };
      })
      .finally(() => {
        if (leavings.all.length > 0 && isConnected.value) void tidyUp().catch(() => undefined);
      });
  }

  /** Removes objects that an earlier visit left behind after a crash or a closed tab. */
  async function tidyUp(): Promise<void> {
    // Objects of a running test belong to it.
    if (run.value.status === 'running') return;
    for (const leaving of leavings.all) await remove(leaving);
    const { elements } = await client.call('sessionRuntimeGetList');
    const { elements: there } = await client.call('clientGetList');
    const ids = new Set(there.map(({ id }) => id));
    const abandoned = elements.filter((session) => isAbandoned(session, (id) => ids.has(id)));
    for (const { id } of abandoned) await remove({ kind: 'session', id });
  }
  async function remove(leaving: Leaving): Promise<void> {
    try {
      if (leaving.kind === 'client') await client.call('clientDeregistration', { id: leaving.id });
      else await client.call('sessionRuntimeRemove', { id: leaving.id });
    } catch (cause) {
      if (!(cause instanceof ServiceError && cause.code === 'not_found')) throw cause;
    }
    leavings.drop(leaving);
  }

  watch(
    isConnected,
    (connected) => {
      // Retried after the next connect, and on the next visit.
      if (connected) tidyUp().catch(() => undefined);
      else end('disconnected');
    },
    { immediate: true },
  );
  useEventListener(document, 'visibilitychange', () => {
    hasBeenHidden ||= document.hidden;
  });
  onScopeDispose(() => end('left'));
  // A page that is closed or reloaded cannot wait for a reply.
  useEventListener(window, 'pagehide', () => {
    const sessions = leavings.all.filter(({ kind }) => kind === 'session');
    // The client of a session keeps its topics until the last run has ended: it is removed on the next visit, or by the
    // master, like every client whose page is closed. [TD-40]
    for (const leaving of sessions.length > 0 ? sessions : leavings.all) {
      sendAtPageHide(client, removalRequest(leaving));
    }
  });

  const performance: Performance = {
    run,
    results,
    leavings,
    start,
    stop: () => end('stopped'),
  };
  provide(PERFORMANCE, performance);
  return performance;
}

/** Named after the parameters, so that runs can be distinguished without opening them. */
function nameOf(kind: TestKind, parameters: readonly Parameter[]): string {
  const chosen = parameters
    .slice(0, 2)
    .map(({ value, unit }) => (unit === undefined ? `${value}` : `${value} ${unit}`));
  return `${TEST_TITLES[kind]}: ${chosen.join(', ')}`;
}

/** Makes the name unique among the results. */
function freeName(name: string, results: readonly TestResult[]): string {
  const taken = new Set(results.map((result) => result.name));
  if (!taken.has(name)) return name;
  let number = 2;
  while (taken.has(`${name} (${number})`)) number += 1;
  return `${name} (${number})`;
}
