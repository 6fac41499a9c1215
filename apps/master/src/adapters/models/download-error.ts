/** Why a model could not be downloaded, in one sentence for people, without paths of this machine. */
export class DownloadError extends Error {
  constructor(message: string, options?: ErrorOptions) {
    super(message, options);
    this.name = 'DownloadError';
  }
}

/** An error of a file system, without the path that its message names. */
export function diskError(error: unknown): DownloadError {
  const { code = 'unknown error' } = error as NodeJS.ErrnoException;
  const why = code === 'ENOSPC' ? 'the disk is full' : code;
  return new DownloadError(`The files could not be written into the data directory: ${why}.`, {
    cause: error,
  });
}
