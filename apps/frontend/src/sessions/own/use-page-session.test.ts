// @vitest-environment happy-dom
import { fromJson, ServiceError, toJson, type Init, type Session } from '@ubii/proto';
import { flushPromises, mount } from '@vue/test-utils';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { computed, defineComponent, h, shallowRef } from 'vue';
import { CONNECTION } from '../../connection/connection.ts';
import { TAB_NODE } from '../../tab-node/tab-node.ts';
import type { SessionPlan } from './planned-session.ts';
import { usePageSession, type PageSession } from './use-page-session.ts';

let unmount: () => void = () => undefined;
afterEach(() => unmount());

const planOn = (place: string): SessionPlan => ({
  place,
  session: { name: 'Seeing', processingModules: [{ name: 'eyes' }] },
});

/** A page with a session, at a master that keeps the sessions it is given. */
function setup(first?: SessionPlan) {
  const list = shallowRef<readonly Session[]>([]);
  const done: string[] = [];
  const releases: string[] = [];
  let refusal: Error | undefined;
  const call = vi.fn(async (service: string, request: Init<Session>) => {
    const place = request.processingModules?.[0]?.nodeId ?? request.id ?? '';
    done.push(`${service.replace('sessionRuntime', '').toLowerCase()} ${place}`);
    if (refusal) throw refusal;
    const json = toJson('ubii.sessions.Session', { ...request, id: 's1' });
    return fromJson('ubii.sessions.Session', json);
  });
  const sessions = {
    list,
    find: (id: string) => list.value.find((one) => one.id === id),
    take: (session: Session) => (list.value = [session]),
    drop: () => (list.value = []),
  };
  const connection = { client: { id: 'ada', call }, isConnected: computed(() => true), sessions };
  const tab = { need: () => () => releases.push('released'), whenOn: async () => undefined };
  const plan = shallowRef(first);
  const onFailure = vi.fn();
  let page!: PageSession;
  const wrapper = mount(
    defineComponent({
      setup() {
        page = usePageSession(() => plan.value, onFailure);
        return () => h('p');
      },
    }),
    { global: { provide: { [CONNECTION as symbol]: connection, [TAB_NODE as symbol]: tab } } },
  );
  unmount = () => wrapper.unmount();
  return {
    page,
    plan,
    done,
    releases,
    onFailure,
    leave: () => wrapper.unmount(),
    refuse: (error: Error) => (refusal = error),
  };
}

describe('usePageSession', () => {
  it('starts with a plan, moves with it, and ends without one', async () => {
    const { page, plan, done, releases } = setup();
    await flushPromises();
    expect(done).toEqual([]);
    plan.value = planOn('tab');
    await flushPromises();
    expect(page.session.value?.name).toBe('Seeing');
    plan.value = planOn('master');
    await flushPromises();
    expect(releases, 'the tab is needed no longer').toEqual(['released']);
    plan.value = undefined;
    await flushPromises();
    expect(done).toEqual(['start ada', 'update master', 'remove s1']);
    expect(page.session.value).toBeUndefined();
  });

  it('sends nothing for a plan that is made anew and says the same', async () => {
    const { plan, done } = setup(planOn('master'));
    await flushPromises();
    plan.value = planOn('master');
    await flushPromises();
    expect(done).toEqual(['start master']);
  });

  it('ends with the page', async () => {
    const { done, leave } = setup(planOn('master'));
    await flushPromises();
    leave();
    expect(done.at(-1)).toBe('remove s1');
  });

  it('says why a plan could not be carried out, and keeps what runs', async () => {
    const { page, plan, refuse, onFailure } = setup(planOn('master'));
    await flushPromises();
    refuse(new ServiceError('invalid_argument', 'That node cannot run it.'));
    plan.value = planOn('lab');
    await flushPromises();
    expect(page.trouble.value).toBe('That node cannot run it.');
    expect(onFailure).toHaveBeenCalledOnce();
    expect(page.session.value?.id).toBe('s1');
  });
});
