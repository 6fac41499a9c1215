import { ReplayState, fromJson, type Recording, type Replay } from '@ubii/proto';
import { callWorker, type WorkerPeer } from '@ubii/worker-rpc/browser';
import {
  computed,
  onScopeDispose,
  provide,
  shallowRef,
  watch,
  type ComputedRef,
  type InjectionKey,
  type Ref,
  type ShallowRef,
} from 'vue';
import { injectOrThrow } from '../../context/inject-or-throw.ts';
import { tryRequest } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useReplays } from '../../connection/live/useReplays.ts';
import { writtenTopics } from '../../sessions/words/shared-topics.ts';
import { masterFile } from '../files/readable-file.ts';
import { useMayRecord } from '../rights/useMayRecord.ts';
import type { OpenedPlayer } from '../opened/opened-player.ts';
import type { PlayedSession } from '../reading/recording-messages.ts';
import type { Span } from '../timeline/span.ts';
import type { ComparePage, CompareWorker, SessionComparison } from './compare-messages.ts';

/** A recorded session that runs again with today's modules, and how its outputs compare. */
export type RerunState =
  | { readonly status: 'running'; readonly replay: Replay }
  | { readonly status: 'comparing'; readonly outputs: number }
  | {
      readonly status: 'done';
      readonly comparison: SessionComparison;
      /** Names of modules that are not in the library: they ran with their recorded code. */
      readonly recordedModules: readonly string[];
      /** Modules that failed and inputs that stayed empty; empty when there are none. */
      readonly problem: string;
    }
  | { readonly status: 'failed'; readonly message: string };

export interface Rerun {
  /** Undefined before the first run, and when it was closed. */
  readonly state: Readonly<ShallowRef<RerunState | undefined>>;
  /** Why no session can run again, one sentence. */
  readonly refusal: ComputedRef<string | undefined>;
  /** Plays the inputs of a session, all or those of the loop, at the rate of the page. */
  start(session: Pick<PlayedSession, 'id' | 'session'>): Promise<void>;
  /** Stops the run or the comparison, and takes its result away. */
  close(): void;
}

const RERUN: InjectionKey<Rerun> = Symbol('rerun');

export function useRerun(): Rerun {
  return injectOrThrow(RERUN, 'an opened recording above it');
}

/** Starts a worker for one comparison. */
const openCompareWorker = (page: ComparePage): WorkerPeer<CompareWorker> =>
  callWorker(
    new Worker(new URL('./compare-worker.ts', import.meta.url), { type: 'module' }),
    page,
    'This browser cannot compare the recordings.',
  );

/** @param recording at the master; undefined for a file of this device */
export function provideRerun(
  opened: OpenedPlayer,
  recording: Readonly<Ref<Recording | undefined>>,
  openWorker = openCompareWorker,
): Rerun {
  const { client } = useConnection();
  const replays = useReplays();
  const mayReplay = useMayRecord();
  const state = shallowRef<RerunState>();
  let outputs: readonly string[] = [];
  let span: Span | undefined;
  let cancelCompare = (): void => undefined;

  const request = <T>(work: () => Promise<T>): Promise<T | undefined> =>
    tryRequest(work, ({ message }) => (state.value = { status: 'failed', message }));
  async function finish(replay: Replay): Promise<void> {
    const { session, recordingId, problem } = replay;
    if (session === undefined) return;
    state.value = { status: 'comparing', outputs: 0 };
    // Its recording is closed then.
    const isStopped = await request(() => client.call('replayStop', { id: replay.id }));
    if (isStopped === undefined) return;
    const compared = {
      recordedFile: masterFile(recordingId, client),
      rerunFile: masterFile(session.comparisonRecordingId, client),
      inputPrefix: session.inputPrefix,
      outputPrefix: session.outputPrefix,
      outputs,
      span,
    };
    const worker = openWorker({
      showProgress: (outputs) => void (state.value = { status: 'comparing', outputs }),
    });
    cancelCompare = () => worker.close();
    try {
      const comparison = await worker.calls.compare(compared);
      const { recordedModules } = session;
      state.value = { status: 'done', comparison, recordedModules, problem };
    } catch (error) {
      state.value = { status: 'failed', message: (error as Error).message };
    }
    worker.close();
  }
  watch(replays, (all) => {
    if (state.value?.status !== 'running') return;
    const { id } = state.value.replay;
    const now = all.find((one) => one.id === id);
    if (now === undefined)
      state.value = { status: 'failed', message: 'The run was stopped before its end.' };
    else if (now.state === ReplayState.REPLAY_STATE_FAILED) {
      state.value = { status: 'failed', message: now.problem };
      void request(() => client.call('replayStop', { id }));
    } else if (isOver(now)) void finish(now);
    else state.value = { status: 'running', replay: now };
  });

  function close(): void {
    const before = state.value;
    state.value = undefined;
    cancelCompare();
    if (before?.status === 'running') {
      const { id } = before.replay;
      void request(() => client.call('replayStop', { id }));
    }
  }
  onScopeDispose(close);

  const rerun: Rerun = {
    state,
    close,
    refusal: computed(() => {
      if (recording.value === undefined) return 'Upload the file to the master first.';
      return mayReplay.value ? undefined : 'Participants and admins can run recorded sessions.';
    }),
    async start({ id, session }) {
      close();
      const { rate, loop } = opened.player.value;
      outputs = outputsOf(session);
      span = loop;
      const replay = await request(() =>
        client.call('replayStart', {
          clientId: client.id,
          recordingId: recording.value?.id ?? '',
          sessionId: id,
          rate,
          ...(loop && { span: { fromMs: loop.fromMs, untilMs: loop.untilMs } }),
        }),
      );
      if (replay) state.value = { status: 'running', replay };
    },
  };
  provide(RERUN, rerun);
  return rerun;
}

/** The span is played, and the session has written its last outputs. */
const isOver = ({ state, session }: Replay): boolean =>
  state === ReplayState.REPLAY_STATE_ENDED && session?.runningId === '';

/** Topics that the modules of a recorded session write. @param json the session */
function outputsOf(json: string): readonly string[] {
  try {
    return [...writtenTopics(fromJson('ubii.sessions.Session', JSON.parse(json)))];
  } catch {
    return [];
  }
}
