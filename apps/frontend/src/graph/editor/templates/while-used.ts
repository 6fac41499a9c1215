import { effectScope, onScopeDispose, type EffectScope } from 'vue';

/**
 * Shares one instance between all users, and keeps it while it is used; also across navigation, where the old page is
 * unmounted before the new one is mounted.
 */
export function whileUsed<T>(make: () => T): () => T {
  let users = 0;
  let scope: EffectScope | undefined;
  let made: T | undefined;
  return () => {
    users += 1;
    onScopeDispose(() => {
      users -= 1;
      setTimeout(() => {
        if (users > 0) return;
        scope?.stop();
        scope = undefined;
        made = undefined;
      });
    });
    scope ??= effectScope(true);
    made ??= scope.run(make)!;
    return made;
  };
}
