import { useLocalStorage } from '@vueuse/core';

/** The token and code of an invitation; the master shows them once. [AC-11] */
export interface GrantSecret {
  readonly token: string;
  readonly code: string;
}

/**
 * Codes that this browser made, so that the same one is shown again instead of another being made. They
 * let people in and nothing more; what is over is forgotten.
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
