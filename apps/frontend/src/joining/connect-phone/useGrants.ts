import { ConnectionError } from '@ubii/client-web';
import type { AccessGrant, RevokedWork } from '@ubii/proto';
import { computed, ref, shallowRef, watch, type Ref } from 'vue';
import { usePoll } from '../../connection/poll.ts';
import { tryRequest, type RequestError } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { isOpen, reusable, type GrantChoice } from './grant-choices.ts';
import { useGrantSecrets } from './grant-secrets.ts';

const INTERVAL_MS = 2000;

/**
 * Lists the invitations of this master for an admin, and creates one for the current choice unless an open one exists.
 *
 * @param mayMake false until the user requests a code
 * @param isReachable false while no phone can reach the master: then no invitation is created
 */
export function useGrants(
  choice: Ref<GrantChoice>,
  mayMake: Ref<boolean>,
  isReachable: Readonly<Ref<boolean>>,
) {
  const { client, state, isConnected, master, clients } = useConnection();
  const secrets = useGrantSecrets();
  const grants = shallowRef<readonly AccessGrant[]>();
  const error = ref('');
  /** True for masters without roles, where every client has access. */
  const isUnsupported = ref(false);
  const isMaking = ref(false);
  const nowMs = (): number => Date.now() + (master.view.value?.clock.offsetMs ?? 0);

  const ownRole = computed(() => (state.value.status === 'connected' ? client.role : undefined));
  const isAdmin = computed(() => ownRole.value === 'admin');
  const current = computed(() =>
    reusable(grants.value ?? [], choice.value, nowMs(), (id) => secrets.get(id) !== undefined),
  );
  const secret = computed(() => (current.value ? secrets.get(current.value.id) : undefined));

  function refuse(cause: RequestError): void {
    if (cause instanceof ConnectionError) return; // Shown by the connection's state.
    if (cause.code === 'unimplemented' || cause.code === 'not_found') isUnsupported.value = true;
    error.value = cause.message;
  }
  const request = (work: () => Promise<void>): Promise<void> =>
    tryRequest(async () => {
      await work();
      error.value = '';
    }, refuse);

  const refresh = (): Promise<void> =>
    request(async () => {
      const { elements } = await client.call('accessGrantList');
      grants.value = elements;
      secrets.keep(new Set(elements.filter((one) => isOpen(one, nowMs())).map(({ id }) => id)));
      if (mayMake.value) await make();
    });

  /** Creates an invitation for the current choice unless an open one exists. */
  async function make(): Promise<void> {
    if (!isReachable.value) return;
    if (isMaking.value || current.value !== undefined || grants.value === undefined) return;
    isMaking.value = true;
    try {
      const { target, role: wanted, lifetimeMs, stayMs, readTopics = [] } = choice.value;
      const created = await client.call('accessGrantCreate', {
        label: 'Connect a phone',
        role: wanted,
        target,
        lifetimeMs,
        stayMs,
        readTopics: [...readTopics],
      });
      if (created.grant === undefined) return;
      secrets.add(created.grant.id, created);
      grants.value = [created.grant, ...grants.value];
    } finally {
      isMaking.value = false;
    }
  }

  const revoke = (grant: AccessGrant, work: RevokedWork): Promise<void> =>
    request(async () => {
      mayMake.value = false; // Otherwise the next refresh creates a replacement.
      await client.call('accessGrantRevoke', {
        grantId: grant.id,
        reason: 'the host revoked the invitation',
        work,
      });
      await refresh();
    });

  usePoll(
    refresh,
    INTERVAL_MS,
    computed(() => isConnected.value && isAdmin.value && !isUnsupported.value),
  );
  watch([choice, mayMake, isReachable], () => {
    if (mayMake.value && isAdmin.value && isConnected.value) void request(make);
  });
  // Show new devices at once.
  watch(clients.list, (list, before) => {
    if (list?.length !== before?.length && isConnected.value && isAdmin.value) void refresh();
  });

  return {
    grants,
    current,
    secret,
    error,
    isAdmin,
    /** Role of this page. */
    ownRole,
    isUnsupported,
    isMaking,
    nowMs,
    revoke,
    refresh,
  };
}
