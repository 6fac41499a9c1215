import { ConfigError } from '@ubii/program';
import { readFileSync } from 'node:fs';

/**
 * Reads a token from a file, such as `admin-token` in the data directory of a master [AC-44].
 * @throws ConfigError when the file cannot be read or does not contain a token
 */
export function readTokenFile(file: string): string {
  let text: string;
  try {
    text = readFileSync(file, 'utf8');
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    const reason =
      code === 'ENOENT'
        ? 'it does not exist. A master writes it when it starts, and deletes it when it stops'
        : code === 'EACCES'
          ? 'it belongs to another user'
          : message;
    throw new ConfigError(`The file ${file} (--token-file) cannot be read: ${reason}.`);
  }
  try {
    return parseJoin(text.trim());
  } catch (error) {
    throw new ConfigError(
      `The file ${file} (--token-file) must contain ${(error as Error).message}.`,
    );
  }
}

/** Returns the token or code. Also accepts the link of a QR code. */
export function parseJoin(text: string): string {
  const token = text.slice(text.indexOf('#') + 1).trim();
  if (!/^[!-~][ -~]{0,199}$/.test(token)) {
    throw new Error('a token or code, or a link that ends with one');
  }
  return token;
}
