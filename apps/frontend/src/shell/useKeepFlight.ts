import { useConnection } from '../connection/useConnection.ts';
import { useToasts } from '../ui/toasts/toasts.ts';

/** Keeps what the flight recorder holds; the code for it is loaded then. */
export function useKeepFlight(): () => void {
  const { client } = useConnection();
  const toasts = useToasts();
  return () =>
    void import('../recordings/flight/keep-flight.ts').then(({ keepFlight }) =>
      keepFlight({ client, toasts }),
    );
}
