import { settle } from '@ubii/timing/testing';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { createTestClient } from '../testing/create-test-client.ts';
import { FakeMaster } from '../testing/fake-master.ts';
import { followPageEvents } from './page-events.ts';

afterEach(() => {
  vi.unstubAllGlobals();
});

/** A connected client of a page whose network goes. */
async function setup() {
  const page = new EventTarget();
  const shown = Object.assign(new EventTarget(), { visibilityState: 'visible' });
  const network = new EventTarget();
  vi.stubGlobal('navigator', { connection: network });
  vi.stubGlobal('window', page);
  vi.stubGlobal('document', shown);
  const master = new FakeMaster();
  const all = createTestClient(master, { reconnect: { initialDelayMs: 60_000 } });
  followPageEvents(all.client);
  await all.client.connect();
  const lose = async (): Promise<void> => {
    master.drop();
    await settle();
    expect(all.client.state.status).toBe('reconnecting');
  };
  return { page, shown, network, master, lose, ...all };
}

describe('followPageEvents()', () => {
  it.each([
    ['page', 'online'],
    ['page', 'pageshow'],
    ['shown', 'resume'],
    ['network', 'change'],
  ] as const)('tries at once when the %s says "%s" [CL-41]', async (target, type) => {
    const { client, lose, ...targets } = await setup();
    await lose();
    targets[target].dispatchEvent(new Event(type));
    await settle();
    expect(client.state.status).toBe('connected');
  });

  it('tries at once when the page is shown, not when it is hidden', async () => {
    const { shown, client, lose } = await setup();
    await lose();
    shown.visibilityState = 'hidden';
    shown.dispatchEvent(new Event('visibilitychange'));
    await settle();
    expect(client.state.status).toBe('reconnecting');
    shown.visibilityState = 'visible';
    shown.dispatchEvent(new Event('visibilitychange'));
    await settle();
    expect(client.state.status).toBe('connected');
  });

  it.each(['online', 'offline'])(
    'makes sure on "%s" that a link is alive [CL-42]',
    async (type) => {
      const { page, master, client, clock } = await setup();
      master.isSilent = true;
      page.dispatchEvent(new Event(type));
      await clock.advance(1_000);
      expect(client.state).toMatchObject({ status: 'reconnecting', error: { reason: 'timeout' } });
    },
  );

  it('leaves when the page ends, and not when it is kept [EX-55]', async () => {
    const { page, shown, master, client } = await setup();
    page.addEventListener('pagehide', (event) => {
      if (!(event as PageTransitionEvent).persisted) client.publish('/last/words', 'string', 'bye');
    });
    page.dispatchEvent(Object.assign(new Event('pagehide'), { persisted: true }));
    await settle();
    expect(client.state.status).toBe('connected');
    page.dispatchEvent(Object.assign(new Event('pagehide'), { persisted: false }));
    shown.visibilityState = 'hidden';
    shown.dispatchEvent(new Event('visibilitychange'));
    await settle();
    expect(client.state).toEqual({ status: 'closed', error: undefined });
    expect(master.published).toMatchObject([{ topic: '/last/words' }]);
    expect(master.farewells).toEqual([{ clientId: 'client-1', code: 4000 }]);
  });

  it('leaves when a page ends that was hidden before [EX-55]', async () => {
    const { page, shown, master } = await setup();
    shown.visibilityState = 'hidden';
    shown.dispatchEvent(new Event('visibilitychange'));
    await settle();
    expect(master.farewells).toEqual([]);
    page.dispatchEvent(Object.assign(new Event('pagehide'), { persisted: false }));
    await settle();
    expect(master.farewells).toEqual([{ clientId: 'client-1', code: 4000 }]);
  });

  it('does nothing for a client that is closed', async () => {
    const { page, client } = await setup();
    const retry = vi.spyOn(client, 'retryNow');
    await client.close();
    page.dispatchEvent(new Event('online'));
    expect(retry).not.toHaveBeenCalled();
  });

  it('does nothing where there is no page', async () => {
    vi.unstubAllGlobals();
    const { client } = createTestClient(new FakeMaster());
    followPageEvents(client);
    await client.connect();
    expect(client.state.status).toBe('connected');
  });
});
