// @vitest-environment happy-dom
import { fromJson, ServiceError, toJson, type Init, type Session } from '@ubii/proto';
import { flushPromises, mount } from '@vue/test-utils';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { computed, defineComponent, h, shallowRef } from 'vue';
import { CONNECTION } from '../../connection/connection.ts';
import { TAB_NODE } from '../../tab-node/tab-node.ts';
import { createToasts, provideToasts } from '../../ui/toasts/toasts.ts';
import type { SessionPlan } from './planned-session.ts';
import type { PageLife, PageSession } from './page-session.ts';
import { useOwnedSession } from './useOwnedSession.ts';

let unmount: () => void = () => undefined;
afterEach(() => unmount());

const planOn = (place: string): SessionPlan => ({
  place,
  session: { name: 'Seeing', processingModules: [{ name: 'eyes' }] },
});

/** Mounts a page with a session, on a mock master that keeps the sessions it receives. */
function setup(first?: SessionPlan, isKept?: PageLife['isKept']) {
  const list = shallowRef<readonly Session[]>([]);
  const done: string[] = [];
  const releases: string[] = [];
  let refusal: Error | undefined;
  /** Sessions on the master, which the page may not know yet. */
  let kept = new Set<string>();
  const masterId = shallowRef('run-1');
  let runId = masterId.value;
  const call = vi.fn(async (service: string, request: Init<Session> = {}) => {
    if (service === 'serverConfiguration') return { id: runId };
    if (service === 'sessionRuntimeGetList') return { elements: [...kept].map((id) => ({ id })) };
    const place = request.processingModules?.[0]?.nodeId ?? request.id ?? '';
    done.push(`${service.replace('sessionRuntime', '').toLowerCase()} ${place}`);
    if (refusal) throw refusal;
    if (service === 'sessionRuntimeUpdate' && !kept.has(request.id!)) {
      throw new ServiceError('not_found', 'No session has this id.');
    }
    if (service === 'sessionRuntimeStart') kept.add('s1');
    const json = toJson('ubii.sessions.Session', { ...request, id: 's1' });
    return fromJson('ubii.sessions.Session', json);
  });
  const sessions = {
    list,
    find: (id: string) => list.value.find((one) => one.id === id),
    take: (session: Session) => (list.value = [session]),
    drop: () => (list.value = []),
  };
  const isUp = shallowRef(true);
  const isConnected = computed(() => isUp.value);
  const connection = { client: { id: 'ada', call }, isConnected, sessions, masterId };
  const toasts = createToasts();
  const tab = { need: () => () => releases.push('released'), whenOn: async () => undefined };
  const plan = shallowRef(first);
  const onFailure = vi.fn();
  let page!: PageSession;
  const wrapper = mount(
    defineComponent({
      setup() {
        page = useOwnedSession({
          life: 'page',
          spec: () => plan.value,
          onFailure,
          ...(isKept && { isKept }),
        });
        return () => h('p');
      },
    }),
    {
      global: {
        provide: { [CONNECTION as symbol]: connection, [TAB_NODE as symbol]: tab },
        plugins: [(app) => provideToasts(app, toasts)],
      },
    },
  );
  unmount = () => wrapper.unmount();
  return {
    page,
    plan,
    done,
    releases,
    onFailure,
    toasts,
    list,
    /** Removes the session on the master, as another client does. */
    removeByOther: () => {
      kept = new Set();
      list.value = [];
    },
    /** The page reconnects before it learns that its session is gone. */
    async restartMaster() {
      isUp.value = false;
      await flushPromises();
      kept = new Set();
      runId = 'run-2';
      isUp.value = true;
      await flushPromises();
    },
    leave: () => wrapper.unmount(),
    refuse: (error: Error | undefined) => (refusal = error),
  };
}

describe('useOwnedSession for a page', () => {
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

  it('sends nothing for a plan that is made again and says the same', async () => {
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

  it('starts again when asked to, as it is planned now, once', async () => {
    const { page, plan, done } = setup(planOn('master'));
    await flushPromises();
    plan.value = planOn('lab');
    await page.restart();
    await flushPromises();
    expect(done).toEqual(['start master', 'remove s1', 'start lab']);
  });

  it('leaves a session that is to be kept', async () => {
    const { plan, done, leave } = setup(planOn('master'), ({ id }) => id === 's1');
    await flushPromises();
    leave();
    plan.value = undefined;
    await flushPromises();
    expect(done).toEqual(['start master']);
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
    refuse(undefined);
    plan.value = planOn('master');
    await flushPromises();
    expect(page.trouble.value).toBeUndefined();
  });

  it('starts its session again after a restart of the master, and tells the user', async () => {
    const { page, done, toasts, onFailure, restartMaster } = setup(planOn('master'));
    await flushPromises();
    await restartMaster();
    expect(done).toEqual(['start master', 'update master', 'start master']);
    expect(onFailure).not.toHaveBeenCalled();
    expect(page.trouble.value).toBeUndefined();
    expect(page.session.value?.name).toBe('Seeing');
    expect(toasts.list.value.map(({ text }) => text)).toEqual([
      'The master was restarted. This page started its session “Seeing” again.',
    ]);
  });

  it('says after a restart why its session did not start again', async () => {
    const { page, refuse, onFailure, restartMaster, removeByOther } = setup(planOn('lab'));
    await flushPromises();
    removeByOther();
    refuse(new ServiceError('not_found', 'No node has the id "lab".'));
    await restartMaster();
    expect(page.trouble.value).toBe(
      'The restart of the master ended the session. It could not start again: No node has the id "lab".',
    );
    expect(onFailure).toHaveBeenCalled();
    expect(page.session.value).toBeUndefined();
  });

  it('does not bring back a session that another client removed, and says so', async () => {
    const { page, done, toasts, onFailure, removeByOther } = setup(planOn('master'));
    await flushPromises();
    removeByOther();
    await flushPromises();
    expect(done).toEqual(['start master']);
    expect(page.trouble.value).toBe('Another client deleted the session of this page.');
    expect(onFailure).toHaveBeenCalledOnce();
    expect(toasts.list.value).toEqual([]);
  });

  it('keeps the reason when the page ends the plan because of it', async () => {
    const { page, plan, onFailure, refuse } = setup();
    onFailure.mockImplementation(() => (plan.value = undefined));
    refuse(new ServiceError('resource_exhausted', 'There is no room.'));
    plan.value = planOn('master');
    await flushPromises();
    expect(plan.value).toBeUndefined();
    expect(page.trouble.value).toBe('There is no room.');
  });
});
