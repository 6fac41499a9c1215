// @vitest-environment happy-dom
import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { INFO_TOPICS, ServiceError } from '@ubii/proto';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { effectScope, nextTick, ref, type EffectScope } from 'vue';
import { createSessionsStore } from './sessions-store.ts';

interface Told {
  readonly id: string;
  readonly name: string;
  readonly processingModules?: readonly string[];
  readonly extension?: { readonly revision: number };
}
type Announced = 'new' | 'change' | 'start' | 'stop' | 'running' | 'delete';

const session = (id: string, name = id, revision = 1): Told => ({
  id,
  name,
  extension: { revision },
});
const TOPICS: Readonly<Record<Announced, string>> = {
  new: INFO_TOPICS.newSession,
  change: INFO_TOPICS.changeSession,
  start: INFO_TOPICS.startSession,
  stop: INFO_TOPICS.stopSession,
  running: INFO_TOPICS.runningSession,
  delete: INFO_TOPICS.deleteSession,
};

let scope: EffectScope;
beforeEach(() => {
  vi.useFakeTimers();
  scope = effectScope();
});
afterEach(() => {
  scope.stop();
  vi.useRealTimers();
});

/** Lets replies arrive and the next frame run. */
async function settle(ms = 200): Promise<void> {
  await vi.advanceTimersByTimeAsync(ms);
  await nextTick();
}

/** Mounts a page that is connected to a fake master with these sessions. */
async function setUp(...sessions: Told[]) {
  const kept = new Map(sessions.map((one) => [one.id, one]));
  const calls: string[] = [];
  let refusal: Error | undefined;
  const call = vi.fn(async (service: string, request?: { id: string }): Promise<unknown> => {
    calls.push(request === undefined ? 'list' : request.id);
    if (refusal) throw refusal;
    if (service === 'sessionRuntimeGetList') return { elements: [...kept.values()] };
    const found = kept.get(request!.id);
    if (found === undefined) throw new ServiceError('not_found', 'There is no such session.');
    return found;
  });
  let hear: (record: { topic: string; value: Told }) => void = () => undefined;
  const subscribe = () => ({ onRecord: (fn: typeof hear) => (hear = fn) });
  const isConnected = ref(true);
  const client = { call, subscribe } as unknown as UbiiClient;
  const store = scope.run(() => createSessionsStore(client, isConnected))!;
  const announce = (what: Announced, value: Told) => hear({ topic: TOPICS[what], value });
  /** The first announcement of each topic may be a retained one; later ones are not. */
  function passRetained(): void {
    for (const what of Object.keys(TOPICS) as Announced[]) announce(what, session('long gone'));
  }
  return {
    kept,
    calls,
    call,
    store,
    isConnected,
    announce,
    passRetained,
    names: () => store.list.value?.map(({ name }) => name),
    refuse: (error: Error | undefined) => (refusal = error),
    /** Returns the calls since the last time. */
    takeCalls: () => calls.splice(0),
  };
}
/** Mounts a page that has received all retained announcements. */
async function setUpLater(...sessions: Told[]) {
  const page = await setUp(...sessions);
  page.passRetained();
  await settle();
  page.takeCalls();
  return page;
}

describe('an announcement updates the session that it names [SE-8]', () => {
  it('when it is added', async () => {
    const { announce, names, takeCalls } = await setUpLater(session('a'));
    announce('new', session('b'));
    await settle();
    expect(names()).toEqual(['a', 'b']);
    expect(takeCalls()).toEqual([]);
  });

  it('when it changes', async () => {
    const { announce, names, takeCalls, store } = await setUpLater(session('a'), session('b'));
    const other = store.find('b');
    announce('change', session('a', 'A'));
    await settle();
    expect(names()).toEqual(['A', 'b']);
    expect(store.find('b')).toBe(other);
    expect(takeCalls()).toEqual([]);
  });

  it('when it is removed', async () => {
    const { announce, names, takeCalls } = await setUpLater(session('a'), session('b'));
    announce('delete', session('a'));
    await settle();
    expect(names()).toEqual(['b']);
    expect(takeCalls()).toEqual([]);
  });

  it('when it starts and runs, by the change that comes with it', async () => {
    const { announce, names, takeCalls } = await setUpLater(session('a'));
    announce('start', session('a', 'starting'));
    announce('change', session('a', 'starting'));
    announce('change', session('a', 'running'));
    announce('running', session('a', 'running'));
    await settle();
    expect(names()).toEqual(['running']);
    expect(takeCalls()).toEqual([]);
  });

  it('when it starts or stops, by asking for it alone: one node may be told of its modules only [SE-33]', async () => {
    for (const what of ['start', 'stop'] as const) {
      const { announce, store, takeCalls } = await setUpLater(
        { ...session('a'), processingModules: ['x', 'y'] },
        session('b'),
      );
      announce(what, { ...session('a'), processingModules: ['x'] });
      await settle();
      expect(store.find('a')?.processingModules).toEqual(['x', 'y']);
      expect(takeCalls()).toEqual(['a']);
    }
  });

  it('but not when the reply that caused it came first', async () => {
    const { kept, announce, names, store } = await setUpLater(session('a', 'v1', 1));
    kept.set('a', session('a', 'v3', 3));
    store.take(session('a', 'v3', 3) as never);
    announce('change', session('a', 'v2', 2));
    await settle();
    expect(names()).toEqual(['v3']);
  });

  it('also when the reply that caused it comes after, and says less', async () => {
    const { kept, store, announce, passRetained, names } = await setUp(session('a', 'stopped'));
    await settle();
    passRetained();
    kept.set('a', session('a', 'running'));
    announce('change', session('a', 'running'));
    store.take(session('a', 'starting') as never);
    await settle();
    expect(names()).toEqual(['running']);
  });

  it('as often as it says in a burst, drawn once a frame and without a question', async () => {
    const { announce, names, takeCalls, store } = await setUpLater(session('a'));
    const before = store.list.value;
    for (let name = 1; name <= 100; name++) announce('change', session('a', `${name}`));
    expect(store.list.value).toBe(before);
    await settle();
    expect(names()).toEqual(['100']);
    expect(takeCalls()).toEqual([]);
  });

  it('of a burst of starts asks once for each session, of too many for the list', async () => {
    const many = Array.from({ length: 9 }, (_, index) => session(`s${index}`));
    const { announce, takeCalls } = await setUpLater(...many);
    for (const one of many.slice(0, 8))
      for (let again = 0; again < 3; again++) announce('start', one);
    await settle();
    expect(takeCalls()).toEqual(many.slice(0, 8).map(({ id }) => id));
    for (const one of many) announce('start', one);
    await settle();
    expect(takeCalls()).toEqual(['list']);
  });
});

describe('an announcement that may be retained', () => {
  it('of a session that is gone shows nothing', async () => {
    const { announce, names, takeCalls } = await setUp(session('a'));
    for (const what of ['change', 'start', 'stop', 'running', 'delete'] as const) {
      announce(what, session('gone'));
    }
    await settle();
    expect(names()).toEqual(['a']);
    expect(takeCalls()).toEqual(['list']);
  });

  it('of a session of the list asks for that one, in whatever order they come', async () => {
    for (const isEarly of [true, false]) {
      const { announce, names, takeCalls, store } = await setUp(session('a', 'v4', 4));
      if (!isEarly) await settle();
      announce('change', session('a', 'v3', 3));
      expect(store.find('a')?.name).not.toBe('v3');
      await settle();
      expect(names()).toEqual(['v4']);
      expect(takeCalls()).toEqual(['list', 'a']);
    }
  });

  it('of one that the list does not have asks for the list again: it may be new', async () => {
    const { announce, names, kept, takeCalls } = await setUp(session('a'));
    await settle();
    kept.set('b', session('b'));
    announce('new', session('b'));
    await settle();
    expect(names()).toEqual(['a', 'b']);
    expect(takeCalls()).toEqual(['list', 'list']);
  });

  it('of a removal asks for the list only when the list has the session', async () => {
    const { announce, names, kept, takeCalls } = await setUp(session('a'));
    await settle();
    kept.delete('a');
    announce('delete', session('a'));
    await settle();
    expect(names()).toEqual([]);
    expect(takeCalls()).toEqual(['list', 'list']);
  });
});

describe('the list of sessions', () => {
  it('is asked for again after a reconnect, by whatever revisions', async () => {
    const { isConnected, kept, names, takeCalls, announce } = await setUpLater(
      session('a', 'v5', 5),
    );
    isConnected.value = false;
    await settle();
    kept.clear();
    kept.set('b', session('b'));
    kept.set('a', session('a', 'v1', 1));
    isConnected.value = true;
    await settle();
    expect(names()).toEqual(['b', 'v1']);
    expect(takeCalls()).toEqual(['list']);
    // Retained announcements are received again.
    announce('change', session('a', 'v0', 0));
    expect(names()).toEqual(['b', 'v1']);
  });

  it('is older than what was announced while it was on its way', async () => {
    const { isConnected, kept, names, call, announce } = await setUpLater(
      session('a'),
      session('b'),
    );
    let answer: (list: object) => void = () => undefined;
    call.mockImplementationOnce(() => new Promise((resolve) => (answer = resolve)));
    isConnected.value = false;
    await settle();
    isConnected.value = true;
    await settle();
    const older = [...kept.values()];
    kept.delete('b');
    kept.set('a', session('a', 'newest'));
    announce('change', session('a', 'newer'));
    announce('delete', session('b'));
    announce('change', session('a', 'newest'));
    answer({ elements: older });
    await settle(20);
    expect(names()?.[0]).toBe('newest');
    await settle();
    expect(names()).toEqual(['newest']);
  });

  it('does not take back a session that was made or removed meanwhile', async () => {
    const { kept, isConnected, names, call, store } = await setUpLater(session('a'));
    let answer: (list: object) => void = () => undefined;
    call.mockImplementationOnce(() => new Promise((resolve) => (answer = resolve)));
    isConnected.value = false;
    await settle();
    isConnected.value = true;
    await settle();
    kept.set('made', session('made'));
    store.take(session('made') as never);
    store.drop('a');
    answer({ elements: [session('a')] });
    await settle();
    expect(names()).toEqual(['made']);
  });

  it('takes what a service answered at once', async () => {
    const { store, names } = await setUpLater();
    store.take(session('made') as never);
    await settle(20);
    expect(names()).toEqual(['made']);
    store.drop('made');
    await settle(20);
    expect(names()).toEqual([]);
  });

  it('comes in place of one session that cannot be asked for', async () => {
    const { announce, call, takeCalls, store } = await setUpLater(session('a'));
    call.mockRejectedValueOnce(new ServiceError('unimplemented', 'No such service.'));
    announce('stop', session('a'));
    await settle();
    expect(takeCalls()).toEqual(['list']);
    expect(store.error.value).toBeUndefined();
  });

  it('says why there is none', async () => {
    const page = await setUp();
    page.refuse(new ServiceError('unimplemented', 'No such service.'));
    page.isConnected.value = false;
    await nextTick();
    page.isConnected.value = true;
    await settle();
    expect(page.store.error.value?.message).toBe('No such service.');
    page.refuse(new ConnectionError('closed', 'Gone.'));
    page.announce('new', session('a'));
    await settle();
    expect(page.store.error.value?.message).toBe('No such service.');
  });
  it('has a session requested again when no reply came while the connection stayed open', async () => {
    const page = await setUpLater(session('a'));
    page.refuse(new ConnectionError('timeout', 'No reply.'));
    page.announce('stop', session('a'));
    await settle();
    page.refuse(undefined);
    page.kept.set('a', session('a', 'Renamed', 2));
    page.takeCalls();
    await settle(2000);
    expect(page.takeCalls()).toEqual(['a']);
    expect(page.names()).toEqual(['Renamed']);
  });

  it('is requested again itself, too', async () => {
    const page = await setUp(session('a'));
    page.refuse(new ConnectionError('timeout', 'No reply.'));
    await settle();
    page.isConnected.value = false;
    await nextTick();
    page.isConnected.value = true;
    await settle();
    page.refuse(undefined);
    page.takeCalls();
    await settle(2000);
    expect(page.takeCalls()).toEqual(['list']);
  });
});
