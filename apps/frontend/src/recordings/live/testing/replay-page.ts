import { ReplayState, type Recording, type Replay } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { computed, defineComponent, h, nextTick, ref, shallowRef, type Component } from 'vue';
import { CONNECTION } from '../../../connection/connection.ts';
import type { OpenedPlayer } from '../../opened/opened-player.ts';
import { fakeRecording } from '../../opened/testing/fake-recording.ts';

/** A call of a service that the test replies to. */
export interface MadeCall {
  readonly service: string;
  readonly request: object;
}

/** A replay for tests. */
export const aReplay = (change: Partial<Replay> = {}): Replay => ({
  id: 'r1',
  name: 'Replay of Study',
  recordingId: 'study',
  recordingName: 'Study',
  author: 'Ada',
  state: ReplayState.REPLAY_STATE_PLAYING,
  positionMs: 0,
  durationMs: 1000,
  rate: 1,
  span: { fromMs: 0, untilMs: 1000 },
  isLooping: false,
  isGhost: false,
  copies: 1,
  clientIds: ['c1'],
  conflict: 0,
  livePrefix: '',
  topicCount: 2,
  recordCount: 10,
  mutedCount: 0,
  mutedTopics: [],
  refusedCount: 0,
  problem: '',
  session: undefined,
  startedMs: 0,
  recordingStartedMs: 0,
  ...change,
});

export const STUDY = { id: 'study', name: 'Study' } as Recording;

/**
 * Mounts a part of a page whose master is the test.
 *
 * @param reply gives the reply to a call, or throws
 * @param part is below the one that calls `use`
 * @param use what is called in the setup of the part
 */
export function replayPage<T>(
  use: (player: OpenedPlayer) => T,
  reply: (call: MadeCall) => unknown = () => undefined,
  part: Component | string = 'p',
) {
  const calls: MadeCall[] = [];
  const listeners = new Set<(record: { value: { elements: Replay[] } }) => void>();
  const client = {
    id: 'this-page',
    role: 'admin',
    call(service: string, request: object): Promise<unknown> {
      calls.push({ service, request });
      return Promise.resolve().then(() => reply({ service, request }));
    },
    subscribe: () => ({
      ready: Promise.resolve(),
      onRecord(listener: (record: { value: { elements: Replay[] } }) => void) {
        listeners.add(listener);
        return this;
      },
      close: () => Promise.resolve(),
    }),
  };
  const connection = {
    client,
    isConnected: ref(true),
    state: computed(() => ({ status: 'connected' })),
    clients: { list: shallowRef([]), find: () => undefined },
  };
  const opened = fakeRecording();
  let used!: T;
  const wrapper = mount(
    defineComponent(() => {
      used = use(opened.player);
      return () => h(part);
    }),
    { global: { provide: { [CONNECTION as symbol]: connection } } },
  );
  return {
    calls,
    used,
    opened,
    connection,
    wrapper,
    /** The master publishes the list of replays. */
    async news(...elements: Replay[]): Promise<void> {
      for (const listener of listeners) listener({ value: { elements } });
      await nextTick();
    },
  };
}
