// @vitest-environment happy-dom
import { AccessRole, MasterAddressKind, type MasterAddress } from '@ubii/proto';
import { flushPromises, mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, ref, shallowRef } from 'vue';
import { CONNECTION, type Connection } from '../../connection/connection.ts';
import type { RoleChoice } from './grant-choices.ts';
import { useConnectPhone } from './useConnectPhone.ts';

const LOOPBACK = { kind: MasterAddressKind.LOOPBACK, url: 'http://localhost:8080' };
const WIFI = { kind: MasterAddressKind.WIFI, interfaceName: 'wlan0', url: 'https://10.0.0.7:8080' };

/** Mounts the composable of the dialog in an admin's browser. */
function open(
  addresses: readonly Partial<MasterAddress>[],
  ...more: [opens?: string, roles?: readonly [RoleChoice, ...RoleChoice[]]]
) {
  const view = shallowRef<unknown>({ latest: { addresses }, clock: { offsetMs: 0 } });
  const call = vi.fn((service: string, request: object = {}): Promise<unknown> => {
    if (service === 'accessGrantList') return Promise.resolve({ elements: [] });
    const now = Date.now();
    const grant = { id: 'g', createdMs: now, expiresMs: now + 8 * 3_600_000, ...request };
    return Promise.resolve({
      grant: { ...grant, staysUntilMs: now + 12 * 3_600_000, joins: 0, revokedMs: 0, maxJoins: 0 },
      token: 'token',
      code: 'ABCD-EFGH',
    });
  });
  const connection = {
    client: { call, role: 'admin' },
    state: shallowRef({ status: 'connected' }),
    isConnected: ref(true),
    master: { view, isUnsupported: ref(false), error: ref(undefined) },
    clients: { list: shallowRef([]) },
  } as unknown as Connection;
  let connect!: ReturnType<typeof useConnectPhone>;
  const wrapper = mount(
    defineComponent({
      setup() {
        connect = useConnectPhone(true, ...more);
        return () => null;
      },
    }),
    { global: { provide: { [CONNECTION as symbol]: connection } } },
  );
  const created = () => call.mock.calls.filter(([service]) => service === 'accessGrantCreate');
  return { connect, created, view, wrapper };
}

beforeEach(() => {
  localStorage.clear();
  vi.stubGlobal('location', { href: 'http://localhost:8080/', origin: 'http://localhost:8080' });
});
afterEach(() => void vi.unstubAllGlobals());

describe('useConnectPhone', () => {
  it('creates no invitation while no phone can reach the master, and one as soon as it can', async () => {
    const { connect, created, view } = open([LOOPBACK]);
    await flushPromises();
    expect(connect.url.value).toBeUndefined();
    expect(created()).toHaveLength(0);

    view.value = { latest: { addresses: [WIFI, LOOPBACK] }, clock: { offsetMs: 0 } };
    await flushPromises();
    expect(created()).toHaveLength(1);
    expect(connect.scanned.value).toBe('https://10.0.0.7:8080/join#token');
  });

  it('invites with the first of the roles that a page gives, and leaves the one selected last', async () => {
    localStorage.setItem('ubii.connect.role', 'admin');
    const { created } = open([WIFI], '/devices/smart-device', ['player', 'viewer']);
    await flushPromises();
    const { ACCESS_ROLE_PLAYER: role } = AccessRole;
    expect(created().map(([, request]) => request)).toMatchObject([
      { role, target: '/devices/smart-device' },
    ]);
    expect(localStorage.getItem('ubii.connect.role')).toBe('admin');
  });

  it('creates one invitation at once where phones can reach the master', async () => {
    const { created, connect } = open([WIFI, LOOPBACK]);
    await flushPromises();
    expect(created()).toHaveLength(1);
    expect(connect.secret.value?.code).toBe('ABCD-EFGH');
  });
});
