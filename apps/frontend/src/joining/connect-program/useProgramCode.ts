import { ConnectionError } from '@ubii/client-web';
import { AccessRole } from '@ubii/proto';
import { computed, shallowRef, watch, type ComputedRef, type Ref, type ShallowRef } from 'vue';
import { tryRequest, type RequestError } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';

const MINUTE_MS = 60_000;
const HOUR_MS = 60 * MINUTE_MS;

/** What a program joins with: programs have a code that is used once, pages a token for each of their loads. */
export type SecretKind = 'code' | 'token' | 'none';

export interface ProgramCode {
  readonly secret: ComputedRef<string | undefined>;
  /** Why there is none, one sentence. */
  readonly problem: Readonly<ShallowRef<string | undefined>>;
  /** Only an admin makes them. */
  readonly isForbidden: Readonly<ShallowRef<boolean>>;
  /** Makes another one. */
  renew(): Promise<void>;
}

const INVITATIONS = {
  code: {
    label: 'Connect a program',
    lifetimeMs: 15 * MINUTE_MS,
    stayMs: 12 * HOUR_MS,
    maxJoins: 1,
  },
  token: { label: 'Connect a page', lifetimeMs: 12 * HOUR_MS, stayMs: 12 * HOUR_MS, maxJoins: 0 },
} as const;

/** The token of this page load: pages that are tried one after the other join with the same one. */
let token: { readonly text: string; readonly untilMs: number } | undefined;
const MIN_LEFT_MS = HOUR_MS;

/** Invites one program: once for each kind, while the page is open. */
export function useProgramCode(kind: Readonly<Ref<SecretKind>>): ProgramCode {
  const { client, isConnected } = useConnection();
  const isGood = token !== undefined && token.untilMs - Date.now() > MIN_LEFT_MS;
  const secrets = shallowRef<Partial<Record<SecretKind, string>>>(
    isGood ? { token: token!.text } : {},
  );
  const problem = shallowRef<string>();
  const isForbidden = shallowRef(false);
  let making: SecretKind | undefined;

  async function make(wanted: 'code' | 'token'): Promise<void> {
    if (making === wanted) return;
    making = wanted;
    problem.value = undefined;
    try {
      await tryRequest(async () => {
        const role = AccessRole.ACCESS_ROLE_PARTICIPANT;
        const made = await client.call('accessGrantCreate', { ...INVITATIONS[wanted], role });
        secrets.value = { ...secrets.value, [wanted]: made[wanted] };
        if (wanted === 'token') {
          token = { text: made.token, untilMs: Date.now() + INVITATIONS.token.lifetimeMs };
        }
      }, refuse);
    } finally {
      making = undefined;
    }
  }
  function refuse(cause: RequestError): void {
    if (cause instanceof ConnectionError) return; // It is made when the master is back.
    if (cause.code === 'permission_denied') isForbidden.value = true;
    else problem.value = cause.message;
  }

  function makeMissing(): void {
    const wanted = kind.value;
    if (wanted === 'none' || !isConnected.value || secrets.value[wanted] !== undefined) return;
    void make(wanted);
  }
  watch([kind, isConnected], makeMissing, { immediate: true });

  return {
    secret: computed(() => secrets.value[kind.value]),
    problem,
    isForbidden,
    renew: async () => {
      if (kind.value !== 'none') await make(kind.value);
    },
  };
}
