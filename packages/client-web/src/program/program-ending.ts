import { ConnectionError } from '../core/connection/connection-error.ts';
import type { ConnectionErrorReason } from '../core/connection/connection-error.ts';
import { explainConnectionError } from '../core/connection/explain-connection-error.ts';
import { LIBRARY_NAME } from '../core/connection/library-name.ts';

/** Exit codes of programs that `startProgram` ends, by the reason. */
export const PROGRAM_EXIT_CODES = {
  /** The options are wrong, such as an address that is no URL. */
  options: 2,
  /** The master cannot be reached, or refused the client. */
  refused: 3,
  /** The client has to join: its code or token is missing, wrong, used or expired. */
  join: 4,
  /** What answers is no master that this library understands. */
  protocol: 5,
  /** Another program uses the identity. */
  superseded: 6,
  /** An admin disconnected the client. */
  disconnected: 7,
} as const;

/** How a program ends: what it says, and its exit code. */
export interface ProgramEnding {
  readonly message: string;
  readonly exitCode: number;
}

const CODES: Readonly<Record<ConnectionErrorReason, number>> = {
  closed: PROGRAM_EXIT_CODES.refused,
  refused: PROGRAM_EXIT_CODES.refused,
  timeout: PROGRAM_EXIT_CODES.refused,
  protocol: PROGRAM_EXIT_CODES.protocol,
  superseded: PROGRAM_EXIT_CODES.superseded,
  disconnected: PROGRAM_EXIT_CODES.disconnected,
  join: PROGRAM_EXIT_CODES.join,
};

/** Returns how a program ends after an error; undefined when the error is none of options or connection. */
export function endingOf(error: unknown): ProgramEnding | undefined {
  if (error instanceof ConnectionError) {
    return { message: explainConnectionError(error), exitCode: CODES[error.reason] };
  }
  if (error instanceof TypeError) {
    return { message: `${error.message}.`, exitCode: PROGRAM_EXIT_CODES.options };
  }
  return undefined;
}

/**
 * Returns how to install the library of the master, when that of the program is of another version. Below version 1,
 * minor versions count.
 * @param masterVersion undefined for original masters
 */
export function versionNotice(
  masterVersion: string | undefined,
  masterUrl: string,
  version = LIBRARY_NAME.replace(/^.*\//, ''),
): string | undefined {
  if (masterVersion === undefined || seriesOf(masterVersion) === seriesOf(version))
    return undefined;
  return `The master has version ${masterVersion}, the library of this program ${version}. Install that of the master: npm i ${masterUrl}/sdk/ubii-client-${masterVersion}.tgz`;
}

function seriesOf(version: string): string {
  const [major = '', minor = ''] = version.split('.');
  return major === '0' ? `0.${minor}` : major;
}
