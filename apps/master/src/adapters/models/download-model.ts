import { mkdir, readdir, rename, rm, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { isProcessRunning } from '@ubii/program';
import { modelAddress, type KnownModel } from './catalogue.ts';
import { diskError, DownloadError } from './download-error.ts';
import { downloadFile } from './download-file.ts';

/** Hidden, so that no set of this name can be asked for [PM-93]. */
const TEMPORARY = '.download-';

/** Options for downloading a model. */
export interface ModelDownload {
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
  const isThere = await rename(to, old).then(
    () => true,
    (error: NodeJS.ErrnoException) => {
      if (error.code === 'ENOENT') return false;
      throw error;
    },
  );
  try {
    await rename(from, to);
  } catch (error) {
    if (isThere) await rename(old, to);
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
