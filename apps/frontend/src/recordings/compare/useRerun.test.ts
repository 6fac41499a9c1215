// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { ReplayState, ServiceError, type ReplayedSession } from '@ubii/proto';
import { shallowRef } from 'vue';
import { afterEach, describe, expect, it } from 'vitest';
import { aReplay, replayPage, STUDY, type MadeCall } from '../live/testing/replay-page.ts';
import type { ComparePage, CompareRequest, SessionComparison } from './compare-messages.ts';
import { provideRerun } from './useRerun.ts';

const wrappers: { unmount(): void }[] = [];
afterEach(() => wrappers.splice(0).forEach((wrapper) => wrapper.unmount()));

const SESSION: ReplayedSession = {
  sessionId: 's',
  name: 'Sum',
  runningId: 's2',
  comparisonRecordingId: 'again',
  inputPrefix: '/replays/r1/in',
  outputPrefix: '/replays/r1/out',
  recordedModules: ['Old'],
};
const PLAYED = { id: 's', name: 'Sum', state: 'running', session: sessionText() };
function sessionText(): string {
  const outputMappings = [{ outputName: 'out', topic: '/sum' }];
  return JSON.stringify({
    processingModules: [{ id: 'm' }],
    ioMappings: [{ processingModuleId: 'm', outputMappings }],
  });
}
const running = (positionMs: number) => aReplay({ session: SESSION, positionMs });
const PROBLEM = 'A run of the module "Sum" failed: x is not defined.';
const ended = aReplay({
  session: { ...SESSION, runningId: '' },
  state: ReplayState.REPLAY_STATE_ENDED,
  problem: PROBLEM,
});

function setUp(reply: (call: MadeCall) => unknown = () => running(0)) {
  const requests: CompareRequest[] = [];
  let worker!: ComparePage;
  let done: (comparison: SessionComparison) => void = () => undefined;
  const closed = { count: 0 };
  const page = replayPage(
    (player) =>
      provideRerun(player, shallowRef(STUDY), (ofPage) => {
        worker = ofPage;
        return {
          calls: {
            compare(request) {
              requests.push(request);
              return new Promise((resolve) => (done = resolve));
            },
          },
          close: () => void (closed.count += 1),
        };
      }),
    reply,
  );
  wrappers.push(page.wrapper);
  const finish = async (comparison: SessionComparison): Promise<void> => {
    done(comparison);
    await flushPromises();
  };
  const progress = (outputs: number): void => worker.showProgress(outputs);
  return { ...page, rerun: page.used, requests, progress, finish, closed };
}
const services = (calls: readonly MadeCall[]) => calls.map(({ service }) => service);

describe('a recorded session that runs again', () => {
  it('shows how far it is, ends the replay, and compares both files', async () => {
    const { rerun, news, calls, requests, progress, finish } = setUp();
    await rerun.start(PLAYED);
    expect(calls[0]!.request).toMatchObject({ recordingId: 'study', sessionId: 's', rate: 1 });
    await news(running(500));
    expect(rerun.state.value).toMatchObject({ status: 'running', replay: { positionMs: 500 } });
    await news(aReplay({ session: SESSION, state: ReplayState.REPLAY_STATE_ENDED }));
    expect(services(calls)).toEqual(['replayStart']); // It still writes its last outputs.
    await news(ended);
    await flushPromises();
    expect(services(calls)).toEqual(['replayStart', 'replayStop']);
    expect(requests).toEqual([
      {
        recordedFile: { url: '/recordings/study.mcap', authorization: undefined },
        rerunFile: { url: '/recordings/again.mcap', authorization: undefined },
        inputPrefix: '/replays/r1/in',
        outputPrefix: '/replays/r1/out',
        outputs: ['/sum'],
        span: undefined,
      },
    ]);
    progress(500);
    expect(rerun.state.value).toEqual({ status: 'comparing', outputs: 500 });
    const comparison = { topics: [], differences: [] };
    await finish(comparison);
    expect(rerun.state.value).toEqual({
      status: 'done',
      comparison,
      recordedModules: ['Old'],
      problem: PROBLEM,
    });
  });

  it('plays the loop only, when there is one', async () => {
    const { rerun, calls, opened } = setUp();
    const loop = { fromMs: 100, untilMs: 300 };
    opened.page.showPlayer({ ...opened.player.player.value, loop });
    await rerun.start(PLAYED);
    expect(calls[0]!.request).toMatchObject({ span: loop });
  });

  it('is cancelled while it plays, and while outputs are compared', async () => {
    const { rerun, news, calls, closed } = setUp();
    await rerun.start(PLAYED);
    rerun.close();
    await flushPromises();
    expect(services(calls)).toEqual(['replayStart', 'replayStop']);
    expect(rerun.state.value).toBeUndefined();
    await rerun.start(PLAYED);
    await news(ended);
    await flushPromises();
    rerun.close();
    expect(closed.count).toBe(1);
    expect(rerun.state.value).toBeUndefined();
  });

  it('says why it failed: refused, stopped by others, or without a file', async () => {
    const refused = setUp(() => {
      throw new ServiceError('resource_exhausted', 'Four replays run already.');
    });
    await refused.rerun.start(PLAYED);
    expect(refused.rerun.state.value).toEqual({
      status: 'failed',
      message: 'Four replays run already.',
    });
    const { rerun, news } = setUp();
    await rerun.start(PLAYED);
    await news();
    expect(rerun.state.value).toMatchObject({
      status: 'failed',
      message: 'The run was stopped before its end.',
    });
    await rerun.start(PLAYED);
    await news(aReplay({ state: ReplayState.REPLAY_STATE_FAILED, problem: 'The file is gone.' }));
    expect(rerun.state.value).toEqual({ status: 'failed', message: 'The file is gone.' });
  });
});
