import { DiskFile } from '@ubii/recording/node';
import { RecordingError, RecordingReader } from '@ubii/recording';
import { ConfigError } from '@ubii/program';

/** `1:02:03.4` or `2:03.4`. @param ns nanoseconds */
export function durationText(ns: bigint): string {
  const tenths = ns / 100_000_000n;
  const seconds = tenths / 10n;
  const [hours, minutes] = [seconds / 3600n, (seconds / 60n) % 60n];
  const rest = `${String(seconds % 60n).padStart(2, '0')}.${tenths % 10n}`;
  if (hours === 0n) return `${minutes}:${rest}`;
  return `${hours}:${String(minutes).padStart(2, '0')}:${rest}`;
}

/** `830 B`, `12.3 kB`, `1.2 GB`. */
export function bytesText(bytes: number): string {
  const units = ['B', 'kB', 'MB', 'GB', 'TB'];
  let [value, unit] = [bytes, 0];
  for (; value >= 1000 && unit < units.length - 1; unit++) value /= 1000;
  return `${unit === 0 || value >= 100 ? Math.round(value) : value.toFixed(1)} ${units[unit]}`;
}

/**
 * Opens a recording for reading; the caller closes the file.
 *
 * @throws ConfigError when there is no such file, or it is no recording
 */
export async function openRecording(
  path: string | undefined,
): Promise<{ file: DiskFile; reader: RecordingReader }> {
  if (path === undefined) throw new ConfigError('Which recording? Give the path of an MCAP file.');
  let file: DiskFile;
  try {
    file = await DiskFile.open(path);
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    const reason = code === 'ENOENT' ? 'it does not exist' : message;
    throw new ConfigError(`The recording ${path} cannot be opened: ${reason}.`);
  }
  try {
    return { file, reader: await RecordingReader.open(file) };
  } catch (error) {
    await file.close();
    if (!(error instanceof RecordingError)) throw error;
    throw new ConfigError(`The recording ${path} cannot be read: ${error.message}`);
  }
}

/** Creates the file of a recording. @throws ConfigError when the file exists or cannot be created */
export async function createRecording(path: string): Promise<DiskFile> {
  try {
    return await DiskFile.create(path);
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    const reason = code === 'EEXIST' ? 'it exists. Choose another name' : message;
    throw new ConfigError(`The recording ${path} cannot be created: ${reason}.`);
  }
}
