// @vitest-environment happy-dom
import { fromJson, ServiceError, SessionState, toJson, type Init, type Session } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h, shallowRef } from 'vue';
import { CONNECTION } from '../../connection/connection.ts';
import { useSessionActions } from '../actions/useSessionActions.ts';
import { createToasts, provideToasts } from '../../ui/toasts/toasts.ts';
import type { LastingLife, LastingSession } from './lasting-session.ts';
import { useOwnedSession } from './useOwnedSession.ts';

let unmount: () => void = () => undefined;
afterEach(() => unmount());

const whole = (spec: Init<Session>): Session =>
  fromJson('ubii.sessions.Session', toJson('ubii.sessions.Session', spec));
const inState = (id: string, state: SessionState): Session =>
  whole({ id, name: 'Sine', extension: { state } });
const { SESSION_RUNNING, SESSION_STARTING, SESSION_STOPPED } = SessionState;

/** Mounts a page on a mock master with these sessions. */
function setup(life: LastingLife['life'], there: readonly Session[] = []) {
  const list = shallowRef(there);
  const done: string[] = [];
  let refusal: Error | undefined;
  const take = (session: Session): void => {
    list.value = [...list.value.filter(({ id }) => id !== session.id), session];
  };
  const call = vi.fn(async (service: string, request: Init<Session> = {}) => {
    if (refusal) throw refusal;
    if (service.endsWith('GetList')) return { elements: list.value };
    done.push(`${service} ${request.id || request.name}`);
    const session = whole({ ...request, id: request.id || 'new' });
    if (service === 'sessionDatabaseSave') return { elements: [session] };
    if (service === 'sessionRuntimeStart') take(session);
    return session;
  });
  const sessions = {
    list,
    find: (id: string) => list.value.find((one) => one.id === id),
    take,
    drop(id: string) {
      list.value = list.value.filter((one) => one.id !== id);
    },
  };
  let owned!: LastingSession;
  const wrapper = mount(
    defineComponent({
      setup() {
        const options = {
          isOwn: ({ name }: Session) => name === 'Sine',
          spec: () => ({ name: 'Sine' }),
        };
        owned =
          life === 'shared'
            ? useOwnedSession({ life, ...options })
            : useOwnedSession({ life, calls: useSessionActions().calls, ...options });
        return () => h('p');
      },
    }),
    {
      global: {
        provide: { [CONNECTION as symbol]: { client: { id: 'ada', call }, sessions } },
        plugins: [(app) => provideToasts(app, createToasts())],
      },
    },
  );
  unmount = () => wrapper.unmount();
  return { owned, done, call, list, take, refuse: (error: Error) => (refusal = error) };
}

describe('useOwnedSession for a lasting session', () => {
  it('is found again among others, the running one first', () => {
    const stopped = inState('a', SESSION_STOPPED);
    const other = whole({ id: 'c', name: 'Other' });
    const { owned, take } = setup('stored', [other]);
    expect(owned.session.value).toBeUndefined();
    take(stopped);
    expect(owned.session.value).toEqual(stopped);
    take(inState('b', SESSION_RUNNING));
    expect(owned.session.value?.id).toBe('b');
    expect(owned.isRunning.value).toBe(true);
  });

  it('starts a shared session that restarts with the master, and stops it', async () => {
    const { owned, done, call } = setup('shared');
    const session = await owned.start();
    expect(session?.extension?.startWithMaster).toBe(true);
    await owned.stop();
    expect(done).toEqual(['sessionRuntimeStart Sine', 'sessionRuntimeStop new']);
    expect(call).toHaveBeenCalledWith('sessionRuntimeStop', { id: 'new' });
  });

  it('starts the existing one, and leaves one that starts already as it is', async () => {
    const stopped = setup('shared', [inState('a', SESSION_STOPPED)]);
    expect((await stopped.owned.start())?.id).toBe('a');
    expect(stopped.done).toEqual(['sessionRuntimeStart a']);
    unmount();
    const starting = setup('shared', [inState('a', SESSION_STARTING)]);
    expect((await starting.owned.start())?.id).toBe('a');
    expect(starting.done).toEqual([]);
  });

  it('keeps one of two that clients started at the same time', async () => {
    const { owned, done, call, take } = setup('shared');
    const answer = call.getMockImplementation()!;
    call.mockImplementation(async (service, request) => {
      if (service === 'sessionRuntimeStart') take(inState('first', SESSION_RUNNING));
      return answer(service, request);
    });
    expect((await owned.start())?.id).toBe('first');
    expect(done).toEqual(['sessionRuntimeStart Sine', 'sessionRuntimeRemove new']);
  });

  it('stores a stored session before it starts', async () => {
    const { owned, done } = setup('stored');
    const ready: string[] = [];
    const session = await owned.start(({ id }) => ready.push(`${id} after ${done.length}`));
    expect(session?.id).toBe('new');
    expect(ready).toEqual(['new after 1']);
    expect(done).toEqual(['sessionDatabaseSave Sine', 'sessionRuntimeStart new']);
  });

  it('creates a stored session without starting it', async () => {
    const { owned, done } = setup('stored');
    expect((await owned.create())?.id).toBe('new');
    expect(done).toEqual(['sessionDatabaseSave Sine']);
  });

  it('says why it did not start', async () => {
    const { owned, refuse } = setup('shared');
    refuse(new ServiceError('permission_denied', 'Viewers cannot start sessions.'));
    expect(await owned.start()).toBeUndefined();
    expect(owned.trouble.value).toBe('Viewers cannot start sessions.');
  });
});
