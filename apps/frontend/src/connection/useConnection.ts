import { inject } from 'vue';
import { CONNECTION, type Connection } from './connection.ts';

/** The connection of this page, provided at the root. */
export function useConnection(): Connection {
  const connection = inject(CONNECTION);
  if (!connection) throw new Error('useConnection() needs the connection at the root of the app.');
  return connection;
}
