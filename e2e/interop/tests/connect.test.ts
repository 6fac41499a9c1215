import { describe, expect, test } from 'vitest';
import { CLIENT_KINDS } from '../harness/client-kind.ts';
import { LegacyClient } from '../harness/legacy-client.ts';
import { suiteName, useRoom, whyMissing } from '../harness/room.ts';

const room = useRoom();

describe.each(CLIENT_KINDS)('%s', (kind) => {
  describe.skipIf(whyMissing(kind))(suiteName(kind), () => {
    test('connects over the old ports and is listed as active under its own name [CL-1] [EC-18]', async () => {
      const guest = await room.joins(kind, 'a guest of old');
      const ours = await room.oursJoins();
      const listed = await room.listed(ours, guest.clientId);
      expect(listed).toMatchObject({ name: 'a guest of old', state: 0 });
      expect(guest.complaints).toEqual([]);
    });

    test('connects over the main port [TD-1] [EC-7]', async () => {
      const guest = await LegacyClient.start(kind);
      try {
        const { servicesJson, topicDataWs } = room.master.endpoints;
        const { clientId } = await guest.connect(
          { services: servicesJson, topicData: topicDataWs },
          'guest',
        );
        const ours = await room.oursJoins();
        expect(await room.listed(ours, clientId)).toMatchObject({ name: 'guest', state: 0 });
        expect(guest.complaints).toEqual([]);
      } finally {
        await guest.stop();
      }
    });

    test('finds what it reads of the server configuration [SV-10] [EC-3] [EC-4] [EC-14]', async () => {
      const guest = await LegacyClient.start(kind);
      try {
        const { server } = await guest.connect(room.legacy, 'guest');
        expect(server).toMatchObject({
          portServiceRest: expect.stringMatching(/^\d+$/),
          portTopicDataWs: expect.stringMatching(/^\d+$/),
          ipEthernet: '',
          ipWlan: '',
        });
        expect(JSON.parse(String(server['constantsJson']))).toHaveProperty(
          'DEFAULT_TOPICS.SERVICES',
        );
      } finally {
        await guest.stop();
      }
    });
  });
});

test('[CL-2] [EC-5] a nodejs node with a module file in its folder sends a null module and is accepted', async () => {
  const guest = await LegacyClient.start('nodejs', async (folder) => {
    const { mkdir, writeFile } = await import('node:fs/promises');
    await mkdir(`${folder}/database/processing`, { recursive: true });
    await writeFile(`${folder}/database/processing/mirror.pm`, '{ "name": "mirror" }');
  });
  try {
    const { clientId, client } = await guest.connect(room.legacy, 'guest with a module');
    expect(client).toMatchObject({ processingModules: [], isDedicatedProcessingNode: true });
    const ours = await room.oursJoins();
    expect(await room.listed(ours, clientId)).toMatchObject({ name: 'guest with a module' });
  } finally {
    await guest.stop();
  }
});

test.skipIf(whyMissing('python'))(
  '[SV-10] the strict constants of the Python node are satisfied, and it moves to the ports it is told',
  async () => {
    const guest = await LegacyClient.start('python');
    try {
      const connected = await guest.connect(
        { services: room.master.endpoints.servicesJson, topicData: '' },
        'guest',
      );
      expect(connected.subscriptionTopic).toBe('/services/topic_subscription');
      expect(connected.servicesUrl).toBe(room.legacy.services);
    } finally {
      await guest.stop();
    }
  },
);
