import { createHash } from 'node:crypto';
import { open, mkdir, readdir, rename, rm, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import type { AssetFile } from '@ubii/pm-sandbox';
import { isProcessRunning } from '@ubii/program';
import { modelAddress, type KnownModel } from './catalogue.ts';

/** Why a model could not be downloaded, in one sentence for people, without paths of this machine. */
export class DownloadError extends Error {
  constructor(message: string, options?: ErrorOptions) {
    super(message, options);
    this.name = 'DownloadError';
  }
}

/** An error of a file system, without the path that its message names. */
function diskError(error: unknown): DownloadError {
  const { code = 'unknown error' } = error as NodeJS.ErrnoException;
  const why = code === 'ENOSPC' ? 'the disk is full' : code;
  return new DownloadError(`The files could not be written into the data directory: ${why}.`, {
    cause: error,
  });
}

/** A server that sends nothing for so long is given up, milliseconds. */
export const STALL_MS = 20_000;
/** A publisher may move files within its host this often. */
const MAX_REDIRECTS = 3;

/** Options for downloading a file. */
interface FileDownload {
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

/** Hidden, so that no set of this name can be asked for [PM-93]. */
const TEMPORARY = '.download-';

/** Options for downloading a model. */
interface ModelDownload {
  /** `models/` of the data directory. */
  readonly folder: string;
  /** Address of a mirror, with a slash at the end; undefined: the publisher. */
  readonly mirror: string | undefined;
  readonly signal: AbortSignal;
  readonly stallMs?: number | undefined;
  /** Told of all bytes that came. */
  onProgress(loadedBytes: number): void;
}

/**
 * Downloads a model into a temporary folder and puts it into its place when each file is right. What was in
 * that place stays until then. [EX-58]
 *
 * @throws DownloadError; the reason of the signal when that ends it. Nothing is left behind.
 */
export async function downloadModel(model: KnownModel, download: ModelDownload): Promise<void> {
  const { folder, mirror, signal, stallMs, onProgress } = download;
  const { name, version, licence, source, files } = model;
  const temporary = join(folder, `${TEMPORARY}${process.pid}-${name}`);
  try {
    await onDisk(async () => {
      await removeLeftovers(folder, name);
      await mkdir(temporary, { recursive: true });
    });
    let loadedBytes = 0;
    for (const file of files) {
      const target = join(temporary, file.path);
      await onDisk(() => mkdir(dirname(target), { recursive: true }));
      const url = new URL(file.path, modelAddress(model, mirror));
      const onBytes = (bytes: number): void => onProgress((loadedBytes += bytes));
      await downloadFile({ url, file, target, signal, stallMs, onBytes });
    }
    const manifest = { name, version, licence, source, files };
    await onDisk(async () => {
      await writeFile(join(temporary, 'manifest.json'), `${JSON.stringify(manifest, null, 2)}\n`);
      signal.throwIfAborted();
      await replaceFolder(temporary, join(folder, name));
    });
  } finally {
    await rm(temporary, { recursive: true, force: true }).catch(() => undefined);
  }
}

/** Removes what processes left that ended during a download. */
export async function removeLeftovers(folder: string, name: string): Promise<void> {
  const entries = await readdir(folder).catch(() => []);
  for (const entry of entries) {
    const [, pid, of] = /^\.download-(\d+)-(.+?)(?:\.old)?$/.exec(entry) ?? [];
    if (of !== name || (Number(pid) !== process.pid && isProcessRunning(Number(pid)))) continue;
    await rm(join(folder, entry), { recursive: true, force: true });
  }
}

/** Puts one folder into the place of another one, which comes back when that fails. */
async function replaceFolder(from: string, to: string): Promise<void> {
  const old = `${from}.old`;
  const hasFolder = await rename(to, old).then(
    () => true,
    (error: NodeJS.ErrnoException) => {
      if (error.code === 'ENOENT') return false;
      throw error;
    },
  );
  try {
    await rename(from, to);
  } catch (error) {
    if (hasFolder) await rename(old, to);
    throw error;
  }
  await rm(old, { recursive: true, force: true }).catch(() => undefined);
}

async function onDisk<T>(work: () => Promise<T>): Promise<T> {
  try {
    return await work();
  } catch (error) {
    const isOfDisk = typeof (error as NodeJS.ErrnoException).code === 'string';
    throw isOfDisk && !(error instanceof DownloadError) ? diskError(error) : error;
  }
}
