/**
 * How long to wait for an identity somebody else holds, milliseconds. A page that is being reloaded
 * gives it free a moment after its successor asks, on a busy phone a second; a duplicated tab never
 * does. Who waits too short leaves a client behind that is gone without a word.
 */
const LOCK_WAIT_MS = 1500;
/** How long others have to object, milliseconds. A message between pages takes one or two; every reload waits this long. */
const OBJECTION_WAIT_MS = 150;

/** Gives the claim free; calling it again does nothing. */
export type Release = () => void;

/**
 * Claims an identity for this page, against other pages of the same origin.
 * @returns how to give it free, or `undefined` when another page has it
 */
export function claimIdentity(clientId: string): Promise<Release | undefined> {
  const name = `ubii.identity.${clientId}`;
  // Web Locks exist in secure contexts only, and a phone often sees the master over plain HTTP.
  if (globalThis.navigator?.locks !== undefined) return claimByLock(navigator.locks, name);
  if (globalThis.BroadcastChannel !== undefined) return claimByChannel(name);
  return Promise.resolve(() => undefined);
}

function claimByLock(locks: LockManager, name: string): Promise<Release | undefined> {
  let release: Release = () => undefined;
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  const asking = new AbortController();
  return new Promise((resolve) => {
    const timer = setInterval(() => {
      void isWaitedFor(locks, name).then((waits) => waits && asking.abort());
    }, LOCK_WAIT_MS);
    locks
      .request(name, { signal: asking.signal }, () => {
        resolve(release);
        clearInterval(timer);
        return held;
      })
      .catch(() => resolve(undefined)) // given up: the lock is taken
      .finally(() => clearInterval(timer));
  });
}

/** Whether somebody waits for a lock. Nobody does while a busy machine is slow to give a free one. */
async function isWaitedFor(locks: LockManager, lock: string): Promise<boolean> {
  const { pending } = await locks.query();
  return pending?.some(({ name }) => name === lock) ?? true;
}

/** Asks on a channel; whoever holds the identity objects. Of two that ask at once both may win, a lock would not let them. */
function claimByChannel(name: string): Promise<Release | undefined> {
  const channel = new BroadcastChannel(name);
  return new Promise((resolve) => {
    const timer = setTimeout(() => {
      channel.onmessage = ({ data }) => {
        if (data === 'claim') channel.postMessage('taken');
      };
      resolve(() => channel.close());
    }, OBJECTION_WAIT_MS);
    channel.onmessage = ({ data }) => {
      if (data !== 'taken') return;
      clearTimeout(timer);
      channel.close();
      resolve(undefined);
    };
    channel.postMessage('claim');
  });
}
