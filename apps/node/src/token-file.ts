import { readFileSync } from 'node:fs';
import { parseJoin } from './options.ts';
import { ConfigError } from './read-config.ts';

/**
 * The token that a file holds, such as `admin-token` of a master's data directory [AC-44].
 * @throws ConfigError when it cannot be read, or holds something else
 */
export function readTokenFile(file: string): string {
  let text: string;
  try {
    text = readFileSync(file, 'utf8');
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    const reason =
      code === 'ENOENT'
        ? 'it does not exist. It exists only while a master runs with that data directory'
        : code === 'EACCES'
          ? 'it belongs to another user'
          : message;
    throw new ConfigError(`The file ${file} (--token-file) cannot be read: ${reason}.`);
  }
  try {
    return parseJoin(text.trim());
  } catch (error) {
    throw new ConfigError(
      `The file ${file} (--token-file) must hold ${(error as Error).message}, but does not.`,
    );
  }
}
