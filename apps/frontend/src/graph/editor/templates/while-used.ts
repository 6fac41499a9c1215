import { effectScope, onScopeDispose, type EffectScope } from 'vue';

/**
 * One for all who use it, kept while anybody does; and from one page to the next, where the first is
 * gone before the other is there.
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
