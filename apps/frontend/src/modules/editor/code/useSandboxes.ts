import type { SandboxFactory } from '@ubii/pm-sandbox';
import { onScopeDispose } from 'vue';

/** Sandboxes of this page, loaded on first use, and closed with it. */
export function useSandboxes(): () => Promise<SandboxFactory> {
  let opening: Promise<SandboxFactory> | undefined;
  let isOver = false;
  onScopeDispose(() => {
    isOver = true;
    void opening?.then((sandboxes) => sandboxes.close());
  });
  return () =>
    (opening ??= import('@ubii/pm-sandbox/browser').then(({ createBrowserSandboxes }) => {
      const sandboxes = createBrowserSandboxes({ maxWorkers: 2 });
      if (isOver) void sandboxes.close();
      return sandboxes;
    }));
}
