import { createEngineSandboxes } from '../../testing/inline-sandboxes.ts';
import { describeSandboxes } from '../../testing/sandbox-suite.ts';
import { createQuickJsEngine } from './quickjs-engine.ts';

describeSandboxes('QuickJS on the thread of the test', {
  createSandboxes: async () =>
    createEngineSandboxes(
      await createQuickJsEngine({ stackBytes: 64_000, nowMs: () => performance.now() }),
    ),
  isTrusted: false,
  hasLimits: true,
});
