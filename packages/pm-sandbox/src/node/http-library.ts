import type { HostLibrary } from '../sandbox/worker-link.ts';

/** A service that takes longer to answer is not waited for, milliseconds: half of what a call may wait. */
const TIMEOUT_MS = 5_000;
/** Longer answers are refused, bytes: modules read values, not files. */
const MAX_ANSWER_BYTES = 1024 * 1024;
/** A service may send on this often; each step has to be allowed. */
const MAX_REDIRECTS = 5;

/**
 * The library `http`: reads pages of the origins that the operator allows, and nothing else.
 *
 * @param allowedOrigins such as `https://example.org`, without a path
 */
export function createHttpLibrary(allowedOrigins: readonly string[]): HostLibrary {
  const allowed = new Set(allowedOrigins.map((origin) => new URL(origin).origin));
  return {
    async get(url) {
      const response = await follow(String(url), allowed);
      return { status: response.status, text: await readText(response) };
    },
  };
}

/** By hand, because a page that is allowed must not lead to one that is not. */
async function follow(start: string, allowed: ReadonlySet<string>): Promise<Response> {
  const signal = AbortSignal.timeout(TIMEOUT_MS);
  let url = checked(start, allowed);
  for (let hops = 0; hops <= MAX_REDIRECTS; hops += 1) {
    const response = await fetchOnce(url, signal);
    const location = response.headers.get('location');
    if (response.status < 300 || response.status > 399 || location === null) return response;
    await response.body?.cancel();
    url = checked(new URL(location, url).href, allowed);
  }
  throw new Error(`${start} redirects more than ${MAX_REDIRECTS} times`);
}

async function fetchOnce(url: URL, signal: AbortSignal): Promise<Response> {
  try {
    return await fetch(url, { redirect: 'manual', signal, credentials: 'omit' });
  } catch (error) {
    if (signal.aborted) {
      throw new Error(`${url.origin} did not answer within ${TIMEOUT_MS} ms`, { cause: error });
    }
    const cause = (error as Error).cause;
    const reason = cause instanceof Error ? cause.message : (error as Error).message;
    throw new Error(`${url.origin} cannot be reached: ${reason}`, { cause: error });
  }
}

function checked(text: string, allowed: ReadonlySet<string>): URL {
  const url = URL.canParse(text) ? new URL(text) : undefined;
  if (url === undefined) throw new Error(`Expected a URL to read from, received "${text}"`);
  if (allowed.has(url.origin)) return url;
  throw new Error(
    `Reading from ${url.origin} is not allowed: the operator of the node allows it with --allow-fetch ${url.origin}`,
  );
}

async function readText(response: Response): Promise<string> {
  const decoder = new TextDecoder();
  let text = '';
  let bytes = 0;
  for await (const chunk of response.body ?? []) {
    bytes += (chunk as Uint8Array).byteLength;
    if (bytes > MAX_ANSWER_BYTES) {
      throw new Error(`The answer has more than ${MAX_ANSWER_BYTES} bytes`);
    }
    text += decoder.decode(chunk as Uint8Array, { stream: true });
  }
  return text + decoder.decode();
}
