import { createHash } from 'node:crypto';
import { open } from 'node:fs/promises';
import type { AssetFile } from '@ubii/pm-sandbox';
import { diskError, DownloadError } from './download-error.ts';

/** A server that sends nothing for so long is given up, milliseconds. */
export const STALL_MS = 20_000;
/** A publisher may move files within its host this often. */
const MAX_REDIRECTS = 3;

/** Options for downloading a file. */
export interface FileDownload {
  readonly url: URL;
  /** Expected file. */
  readonly file: AssetFile;
  /** Path of the new file. */
  readonly target: string;
  readonly signal: AbortSignal;
  /** Default: `STALL_MS`. */
  readonly stallMs?: number | undefined;
  /** Told of each part that came, bytes. */
  onBytes(bytes: number): void;
}

/**
 * Downloads one file and verifies its size and SHA-256 while it comes: nothing beyond the stated size is read.
 * Redirects lead to the same scheme, host and port only. [EX-58]
 *
 * @throws DownloadError; the reason of the signal when that ends it
 */
export async function downloadFile(download: FileDownload): Promise<void> {
  const { url, signal, stallMs = STALL_MS } = download;
  const stall = new AbortController();
  const timer = setTimeout(() => stall.abort(), stallMs);
  try {
    const response = await follow(url, AbortSignal.any([signal, stall.signal]));
    await receive(response, download, () => timer.refresh());
  } catch (cause) {
    signal.throwIfAborted();
    if (stall.signal.aborted) {
      throw new DownloadError(`${url.origin} sent nothing for ${stallMs / 1000} s.`, { cause });
    }
    if (cause instanceof DownloadError) throw cause;
    throw new DownloadError(`${url.origin} could not be reached: ${reasonOf(cause)}.`, { cause });
  } finally {
    clearTimeout(timer);
  }
}

async function follow(start: URL, signal: AbortSignal): Promise<Response> {
  let url = start;
  for (let hops = 0; hops <= MAX_REDIRECTS; hops++) {
    // Compressed on the way, sizes would be known only afterwards.
    const headers = { 'accept-encoding': 'identity' };
    const response = await fetch(url, { redirect: 'manual', credentials: 'omit', signal, headers });
    const location = response.headers.get('location');
    if (response.status < 300 || response.status > 399 || location === null) return response;
    await response.body?.cancel();
    const next = new URL(location, url);
    if (next.origin !== start.origin) {
      throw new DownloadError(
        `${start.origin} redirects to ${next.origin}, which is refused. Only ${start.origin} may send the files.`,
      );
    }
    url = next;
  }
  throw new DownloadError(`${start.origin} redirects more than ${MAX_REDIRECTS} times.`);
}

async function receive(
  response: Response,
  { url, file, target, onBytes }: FileDownload,
  onLife: () => void,
): Promise<void> {
  if (response.status !== 200 || response.body === null) {
    await response.body?.cancel();
    throw new DownloadError(`${url.origin} answers with status ${response.status} to ${url.href}.`);
  }
  const wrong = (why: string): DownloadError =>
    new DownloadError(
      `${url.origin} sent a file that differs from the expected ${file.path}: ${why}. The file was discarded.`,
    );
  const hash = createHash('sha256');
  let received = 0;
  const handle = await open(target, 'wx').catch((cause: unknown) =>
    Promise.reject(diskError(cause)),
  );
  try {
    for await (const part of response.body as AsyncIterable<Uint8Array>) {
      onLife();
      received += part.length;
      if (received > file.bytes) throw wrong(`it has more than ${file.bytes} bytes`);
      hash.update(part);
      await handle.appendFile(part).catch((cause: unknown) => Promise.reject(diskError(cause)));
      onBytes(part.length);
    }
  } finally {
    await handle.close();
  }
  if (received < file.bytes) throw wrong(`it has ${received} bytes instead of ${file.bytes}`);
  if (hash.digest('hex') !== file.sha256) throw wrong('its SHA-256 differs');
}

/** `fetch` hides why it failed in the cause. */
function reasonOf(error: unknown): string {
  const { cause } = error as { cause?: unknown };
  const inner = cause instanceof Error && cause.message !== '' ? cause : error;
  return (inner instanceof Error ? inner.message : String(inner)).replace(/\.$/, '');
}
