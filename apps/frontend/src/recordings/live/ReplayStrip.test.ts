// @vitest-environment happy-dom
import type { ClientRole } from '@ubii/client-web';
import type { Replay } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { computed, type App } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import { afterEach, describe, expect, it } from 'vitest';
import { CONNECTION } from '../../connection/connection.ts';
import { createToasts, provideToasts } from '../../ui/toasts/toasts.ts';
import ReplayStrip from './ReplayStrip.vue';
import { aReplay } from './testing/replay-page.ts';

const wrappers: { unmount(): void }[] = [];
afterEach(() => wrappers.splice(0).forEach((wrapper) => wrapper.unmount()));

async function open(path: string, replays: readonly Replay[], role: ClientRole = 'admin') {
  const page = { template: '<p />' };
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [
      { path: '/', component: page },
      { path: '/recordings/:recording?', component: page },
    ],
  });
  await router.push(path);
  const calls: unknown[] = [];
  const client = {
    role,
    call: (...call: unknown[]) => Promise.resolve(void calls.push(call)),
  };
  const connection = { client, state: computed(() => ({ status: 'connected' })) };
  const wrapper = mount(ReplayStrip, {
    props: { replays },
    global: {
      plugins: [router, (app: App) => provideToasts(app, createToasts())],
      provide: { [CONNECTION as symbol]: connection },
    },
  });
  wrappers.push(wrapper);
  return { wrapper, calls };
}

describe('the strip about replays', () => {
  it('says on every page who plays what, and stops it', async () => {
    const { wrapper, calls } = await open('/', [aReplay({ mutedCount: 3, mutedTopics: ['/a'] })]);
    expect(wrapper.text()).toContain('Ada plays recording “Study” into 2 live topics.');
    expect(wrapper.text()).toContain('topics. 3 live records on 1 topic muted so far.');
    await wrapper.find('button').trigger('click');
    expect(calls).toEqual([['replayStop', { id: 'r1' }]]);
  });

  it('leaves the replay of an opened recording to the banner of that page, but not its ghosts', async () => {
    const { wrapper } = await open('/recordings/study', [aReplay()]);
    expect(wrapper.find('[role=status]').exists()).toBe(false);
    await wrapper.setProps({ replays: [aReplay(), aReplay({ id: 'g', isGhost: true })] });
    expect(wrapper.text()).toContain('plays in a loop.');
  });

  it('leaves a session that runs again to the page of its recording', async () => {
    const session = {
      sessionId: 'l',
      name: 'Lights',
      runningId: 's',
      comparisonRecordingId: 'c',
      recordedModules: [],
      inputPrefix: '/replays/r1/in',
      outputPrefix: '/replays/r1/out',
    };
    const run = aReplay({ session });
    expect((await open('/', [run])).wrapper.text()).toContain('Session “Lights” runs again');
    const { wrapper } = await open('/recordings/study', [run]);
    expect(wrapper.find('[role=status]').exists()).toBe(false);
  });

  it('shows a replay into live topics before ghosts', async () => {
    const ghost = aReplay({ id: 'g', isGhost: true });
    const { wrapper } = await open('/', [ghost, aReplay()]);
    expect(wrapper.text()).toContain('Ada plays recording “Study” into 2 live topics.');
  });

  it('counts the others, and leads to all of them', async () => {
    const { wrapper } = await open('/', [aReplay(), aReplay({ id: 'r2' })]);
    expect(wrapper.text()).toContain('1 other replay.');
    expect(wrapper.find('a').attributes('href')).toBe('/recordings');
    expect(wrapper.find('button').exists()).toBe(false);
  });

  it('has no Stop for those who may not stop it', async () => {
    const { wrapper } = await open('/', [aReplay()], 'viewer');
    expect(wrapper.find('button').exists()).toBe(false);
  });
});
