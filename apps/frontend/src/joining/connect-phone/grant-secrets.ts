import { useLocalStorage } from '@vueuse/core';

/** Token and code of an invitation; the master returns them only once. [AC-11] */
export interface GrantSecret {
  readonly token: string;
  readonly code: string;
}

/**
 * Secrets of invitations created in this browser, to show them again instead of creating others. They only permit
 * joining; expired ones are removed.
 */
export function useGrantSecrets() {
  const secrets = useLocalStorage<Record<string, GrantSecret>>('ubii.grants', {});
  return {
    get: (grantId: string): GrantSecret | undefined => secrets.value[grantId],
    add(grantId: string, { token, code }: GrantSecret): void {
      secrets.value = { ...secrets.value, [grantId]: { token, code } };
    },
    /** Removes the secrets of all other invitations. */
    keep(grantIds: ReadonlySet<string>): void {
      const kept = Object.entries(secrets.value).filter(([id]) => grantIds.has(id));
      if (kept.length < Object.keys(secrets.value).length) {
        secrets.value = Object.fromEntries(kept);
      }
    },
  };
}
