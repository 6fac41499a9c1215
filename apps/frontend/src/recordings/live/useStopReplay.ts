import { ConnectionError } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { useConnection } from '../../connection/useConnection.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';

/** Stops replays; says in a toast why the master refused. */
export function useStopReplay(): (id: string) => Promise<void> {
  const { client } = useConnection();
  const toasts = useToasts();
  return async (id) => {
    try {
      await client.call('replayStop', { id });
    } catch (cause) {
      if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
      toasts.show(`Not stopped. ${cause.message}`);
    }
  };
}
