import { isLogged, type LogLevel } from '@ubii/program';
import type { ConnectionError, ConnectionState } from '@ubii/client-web/node';

/** Logs one line. */
export type Log = (level: LogLevel, message: string) => void;

/** @param write takes one line, without the line break */
export function createLog(least: LogLevel, write: (line: string) => void, nowMs = Date.now): Log {
  return (level, message) => {
    if (!isLogged(level, least)) return;
    const time = new Date(nowMs()).toISOString().slice(11, 19);
    write(`${time} ${level.padEnd(5)} ${printable(message)}`);
  };
}

/** Removes control characters: messages contain texts of modules and of the master. */
function printable(text: string): string {
  return text.replace(/\p{Cc}/gu, (control) => (control === '\n' ? '\n      ' : ''));
}

/**
 * Logs changes of the connection. Logs only the first of several failed attempts as a warning.
 *
 * @param masterUrl of the master that the client is at now
 * @param program what the program is, such as `node`
 */
export function createStateLog(
  log: Log,
  masterUrl: () => string,
  program: string,
): (state: ConnectionState) => void {
  let isLogged = false;
  return (state) => {
    const master = masterUrl();
    switch (state.status) {
      case 'connected':
        isLogged = false;
        return log('info', `Connected to ${master} as ${state.clientId}`);
      case 'reconnecting':
        if (isLogged)
          return log('debug', `Connection attempt ${state.attempt} failed: ${state.error.message}`);
        isLogged = true;
        return log(
          'warn',
          `No connection to ${master}: ${state.error.message}. Retrying until it succeeds`,
        );
      case 'closed':
        return state.error === undefined
          ? log('info', `Disconnected from ${master}`)
          : log(
              'error',
              `${master} refused this ${program}: ${state.error.message}${hintFor(state.error)}`,
            );
      case 'connecting':
        return log('info', `Connecting to ${master}`);
      case 'idle':
        return;
    }
  };
}

function hintFor({ reason }: ConnectionError): string {
  return reason === 'join'
    ? ' Start it with --join <code>; the terminal of the master shows the code.'
    : '';
}
