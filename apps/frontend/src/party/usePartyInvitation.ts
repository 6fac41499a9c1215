import { AccessRole } from '@ubii/proto';
import { PLAYER_READS } from '@ubii/party/net';
import type { Invitation } from '@ubii/party/screen';
import { computed, ref } from 'vue';
import { addressParts, joinAddress, phoneAddresses } from '../joining/connect-phone/addresses.ts';
import type { GrantChoice } from '../joining/connect-phone/grant-choices.ts';
import { useGrants } from '../joining/connect-phone/useGrants.ts';
import { useConnection } from '../connection/useConnection.ts';
import { JOIN_PATH } from '../locations/join-location.ts';
import { PARTY_PHONE_PATH } from '../locations/party-location.ts';

const HOUR_MS = 3_600_000;

/** Invitation for phones with the role of a player. */
const CHOICE: GrantChoice = {
  target: PARTY_PHONE_PATH,
  role: AccessRole.ACCESS_ROLE_PLAYER,
  lifetimeMs: 8 * HOUR_MS,
  stayMs: 12 * HOUR_MS,
  readTopics: PLAYER_READS,
};

/** Joining of phones: URL, code, and content of the QR code. */
export function usePartyInvitation() {
  const { master } = useConnection();
  const addresses = computed(() =>
    phoneAddresses(master.view.value?.latest.addresses ?? [], location.href),
  );
  const url = computed(() => addresses.value[0]?.url);
  const grants = useGrants(
    computed(() => CHOICE),
    ref(true),
    computed(() => master.view.value !== undefined && url.value !== undefined),
  );
  const invitation = computed<Invitation | undefined>(() => {
    const secret = grants.secret.value;
    if (url.value === undefined || secret === undefined) return undefined;
    const { host, port } = addressParts(url.value);
    return {
      address: `${host.replace('https://', '')}${port}${JOIN_PATH}`,
      code: secret.code,
      scanned: joinAddress(url.value, secret.token),
    };
  });
  return {
    invitation,
    /** URL of the master for phones; undefined when no phone can reach it. */
    url,
    /** False while no phone can reach this master. */
    isReachable: computed(() => url.value !== undefined),
    isKnown: computed(() => master.view.value !== undefined),
    isAdmin: grants.isAdmin,
    error: grants.error,
  };
}
