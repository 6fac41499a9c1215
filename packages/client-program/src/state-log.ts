import type { ConnectionError, ConnectionState } from '@ubii/client-web/node';
import type { Log } from './log.ts';

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
