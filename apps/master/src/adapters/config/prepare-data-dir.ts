import { accessSync, constants, mkdirSync } from 'node:fs';

import { ConfigError } from '@ubii/program';

/**
 * Makes the data directory when it is missing, for its owner only: it holds secrets.
 *
 * @throws ConfigError when it cannot be made or written to
 */
export function prepareDataDir(folder: string): void {
  try {
    mkdirSync(folder, { recursive: true, mode: 0o700 });
    accessSync(folder, constants.R_OK | constants.W_OK | constants.X_OK);
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    const reason =
      code === 'EEXIST' || code === 'ENOTDIR'
        ? 'a file has that name'
        : code === 'EACCES' || code === 'EPERM' || code === 'EROFS'
          ? 'this user may not write there'
          : message;
    throw new ConfigError(
      `The data directory ${folder} (--data-dir) must be a folder the master can write to, but ${reason}: choose another with --data-dir <folder>.`,
    );
  }
}
