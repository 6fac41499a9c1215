import { accessSync, constants, mkdirSync, statSync } from 'node:fs';

import { ConfigError } from '@ubii/program';

import type { Log } from '../../core/ports/index.ts';

/**
 * Makes the data directory when it is missing, for its owner only: it holds secrets. Warns when others may read one that is
 * there. [RC-46]
 *
 * @throws ConfigError when it cannot be made or written to
 */
export function prepareDataDir(folder: string, log?: Pick<Log, 'warn'>): void {
  try {
    mkdirSync(folder, { recursive: true, mode: 0o700 });
    accessSync(folder, constants.R_OK | constants.W_OK | constants.X_OK);
    if (log !== undefined) warnOfReaders(folder, log);
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

function warnOfReaders(folder: string, log: Pick<Log, 'warn'>): void {
  if (process.platform === 'win32' || (statSync(folder).mode & 0o077) === 0) return;
  log.warn(
    `Other users of this machine may read the data directory ${folder}. It holds sessions, recordings and names. Allow its owner only (chmod 700).`,
  );
}
