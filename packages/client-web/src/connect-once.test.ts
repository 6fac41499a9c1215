import { describe, expect, it } from 'vitest';
import { connectOnce } from './connect-once.ts';
import { createTestClient } from './testing/create-test-client.ts';
import { FakeMaster } from './testing/fake-master.ts';

describe('connectOnce()', () => {
  it('connects, and leaves the client to reconnect by itself', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master);
    await connectOnce(client, clock);
    expect(client.state.status).toBe('connected');
  });

  it('rejects with the error of the first attempt, and closes the client', async () => {
    const gone = {
      handleServiceRequest: () => Promise.reject(new Error('there is no master')),
      openConnection: () => undefined,
    };
    const { client, clock } = createTestClient(gone);
    await expect(connectOnce(client, clock)).rejects.toMatchObject({ name: 'ConnectionError' });
    expect(client.state.status).toBe('closed');
  });

  it('waits for an attempt that the master asked for', async () => {
    const master = new FakeMaster();
    const first = createTestClient(master);
    await connectOnce(first.client, first.clock);
    const identity = { clientId: first.client.id, resumeToken: 'of another run' };
    const { client, clock } = createTestClient(master, {
      identity: { load: () => identity, save: () => undefined },
    });
    await connectOnce(client, clock);
    expect(client.state.status).toBe('connected');
  });
});
