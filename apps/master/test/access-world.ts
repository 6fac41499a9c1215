import type { AccessGrantCreated, AccessGrantCreateRequest, AccessRole, Init } from '@ubii/proto';
import { JoinProblem } from '@ubii/proto';
import type { CallerFacts } from '../src/index.ts';
import type { TestClient, TestMaster } from '../src/testing/index.ts';

/** A caller of another machine. */
export function stranger(bearer?: string, place = '192.168.1.50'): CallerFacts {
  return { standing: 'other', isHere: false, place, bearer };
}

/** A caller of a network that is admitted without a token. */
export const NETWORK_CALLER: CallerFacts = {
  standing: 'network',
  isHere: false,
  place: '10.0.0.7',
  bearer: undefined,
};

export async function createGrant(
  master: TestMaster,
  role: AccessRole,
  wanted: Init<AccessGrantCreateRequest> = {},
): Promise<AccessGrantCreated> {
  const { accessGrantCreated, error } = await master.call({
    topic: '/services/ubii/access_grant_create',
    accessGrantCreateRequest: { role, ...wanted },
  });
  if (accessGrantCreated === undefined) throw new Error(error?.message);
  return accessGrantCreated;
}

/** A client of ours that joined from another machine, with an open socket. */
export async function join(
  master: TestMaster,
  bearer: string,
  name = 'phone',
): Promise<TestClient> {
  const client = await master.register({ name, extension: {} }, stranger(bearer));
  client.open();
  return client;
}

/** A client with the role, on a grant of its own. */
export async function joinAs(
  master: TestMaster,
  role: AccessRole,
  wanted: Init<AccessGrantCreateRequest> = {},
): Promise<TestClient> {
  return join(master, (await createGrant(master, role, wanted)).token);
}

/** Why a caller is not admitted, as its error says; the code when it is another error. */
export async function problemOf(
  master: TestMaster,
  caller: CallerFacts,
  client: object = { name: 'phone', extension: {} },
): Promise<JoinProblem | string> {
  const { error } = await master.call({ topic: '/services/client/registration', client }, caller);
  return error?.join?.problem ?? error?.code ?? JoinProblem.JOIN_PROBLEM_NONE;
}

/** The code of the error that a call ends with; empty when it succeeds. */
export async function codeOf(
  client: Pick<TestClient, 'call'>,
  request: Parameters<TestClient['call']>[0],
): Promise<string> {
  return (await client.call(request)).error?.code ?? '';
}

export function revoke(master: TestMaster, grantId: string, reason = 'it is over') {
  return master.call({
    topic: '/services/ubii/access_grant_revoke',
    accessGrantRevokeRequest: { grantId, reason },
  });
}
