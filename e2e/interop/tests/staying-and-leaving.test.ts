import { describe, expect, test } from 'vitest';
import { CLIENT_KINDS } from '../harness/client-kind.ts';
import { suiteName, useRoom, whyMissing } from '../harness/room.ts';

const room = useRoom();

/** A client that answers is pinged about every 3 s: three pings take longer than the 5 s of CL-13. */
const PINGS = 3;

describe.each(CLIENT_KINDS)('%s', (kind) => {
  describe.skipIf(whyMissing(kind))(suiteName(kind), () => {
    test('answers pings and stays active, with a latency [CL-12] [CL-15]', async () => {
      const guest = await room.joins(kind);
      const ours = await room.oursJoins();
      await guest.isPinged(PINGS);
      const listed = await room.listed(ours, guest.clientId);
      expect(listed?.state).toBe(0);
      expect(listed?.latency).toBeGreaterThan(0);
      expect(guest.frames('text')).toBe(0);
      expect(guest.complaints).toEqual([]);
    });
  });
});

test.skipIf(whyMissing('python'))(
  'a Python node that leaves deregisters device and client: neither is left [CL-16]',
  async () => {
    const guest = await room.joins('python');
    const ours = await room.oursJoins();
    await guest.registerDevice({ name: 'lamp', components: [] });
    await guest.disconnect();
    expect(await room.listed(ours, guest.clientId)).toBeUndefined();
    const devices = await ours.call('deviceGetList', { elements: [{ clientId: guest.clientId }] });
    expect(devices.elements).toEqual([]);
    expect(guest.complaints).toEqual([]);
  },
);

test('a web node leaves with requests that are wrong, every one is answered, and it is gone [SV-12] [DV-5]', async () => {
  const guest = await room.joins('webbrowser');
  const ours = await room.oursJoins();
  await guest.registerDevice({ name: 'phone', components: [] });
  await guest.subscribeTopic('/anything');
  await guest.disconnect();
  expect(await room.listed(ours, guest.clientId)).toBeUndefined();
});

test('a web node that reconnects comes back with its subscriptions [TD-20]', async () => {
  const guest = await room.joins('webbrowser');
  const ours = await room.oursJoins();
  await guest.subscribeTopic('/before');
  await guest.reconnect();
  ours.publish('/before', 'string', 'after');
  await guest.receives('/before', 'after');
});

test('a nodejs node that just ends is noticed at once and no longer active [CL-13]', async () => {
  const guest = await room.joins('nodejs');
  const ours = await room.oursJoins();
  await guest.disconnect();
  await guest.stop();
  await expect.poll(async () => (await room.listed(ours, guest.clientId))?.state).not.toBe(0);
});
