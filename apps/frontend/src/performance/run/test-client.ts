import { createClient, type UbiiClient } from '@ubii/client-web';
import type { Leavings } from './leavings.ts';

/** Separate client of a test: its topics and subscriptions are removed with it. */
export interface TestClient {
  readonly client: UbiiClient;
  /** Deregisters it, with its topics and subscriptions. */
  close(): Promise<void>;
}

/** @throws {ConnectionError | ServiceError} when it cannot connect */
export async function openTestClient(
  name: string,
  leavings: Leavings,
  options: { readonly publishIntervalMs?: number } = {},
): Promise<TestClient> {
  const client = createClient({
    name,
    description: 'A test of the performance page',
    tags: ['performance test'],
    ...options,
  });
  await client.connect();
  const leaving = { kind: 'client', id: client.id } as const;
  leavings.add(leaving);
  return {
    client,
    async close() {
      // Without a connection, the master keeps the client: it is removed after reconnecting.
      const isHeard = client.state.status === 'connected';
      await client.close();
      if (isHeard) leavings.drop(leaving);
    },
  };
}
