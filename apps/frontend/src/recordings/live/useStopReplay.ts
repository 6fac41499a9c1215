import { tryRequest } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';

/** Stops replays; says in a toast why the master refused. */
export function useStopReplay(): (id: string) => Promise<void> {
  const { client } = useConnection();
  const toasts = useToasts();
  return async (id) => {
    await tryRequest(
      () => client.call('replayStop', { id }),
      ({ message }) => toasts.show(`Not stopped. ${message}`),
    );
  };
}
