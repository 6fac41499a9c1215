import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { describeIdentityStorage } from '../testing/identity-storage-suite.ts';
import { claimIdentity } from './identity-claim.ts';
import type { Release } from './identity-claim.ts';
import { createTabIdentity } from './tab-identity.ts';

const ADA = { clientId: 'ada-1', resumeToken: 'token' };

/** The part of the Storage interface that is used. */
class TabStorage {
  readonly #entries: Map<string, string>;

  constructor(entries: Iterable<[string, string]> = []) {
    this.#entries = new Map(entries);
  }

  getItem(key: string): string | null {
    return this.#entries.get(key) ?? null;
  }

  setItem(key: string, text: string): void {
    this.#entries.set(key, text);
  }

  removeItem(key: string): void {
    this.#entries.delete(key);
  }

  duplicate(): TabStorage {
    return new TabStorage(this.#entries);
  }
}

/** The locks of one origin; `closePage` frees what a page holds, as a browser does. */
class Locks {
  readonly #held = new Set<string>();
  #waiting: (() => void)[] = [];
  #page: (() => void)[] = [];
  /** Pending work of a busy computer. */
  busy: Promise<void> | undefined;

  query(): Promise<{ pending: { name: string }[] }> {
    return Promise.resolve({ pending: this.#waiting.map(() => ({ name: 'ubii.identity.ada-1' })) });
  }

  async request(
    name: string,
    { signal }: { signal: AbortSignal },
    callback: () => Promise<void>,
  ): Promise<void> {
    if (this.busy !== undefined) await this.busy;
    while (this.#held.has(name)) {
      await new Promise<void>((resolve, reject) => {
        this.#waiting.push(resolve);
        signal.addEventListener('abort', () => reject(new Error('timed out')));
      });
    }
    this.#held.add(name);
    const release = (): void => {
      this.#held.delete(name);
      const waiting = this.#waiting;
      this.#waiting = [];
      for (const wake of waiting) wake();
    };
    this.#page.push(release);
    await callback();
    release();
  }

  /** From now on pages are other pages; the ones before keep what they hold until `end` is called. */
  nextPage(): () => void {
    const page = this.#page;
    this.#page = [];
    return () => {
      for (const release of page) release();
    };
  }
}

let locks: Locks;

beforeEach(() => {
  locks = new Locks();
  vi.stubGlobal('sessionStorage', new TabStorage());
  vi.stubGlobal('navigator', { locks });
});

afterEach(() => {
  vi.unstubAllGlobals();
});

describeIdentityStorage('a tab', () => ({
  nextRun() {
    locks.nextPage()();
    return createTabIdentity();
  },
  close: () => undefined,
}));

describe('createTabIdentity()', () => {
  it('gives a duplicated tab no identity of another', async () => {
    createTabIdentity().save(ADA);
    await Promise.resolve();
    locks.nextPage();
    vi.stubGlobal('sessionStorage', (sessionStorage as unknown as TabStorage).duplicate());
    const duplicate = createTabIdentity();
    expect(await duplicate.load()).toBeUndefined();
    duplicate.save({ clientId: 'ben-1', resumeToken: 'other' });
    locks.nextPage()();
    expect(await createTabIdentity().load()).toEqual({ clientId: 'ben-1', resumeToken: 'other' });
  });

  it('waits a moment for the page before the reload to let go', async () => {
    createTabIdentity().save(ADA);
    await Promise.resolve();
    const endEarlierPage = locks.nextPage();
    const loading = createTabIdentity().load();
    endEarlierPage();
    expect(await loading).toEqual(ADA);
  });

  it('is itself on a machine that is too busy to answer, however long that takes', async () => {
    vi.useFakeTimers();
    createTabIdentity().save(ADA);
    await Promise.resolve();
    locks.nextPage()();
    let goOn = (): void => undefined;
    locks.busy = new Promise((resolve) => (goOn = resolve));
    const loading = createTabIdentity().load();
    await vi.advanceTimersByTimeAsync(10_000);
    goOn();
    expect(await loading).toEqual(ADA);
    expect(vi.getTimerCount()).toBe(0);
    vi.useRealTimers();
  });

  it('frees an identity that was given up', async () => {
    const storage = createTabIdentity();
    storage.save(ADA);
    await Promise.resolve();
    storage.save(undefined);
    await Promise.resolve();
    expect(await claimIdentity(ADA.clientId)).toBeDefined();
  });

  it('keeps the identities of several clients of a page apart', async () => {
    createTabIdentity('one').save(ADA);
    locks.nextPage()();
    expect(await createTabIdentity('two').load()).toBeUndefined();
    expect(await createTabIdentity('one').load()).toEqual(ADA);
  });

  it.each(['no JSON', '{}', '{"clientId":""}', '{"clientId":7}', 'null'])(
    'takes %s for nothing',
    async (text) => {
      sessionStorage.setItem('ubii.identity', text);
      expect(await createTabIdentity().load()).toBeUndefined();
    },
  );

  it('does without a storage where it is blocked', async () => {
    vi.stubGlobal('sessionStorage', undefined);
    const storage = createTabIdentity();
    storage.save(ADA);
    expect(await storage.load()).toBeUndefined();
  });
});

/** Channels of one origin; a page that has ended says nothing more. */
class Channel {
  static readonly open = new Set<Channel>();
  onmessage: ((event: { data: unknown }) => void) | undefined;
  readonly name: string;

  constructor(name: string) {
    this.name = name;
    Channel.open.add(this);
  }

  postMessage(data: unknown): void {
    for (const other of Channel.open) {
      if (other === this || other.name !== this.name) continue;
      queueMicrotask(() => Channel.open.has(other) && other.onmessage?.({ data }));
    }
  }

  close(): void {
    Channel.open.delete(this);
  }
}

describe.each([
  ['with locks', true],
  ['over plain HTTP, without locks', false],
])('claimIdentity() on a busy machine, %s', (_where, hasLocks) => {
  let page: EventTarget;

  beforeEach(() => {
    vi.useFakeTimers();
    Channel.open.clear();
    page = new EventTarget();
    vi.stubGlobal('BroadcastChannel', Channel);
    vi.stubGlobal('window', page);
    vi.stubGlobal('navigator', hasLocks ? { locks } : {});
  });

  afterEach(() => {
    vi.useRealTimers();
  });

  /** The page that has the identity, and how it ends: it first stops to answer, and is gone later. */
  async function openFirstPage() {
    const claimed = claimIdentity(ADA.clientId);
    await vi.advanceTimersByTimeAsync(1_000);
    expect(await claimed).toBeDefined();
    const endOfLocks = locks.nextPage();
    const channels = [...Channel.open];
    return {
      hide: () => page.dispatchEvent(new Event('pagehide')),
      end: () => {
        endOfLocks();
        for (const channel of channels) channel.close();
      },
    };
  }

  it('a reloaded page waits for a predecessor that takes seconds to end', async () => {
    const first = await openFirstPage();
    first.hide();
    const claimed = claimIdentity(ADA.clientId);
    await vi.advanceTimersByTimeAsync(hasLocks ? 3_000 : 100);
    first.end();
    await vi.advanceTimersByTimeAsync(1_000);
    expect(await claimed).toBeDefined();
  });

  it('a reloaded page that asks before its predecessor knows of its end is not sent away', async () => {
    const first = await openFirstPage();
    const claimed = claimIdentity(ADA.clientId);
    await vi.advanceTimersByTimeAsync(10); // it has answered
    first.hide();
    await vi.advanceTimersByTimeAsync(400);
    first.end();
    await vi.advanceTimersByTimeAsync(1_000);
    expect(await claimed).toBeDefined();
  });

  it('a duplicated page is told by the first one, which is there', async () => {
    await openFirstPage();
    const claimed = claimIdentity(ADA.clientId);
    await vi.advanceTimersByTimeAsync(1_000);
    expect(await claimed).toBeUndefined();
  });
});

describe('claimIdentity() where there are no locks', () => {
  const releases: Release[] = [];
  const claim = async (): Promise<boolean> => {
    const release = await claimIdentity('eva-1');
    if (release !== undefined) releases.push(release);
    return release !== undefined;
  };

  afterEach(() => {
    for (const release of releases.splice(0)) release();
  });

  it('asks the other pages', async () => {
    vi.stubGlobal('navigator', {});
    expect(await claim()).toBe(true);
    expect(await claim()).toBe(false);
    for (const release of releases.splice(0)) release();
    expect(await claim()).toBe(true);
  });

  it('claims at once where pages cannot be asked either', async () => {
    vi.stubGlobal('navigator', undefined);
    vi.stubGlobal('BroadcastChannel', undefined);
    expect(await claim()).toBe(true);
  });
});
