const MEGABYTE = 1e6;

/** `18.6 MB`. */
export function megabytes(bytes: number): string {
  return `${(bytes / MEGABYTE).toFixed(1)} MB`;
}

/**
 * Progress of a download in one line.
 *
 * @param elapsedMs since its start
 */
export function progressLine(loadedBytes: number, totalBytes: number, elapsedMs: number): string {
  const percent = Math.floor((loadedBytes / totalBytes) * 100);
  const ofBytes = `${(loadedBytes / MEGABYTE).toFixed(1)} of ${megabytes(totalBytes)}`;
  const leftMs = (elapsedMs / loadedBytes) * (totalBytes - loadedBytes);
  const left = Number.isFinite(leftMs) ? `  ${Math.ceil(leftMs / 1000)} s left` : '';
  return `${String(percent).padStart(3)} %  ${ofBytes}${left}`;
}
