import { readFileSync } from 'node:fs';
import { hostname } from 'node:os';

import {
  ConfigError,
  option,
  parseChoice,
  parseName,
  parsePath,
  pathOption,
  switchOption,
} from '@ubii/program';

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

/** Options of programs that join a master. */
export const JOINING_OPTIONS = {
  master: option({
    placeholder: '<url>',
    fallback: 'http://localhost:8080',
    description: 'Address of the master.',
    parse: parseMasterUrl,
  }),
  discover: switchOption(
    'Find the master in the local network (multicast DNS). With several masters, list them and exit.',
  ),
  join: option<string | undefined>({
    placeholder: '<token|code>',
    fallback: undefined,
    fallbackText: 'none',
    description:
      'Token or code to join with, when the master runs on another machine. Needed once: the program stores its identity.',
    isSecret: true,
    parse: parseJoin,
  }),
  tokenFile: pathOption(
    '<file>',
    'none',
    'File with the token to join with, so that the list of processes does not show it. The file admin-token in the data directory of a local master makes the client an admin.',
  ),
} as const;

/** Where the identity of the program is stored: a file, `off`, or by default one for each name and master. */
export const identityOption = option<string | undefined>({
  placeholder: '<file>|off',
  fallback: undefined,
  fallbackText: 'a file in the home directory, one for each name and master',
  description:
    'File with the identity of this program, so that its next run is the same client. off: each run is a new client.',
  parse: (text, baseDir) => (text === 'off' ? 'off' : parsePath(text, baseDir)),
});

/** Writes how to reach the program, for programs that start it. */
export const printEndpointsOption = option<'json' | undefined>({
  placeholder: 'json',
  fallback: undefined,
  fallbackText: 'off',
  description:
    'When connected for the first time, write one line of JSON with id, name, master and pid to standard output.',
  parse: parseChoice('json'),
});

/** Name of the program, by default that of the machine and the kind. @param kind such as `node` */
export function nameOption(kind: string) {
  return option({
    placeholder: '<text>',
    fallback: `${hostname().split('.')[0] || 'unnamed'} ${kind}`,
    description: `Name of this ${kind}, shown to users.`,
    parse: parseName,
  });
}

/** @throws ConfigError for options that contradict each other */
export function checkJoining(
  values: {
    readonly discover: boolean;
    readonly join: string | undefined;
    readonly tokenFile: string | undefined;
  },
  given: ReadonlySet<string>,
): void {
  if (values.discover && given.has('master')) {
    throw new ConfigError(
      'The options --master and --discover both choose the master. Remove one of them.',
    );
  }
  if (values.join !== undefined && values.tokenFile !== undefined) {
    throw new ConfigError(
      'The options --join and --token-file both set the token. Remove one of them.',
    );
  }
}

function parseMasterUrl(text: string): string {
  const url = URL.canParse(text) ? new URL(text) : undefined;
  if (url === undefined || !/^https?:$/.test(url.protocol) || url.pathname !== '/') {
    throw new Error('an http or https URL without a path, such as http://192.168.1.20:8080');
  }
  return url.origin;
}
