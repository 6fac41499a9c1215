import { AccessRole } from '@ubii/proto';
import { describe, expect, it, vi } from 'vitest';
import { WebSocket } from 'ws';

import {
  PATH_RIGHTS,
  ROLES_BY_RIGHTS,
  SOCKET_RIGHTS,
  type SocketRight,
} from '../../src/core/access/rights-table.ts';
import type { Role } from '../../src/core/access/roles.ts';
import { send, startEdgeMaster } from './edge-master.ts';

// A whole master each: minutes on a busy machine are no fault of it.
vi.setConfig({ testTimeout: 60_000 });

/** A caller behind a proxy is not local [AC-1]. */
const ELSEWHERE = { 'x-forwarded-for': '203.0.113.7' };
const JSON_HEADERS = { 'content-type': 'application/json' };
/** Paths that a master could have and does not. */
const PATHS_WITHOUT_ROW = ['/services/yaml', '/admin', '/metrics/json', '/services/json/x'];

interface Joined {
  readonly headers: Readonly<Record<string, string>>;
  /** Query of the topic-data socket's URL. */
  readonly query: string;
}

async function post(port: number, headers: object, body: object): Promise<Record<string, never>> {
  const { status, body: reply } = await send(port, '/services/json', {
    method: 'POST',
    headers: { ...JSON_HEADERS, ...headers },
    body: JSON.stringify(body),
  });
  if (status !== 200) throw new Error(`The master answered ${status}: ${String(reply)}`);
  return JSON.parse(String(reply)) as Record<string, never>;
}

/** Joins from elsewhere with this role, by a grant of its own; a stranger does not. */
async function joinAs(port: number, role: Role): Promise<Joined> {
  if (role === 'none') return { headers: ELSEWHERE, query: '?clientID=unknown' };
  const name = `ACCESS_ROLE_${role.toUpperCase()}` as keyof typeof AccessRole;
  const { accessGrantCreated } = await post(
    port,
    {},
    {
      topic: '/services/ubii/access_grant_create',
      accessGrantCreateRequest: { role: AccessRole[name] },
    },
  );
  const { token } = accessGrantCreated as unknown as { token: string };
  const { client } = await post(
    port,
    { ...ELSEWHERE, authorization: `Bearer ${token}` },
    { topic: '/services/client/registration', client: { name: role, extension: {} } },
  );
  const { id, extension } = client as unknown as {
    id: string;
    extension: { credential: string; resumeToken: string };
  };
  return {
    headers: { ...ELSEWHERE, authorization: `Bearer ${extension.credential}` },
    query: `?clientID=${id}&token=${extension.resumeToken}`,
  };
}

/** Whether the upgrade is let through. */
function opens(port: number, path: string, { headers, query }: Joined): Promise<boolean> {
  return new Promise((resolve) => {
    // The preflight is at its path exactly; its request carries nothing else.
    const isPreflight = path === SOCKET_RIGHTS.preflight.path;
    const at = isPreflight ? path : `${path.replace('*', 'topicdata')}${query}`;
    const socket = new WebSocket(`ws://127.0.0.1:${port}${at}`, { headers });
    socket.on('open', () => {
      resolve(true);
      socket.terminate();
    });
    socket.on('unexpected-response', () => {
      resolve(false);
      socket.terminate();
    });
    socket.on('error', () => undefined);
  });
}

describe('paths, in both directions [AC-5] [AC-21]', () => {
  it.each(ROLES_BY_RIGHTS)('%s', async (role) => {
    const { port } = await startEdgeMaster();
    const { headers } = await joinAs(port, role);
    for (const { method, path, roles } of PATH_RIGHTS) {
      const { status } = await send(port, path.replace('*', ''), {
        method,
        headers: { ...headers, ...(method === 'POST' && JSON_HEADERS) },
        ...(method === 'POST' && { body: '{}' }),
      });
      const refusal = role === 'none' ? 401 : 403;
      expect([method, path, status === refusal]).toEqual([method, path, !roles.includes(role)]);
    }
  });

  it.each(ROLES_BY_RIGHTS)('%s gets nothing where the table has no row', async (role) => {
    const { port } = await startEdgeMaster();
    const { headers } = await joinAs(port, role);
    const methods = ['POST', 'PUT', 'DELETE', 'PATCH'];
    const paths = new Set([...PATHS_WITHOUT_ROW, ...PATH_RIGHTS.map(({ path }) => path)]);
    for (const path of paths) {
      for (const method of methods) {
        if (PATH_RIGHTS.some((row) => row.method === method && row.path === path)) continue;
        const at = path.replace('*', '');
        const { status } = await send(port, at, { method, headers });
        expect([method, path, status]).toEqual([method, path, 404]);
      }
    }
  });
});

describe('WebSockets, in both directions [AC-27] [AC-29]', () => {
  it.each(ROLES_BY_RIGHTS)('%s', async (role) => {
    const { port } = await startEdgeMaster();
    const joined = await joinAs(port, role);
    for (const { path, roles } of Object.values<SocketRight>(SOCKET_RIGHTS)) {
      expect([path, await opens(port, path, joined)]).toEqual([path, roles.includes(role)]);
    }
  });
});
