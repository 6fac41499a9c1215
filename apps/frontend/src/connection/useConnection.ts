import { injectOrThrow } from '../context/inject-or-throw.ts';
import { CONNECTION, type Connection } from './connection.ts';

/** The connection of this page, provided at the root. */
export function useConnection(): Connection {
  return injectOrThrow(CONNECTION, 'the connection at the root of the app');
}
