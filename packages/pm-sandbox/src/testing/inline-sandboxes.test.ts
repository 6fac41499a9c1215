import { createInlineSandboxes } from './inline-sandboxes.ts';
import { describeSandboxes } from './sandbox-suite.ts';

describeSandboxes('inline', {
  createSandboxes: () => createInlineSandboxes(),
  isTrusted: true,
  hasLimits: false,
});
