import { useLocalStorage } from '@vueuse/core';
import { computed, ref, shallowRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { phoneAddresses } from './addresses.ts';
import {
  LIFETIMES,
  STAYS,
  ROLES,
  TARGETS,
  type GrantChoice,
  type LifetimeChoice,
  type StayChoice,
  type RoleChoice,
} from './grant-choices.ts';
import { joinAddress, pageAddress } from './addresses.ts';
import { useGrants } from './useGrants.ts';

/**
 * Provides an address, a code and a page for joining with a phone.
 *
 * @param makesAtOnce creates an invitation at once, if a phone can reach the master
 * @param opens the page that is selected at first; not remembered. @default the page selected last
 * @param roles roles to choose from, the first one at first; not remembered. @default all, at first the role selected last
 */
export function useConnectPhone(
  makesAtOnce: boolean,
  opens?: string,
  roles?: readonly [RoleChoice, ...RoleChoice[]],
) {
  const { master } = useConnection();
  const remembered = useLocalStorage<string>('ubii.connect.page', TARGETS[0].value);
  const page = opens === undefined ? remembered : ref(opens);
  const lastRole = useLocalStorage<RoleChoice>('ubii.connect.role', 'participant');
  const role = roles === undefined ? lastRole : ref(roles[0]);
  const lifetime = useLocalStorage<LifetimeChoice>('ubii.connect.lifetime', 'day');
  const stay = useLocalStorage<StayChoice>('ubii.connect.stay', 'day');
  const mayMake = ref(makesAtOnce);
  const chosen = shallowRef<string>();

  const choice = computed<GrantChoice>(() => ({
    target: page.value,
    role: (ROLES.find(({ value }) => value === role.value) ?? ROLES[0]).role,
    lifetimeMs: (LIFETIMES.find(({ value }) => value === lifetime.value) ?? LIFETIMES[1])
      .lifetimeMs,
    stayMs: (STAYS.find(({ value }) => value === stay.value) ?? STAYS[1]).stayMs,
  }));
  const isKnown = computed(
    () =>
      master.view.value !== undefined ||
      master.isUnsupported.value ||
      master.error.value !== undefined,
  );
  const addresses = computed(() =>
    phoneAddresses(master.view.value?.latest.addresses ?? [], location.href),
  );
  const url = computed({
    get: () => (addresses.value.find((one) => one.url === chosen.value) ?? addresses.value[0])?.url,
    set: (next) => (chosen.value = next),
  });
  const grants = useGrants(
    choice,
    mayMake,
    computed(() => isKnown.value && url.value !== undefined),
  );
  /** Whether this browser creates invitations; otherwise the plain URL of the page is shown. */
  const usesCodes = computed(() => grants.isAdmin.value && !grants.isUnsupported.value);
  /** Content of the QR code; `undefined` while there is none. */
  const scanned = computed(() => {
    if (url.value === undefined) return undefined;
    if (!usesCodes.value) return pageAddress(url.value, page.value);
    const token = grants.secret.value?.token;
    return token === undefined ? undefined : joinAddress(url.value, token);
  });

  return {
    ...grants,
    page,
    role,
    lifetime,
    stay,
    mayMake,
    choice,
    isKnown,
    addresses,
    url,
    usesCodes,
    scanned,
  };
}
