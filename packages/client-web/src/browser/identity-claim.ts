/**
 * Longest time to wait for an identity that is neither released nor confirmed by its page, milliseconds. A busy
 * computer takes seconds to end the page before a reload; a live page replies much earlier.
 */
const MAX_WAIT_MS = 5_000;
/**
 * Time for other pages to object where locks are not available, milliseconds. A message between pages takes one or two;
 * every reload waits this long.
 */
const OBJECTION_WAIT_MS = 250;
/** A page that says it is there is asked once more after this, milliseconds: it may have been about to end. */
const SECOND_QUESTION_MS = 300;

/** Gives the claim free; calling it again does nothing. */
export type Release = () => void;

/**
 * Claims an identity for this page, against other pages of the same origin. A page that was duplicated
 * finds the other one alive, which says so; a page that was reloaded waits until its predecessor is gone.
 * @returns how to give it free, or `undefined` when another page has it
 */
export function claimIdentity(clientId: string): Promise<Release | undefined> {
  const name = `ubii.identity.${clientId}`;
  // Web Locks exist in secure contexts only, and a phone often sees the master over plain HTTP.
  const hasLocks = globalThis.navigator?.locks !== undefined;
  if (globalThis.BroadcastChannel === undefined) {
    return hasLocks ? claimByLock(name) : Promise.resolve(() => undefined);
  }
  return hasLocks ? claimByLock(name, askHolder(name)) : claimByChannel(name);
}

/** Waits for the lock until another page reports that it is taken, or until a timeout. */
async function claimByLock(name: string, holder?: Question): Promise<Release | undefined> {
  const waiting = new AbortController();
  const timer = setTimeout(() => waiting.abort(), MAX_WAIT_MS);
  void holder?.isTaken.then(() => waiting.abort());
  let letGo: Release = () => undefined;
  const held = new Promise<void>((resolve) => {
    letGo = resolve;
  });
  const isClaimed = await new Promise<boolean>((resolve) => {
    navigator.locks
      .request(name, { signal: waiting.signal }, () => {
        resolve(true);
        return held;
      })
      .catch(() => resolve(false)); // given up
  });
  clearTimeout(timer);
  holder?.end();
  if (!isClaimed) return undefined;
  const stopAnswering = globalThis.BroadcastChannel === undefined ? undefined : answerFor(name);
  return () => {
    stopAnswering?.();
    letGo();
  };
}

/** Asks on a channel alone. Of two that ask at once both may win; a lock would not let them. */
async function claimByChannel(name: string): Promise<Release | undefined> {
  const holder = askHolder(name);
  let timer: ReturnType<typeof setTimeout> | undefined;
  const noAnswer = new Promise<false>((resolve) => {
    const wait = (): void => {
      // A page that answered once gets more time for its second answer.
      if (holder.isAnswered()) timer = setTimeout(() => resolve(false), SECOND_QUESTION_MS * 2);
      else resolve(false);
    };
    timer = setTimeout(wait, OBJECTION_WAIT_MS);
  });
  const isTaken = await Promise.race([holder.isTaken.then(() => true), noAnswer]);
  clearTimeout(timer);
  holder.end();
  return isTaken ? undefined : answerFor(name);
}

/** A question to the page that holds an identity. */
interface Question {
  /** Resolves when a page has claimed it twice. */
  readonly isTaken: Promise<void>;
  /** A page has claimed it once. */
  isAnswered(): boolean;
  end(): void;
}

function askHolder(name: string): Question {
  const channel = new BroadcastChannel(name);
  let answers = 0;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const isTaken = new Promise<void>((resolve) => {
    channel.onmessage = ({ data }) => {
      if (data !== 'taken') return;
      answers += 1;
      if (answers > 1) resolve();
      else timer = setTimeout(() => channel.postMessage('claim'), SECOND_QUESTION_MS);
    };
  });
  channel.postMessage('claim');
  return {
    isTaken,
    isAnswered: () => answers > 0,
    end: () => {
      clearTimeout(timer);
      channel.close();
    },
  };
}

/** Answers questions of other pages that this page holds the identity, while the page exists. */
function answerFor(name: string): () => void {
  const channel = new BroadcastChannel(name);
  let isEnding = false;
  channel.onmessage = ({ data }) => {
    if (data === 'claim' && !isEnding) channel.postMessage('taken');
  };
  // The successor of a page that is reloaded may ask before the last of this one is gone.
  const { window: page } = globalThis as Partial<typeof globalThis>;
  const handleEnd = (): void => void (isEnding = true);
  const handleReturn = (): void => void (isEnding = false);
  page?.addEventListener('pagehide', handleEnd);
  page?.addEventListener('pageshow', handleReturn);
  return () => {
    channel.close();
    page?.removeEventListener('pagehide', handleEnd);
    page?.removeEventListener('pageshow', handleReturn);
  };
}
