import { reportRejection } from '../callbacks/program-errors.ts';
import type { ErrorHandler } from '../ports/error-handler.ts';
import type { IdentityStorage } from '../ports/identity-storage.ts';

/**
 * A storage whose errors go to `onError`: a storage that fails costs the identity of the next run, not
 * the connection of this one.
 */
export function reportingStorage(
  storage: IdentityStorage,
  onError: ErrorHandler,
): Required<IdentityStorage> {
  const report = (error: unknown): undefined => void onError(error, 'identity-storage');
  const attempt = <R>(use: () => R): R | undefined => {
    try {
      const result = use();
      reportRejection(result, 'identity-storage', onError);
      return result;
    } catch (error) {
      return report(error);
    }
  };
  return {
    load: async () => {
      try {
        return await storage.load();
      } catch (error) {
        return report(error);
      }
    },
    save: (identity) => attempt(() => storage.save(identity)),
    loadCredential: () => attempt(() => storage.loadCredential?.()),
    forgetCredential: (credential) => attempt(() => storage.forgetCredential?.(credential)),
  };
}
