import { afterEach, describe, expect, it, vi } from 'vitest';
import { createTestClient } from '../testing/create-test-client.ts';
import { settle } from '../testing/fake-clock.ts';
import { FakeMaster } from '../testing/fake-master.ts';
import { retryOnPageEvents } from './page-events.ts';

afterEach(() => {
  vi.unstubAllGlobals();
});

/** A connected client of a page whose network goes. */
async function setup() {
  const page = new EventTarget();
  const shown = Object.assign(new EventTarget(), { visibilityState: 'visible' });
  vi.stubGlobal('window', page);
  vi.stubGlobal('document', shown);
  const master = new FakeMaster();
  const all = createTestClient(master, { reconnect: { initialDelayMs: 60_000 } });
  retryOnPageEvents(all.client);
  await all.client.connect();
  const lose = async (): Promise<void> => {
    master.drop();
    await settle();
    expect(all.client.state.status).toBe('reconnecting');
  };
  return { page, shown, master, lose, ...all };
}

describe('retryOnPageEvents()', () => {
  it.each(['online', 'pageshow'])('tries at once on "%s"', async (type) => {
    const { page, client, lose } = await setup();
    await lose();
    page.dispatchEvent(new Event(type));
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

  it('makes sure that the link is alive when it seems to be', async () => {
    const { page, master, client, clock } = await setup();
    master.isSilent = true;
    page.dispatchEvent(new Event('online'));
    await clock.advance(2_000);
    expect(client.state).toMatchObject({ status: 'reconnecting', error: { reason: 'timeout' } });
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
    retryOnPageEvents(client);
    await client.connect();
    expect(client.state.status).toBe('connected');
  });
});
