import { SERVICES, type ServiceReply } from '@ubii/proto';
import { expect, it } from 'vitest';

import { send, startEdgeMaster } from './edge-master.ts';

const PUBLIC_URL = 'https://ubii.example.org';
/** What a proxy on this machine passes on. */
const PASSED_ON = { host: 'ubii.example.org', 'x-forwarded-for': '203.0.113.7' };

it('[SV-13] a master of this machine alone is joined at its public address', async () => {
  const { port, terminal } = await startEdgeMaster({
    flags: ['--trusted-proxy', '127.0.0.1', '--public-url', PUBLIC_URL],
  });
  const call = async (topic: string, payload: object, bearer = ''): Promise<ServiceReply> => {
    const { body } = await send(port, '/services/json', {
      method: 'POST',
      headers: {
        ...PASSED_ON,
        origin: PUBLIC_URL,
        'content-type': 'application/json',
        ...(bearer && { authorization: `Bearer ${bearer}` }),
      },
      body: JSON.stringify({ topic, ...payload }),
    });
    return JSON.parse(body.toString()) as ServiceReply;
  };
  const registration = [
    SERVICES.clientRegistration.topic,
    { client: { name: 'phone', extension: {} } },
  ] as const;
  expect((await call(...registration)).error?.code).toBe('unauthenticated');
  const { client } = await call(...registration, terminal.join!.token);
  expect(client?.name).toBe('phone');
  const status = [SERVICES.masterStatus.topic, { masterStatusRequest: {} }] as const;
  const { masterStatus } = await call(...status, client?.extension?.credential);
  expect(masterStatus?.addresses?.map(({ kind, url }) => [kind, url])).toEqual([
    ['PUBLIC', PUBLIC_URL],
    ['LOOPBACK', `http://localhost:${port}`],
  ]);
});
