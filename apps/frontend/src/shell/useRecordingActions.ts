import { useConnection } from '../connection/useConnection.ts';
import { useToasts } from '../ui/toasts/toasts.ts';

/** What people do to recordings on every page; the code for it is loaded then. */
export interface RecordingActions {
  /** Keeps what the flight recorder holds. */
  keep(): void;
  /** Marks this moment in what is recorded. */
  mark(): void;
}

export function useRecordingActions(): RecordingActions {
  const { client } = useConnection();
  const ports = { client, toasts: useToasts() };
  return {
    keep: () =>
      void import('../recordings/flight/keep-flight.ts').then(({ keepFlight }) =>
        keepFlight(ports),
      ),
    mark: () =>
      void import('../recordings/running/mark-now.ts').then(({ markNow }) => markNow(ports)),
  };
}
