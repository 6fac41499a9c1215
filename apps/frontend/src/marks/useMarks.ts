import { useConnection } from '../connection/useConnection.ts';
import { playerIdentity, type PlayerIdentity } from '../players/player-identity.ts';

/** Returns how clients look: by the mark that each has, and the letter of its name. [EX-100] */
export function useMarks() {
  const { client, clients, mark } = useConnection();
  /** @param name as it is displayed. @default the one known of the client */
  function markOf(clientId: string, name?: string): PlayerIdentity {
    // What is known of clients changes with the list.
    void clients.list.value;
    const known = clients.find(clientId);
    const own = clientId === client.id ? mark.current.value : undefined;
    return playerIdentity(clientId, name ?? known?.name ?? '', own ?? known?.extension?.mark);
  }
  return { markOf };
}
