import type {
  OpenedRecording,
  RecordingPage,
  RecordingWorker,
} from '../../reading/recording-messages.ts';
import { createOpenedPlayer } from '../opened-player.ts';

/** A recording without topics. */
export const aRecording = (change: Partial<OpenedRecording> = {}): OpenedRecording => ({
  name: 'Study',
  notes: '',
  masterName: 'Studio',
  startMs: 0,
  durationMs: 1000,
  records: 2,
  topics: [],
  clientNames: new Map<string, string>(),
  markers: [],
  gaps: [],
  isDamaged: false,
  labels: [],
  ...change,
});

/** A call of the worker: its name, and the arguments. */
export type SentCall = readonly [name: string, ...args: unknown[]];

/** A player whose worker the test plays. `sent` has what it called, after opening; `page` is what the worker calls. */
export function fakeRecording(
  recording = aRecording(),
  atFrame: (fn: () => void) => void = () => undefined,
  nowMs?: () => number,
) {
  const sent: SentCall[] = [];
  let page!: RecordingPage;
  const calls = new Proxy({} as RecordingWorker, {
    get:
      (_target, name: string) =>
      (...args: unknown[]) => {
        sent.push([name, ...args]);
        return Promise.resolve();
      },
  });
  const source = { url: '/recordings/study.mcap', authorization: undefined };
  const player = createOpenedPlayer(source, atFrame, nowMs, (ofPage) => {
    page = ofPage;
    return { calls, close: () => undefined };
  });
  sent.length = 0;
  page.showOpened(recording);
  return { player, sent, page };
}
