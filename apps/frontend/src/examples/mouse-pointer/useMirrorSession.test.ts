// @vitest-environment happy-dom
import { fromJson, ServiceError, toJson, type Init, type Session } from '@ubii/proto';
import { flushPromises, mount } from '@vue/test-utils';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { computed, defineComponent, h, ref, shallowRef } from 'vue';
import { CONNECTION } from '../../connection/connection.ts';
import { fakeTopics } from '../../connection/live/testing/fake-topics.ts';
import { TAB_NODE } from '../../tab-node/tab-node.ts';
import { createToasts, provideToasts } from '../../ui/toasts/toasts.ts';
import { mirrorSession } from './mirror-session.ts';
import { useMirrorSession, type MirrorPlace, type MirrorSession } from './useMirrorSession.ts';

const whole = (spec: Init<Session>): Session =>
  fromJson('ubii.sessions.Session', toJson('ubii.sessions.Session', spec));

/** A long timeout does not slow down a passing test. */
const PATIENCE = { timeout: 20_000 };
vi.setConfig({ testTimeout: 60_000 });

let unmount: () => void = () => undefined;
afterEach(() => unmount());

/** Mocks a master that keeps the sessions it receives. */
function setup(left: Session[] = []) {
  const known = new Map(left.map((session) => [session.id, session]));
  const list = shallowRef<readonly Session[]>([...known.values()]);
  const done: string[] = [];
  let refusal: Error | undefined;
  const keep = (session: Session): Session => {
    known.set(session.id, session);
    list.value = [...known.values()];
    return session;
  };
  const call = vi.fn(async (service: string, request: Init<Session> = {}) => {
    if (service === 'sessionRuntimeGetList') return { elements: [...known.values()] };
    if (service === 'sessionRuntimeGet') return known.get(request.id!);
    const place = request.processingModules?.[0]?.nodeId ?? request.id ?? '';
    done.push(`${service.replace('sessionRuntime', '').toLowerCase()} ${place}`);
    if (refusal) throw refusal;
    if (service === 'sessionRuntimeRemove') return known.delete(request.id!);
    return keep(whole({ ...request, id: request.id || `s${known.size}` }));
  });
  const releases: string[] = [];
  const connection = {
    client: {
      id: 'ada',
      call,
      subscribe: fakeTopics().client.subscribe,
    },
    name: ref('Ada'),
    masterId: ref('run-1'),
    isConnected: computed(() => true),
    sessions: {
      list,
      find: (id: string) => list.value.find((one) => one.id === id),
      take: keep,
      drop(id: string) {
        list.value = list.value.filter((one) => one.id !== id);
      },
    },
    nodes: { watch: () => undefined },
  };
  const tab = {
    need: () => () => releases.push('released'),
    whenOn: async () => undefined,
  };
  const place = ref<MirrorPlace>({ kind: 'master' });
  let mirror!: MirrorSession;
  const wrapper = mount(
    defineComponent({
      setup() {
        mirror = useMirrorSession(place);
        return () => h('p');
      },
    }),
    {
      global: {
        provide: { [CONNECTION as symbol]: connection, [TAB_NODE as symbol]: tab },
        plugins: [(app) => provideToasts(app, createToasts())],
      },
    },
  );
  unmount = () => wrapper.unmount();
  return {
    mirror,
    place,
    done,
    releases,
    leave: () => wrapper.unmount(),
    refuse: (error: Error | undefined) => (refusal = error),
  };
}

describe('the session of the mouse pointer', () => {
  it('starts on the master, follows the choice of a place, and ends with the page', async () => {
    const { mirror, place, done, releases, leave } = setup();
    await vi.waitFor(() => expect(done).toEqual(['start master']), PATIENCE);
    expect(mirror.session.value?.name).toBe('Mouse pointer of Ada');
    place.value = { kind: 'tab' };
    await vi.waitFor(() => expect(done.at(-1)).toBe('update ada'), PATIENCE);
    place.value = { kind: 'node', nodeId: 'lab' };
    await vi.waitFor(() => expect(done.at(-1)).toBe('update lab'), PATIENCE);
    expect(releases, 'the tab is needed no longer').toEqual(['released']);
    leave();
    expect(done.at(-1)).toBe('remove s0');
  });

  it('stays where it is while no node is there', async () => {
    const { place, done } = setup();
    await vi.waitFor(() => expect(done).toHaveLength(1), PATIENCE);
    place.value = { kind: 'node', nodeId: '' };
    await flushPromises();
    expect(done).toEqual(['start master']);
  });

  it('takes away what a reload has left behind, and nothing of others', async () => {
    const facts = { clientName: 'x', module: { name: 'mirror-pointer' } };
    const mine = whole({ ...mirrorSession({ ...facts, clientId: 'ada' }), id: 'mine' });
    const theirs = whole({ ...mirrorSession({ ...facts, clientId: 'bob' }), id: 'theirs' });
    const { done } = setup([mine, theirs]);
    await vi.waitFor(() => expect(done).toEqual(['remove mine', 'start master']), PATIENCE);
  });

  it('says why it cannot, and sends it again when asked to', async () => {
    const { mirror, place, done, refuse } = setup();
    await vi.waitFor(() => expect(done).toHaveLength(1), PATIENCE);
    refuse(new ServiceError('invalid_argument', 'That node cannot run it.'));
    place.value = { kind: 'node', nodeId: 'lab' };
    await vi.waitFor(() => expect(mirror.hasFailed.value).toBe(true), PATIENCE);
    expect(mirror.trouble.value).toBe('That node cannot run it.');
    refuse(undefined);
    await mirror.restart();
    expect(mirror.hasFailed.value).toBe(false);
    expect(done.at(-1)).toBe('start lab');
  });
});
