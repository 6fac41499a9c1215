/** Entry of the identity of a tab in its session storage. */
export const IDENTITY_KEY = 'ubii.identity';
/** Entry of the name of a browser in its local storage. */
export const NAME_KEY = 'ubii.name';

/** Beginning of the fragment in which a page that moved hands itself over to its new address. */
const MARK = '#moved=';
const MAX_CHARACTERS = 4_000;

/** Storages of a page: those of its address, so that a page at another address has none of them. */
export interface PageStorages {
  readonly tab: Pick<Storage, 'getItem' | 'setItem'>;
  readonly browser: Pick<Storage, 'getItem' | 'setItem'>;
}

/** @returns undefined where the browser blocks storage: it throws at the mere mention of it */
export function pageStorages(): PageStorages | undefined {
  try {
    return { tab: sessionStorage, browser: localStorage };
  } catch {
    return undefined;
  }
}

/**
 * URL of this page at another master of the cluster, with what makes it the same client there. The secret stands in the
 * fragment, which browsers do not send. [CU-97]
 * @param path of the page, with its query
 */
export function handOverUrl(
  masterUrl: string,
  path: string,
  storages: PageStorages | undefined,
): string {
  const url = `${new URL(masterUrl).origin}${path}`;
  const identity = storages?.tab.getItem(IDENTITY_KEY) ?? undefined;
  if (identity === undefined) return url;
  const handed = { identity, name: storages?.browser.getItem(NAME_KEY) ?? '' };
  return `${url}${MARK}${encodeURIComponent(JSON.stringify(handed))}`;
}

/**
 * Takes over what `handOverUrl` handed over, and removes it from the address and the history. A tab
 * that has an identity keeps it: a link does not make it another client. [CU-97]
 */
export function takeHandOver(
  { hash, pathname, search }: Pick<Location, 'hash' | 'pathname' | 'search'>,
  history: Pick<History, 'replaceState' | 'state'>,
  storages: PageStorages | undefined,
): void {
  if (!hash.startsWith(MARK)) return;
  history.replaceState(history.state, '', `${pathname}${search}`);
  const handed = parse(hash.slice(MARK.length));
  if (handed === undefined || storages === undefined) return;
  const { tab, browser } = storages;
  if (tab.getItem(IDENTITY_KEY) !== null) return;
  tab.setItem(IDENTITY_KEY, handed.identity);
  if (handed.name !== '' && browser.getItem(NAME_KEY) === null) {
    browser.setItem(NAME_KEY, handed.name);
  }
}

function parse(text: string): { readonly identity: string; readonly name: string } | undefined {
  if (text.length > MAX_CHARACTERS) return undefined;
  try {
    const { identity, name } = JSON.parse(decodeURIComponent(text)) as Record<string, unknown>;
    return typeof identity === 'string' && typeof name === 'string'
      ? { identity, name }
      : undefined;
  } catch {
    return undefined;
  }
}
