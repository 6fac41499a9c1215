export { createInlineSandboxes, type InlineSandboxOptions } from './inline-sandboxes.ts';
export {
  elementsInput,
  faultFrom,
  openSandbox,
  recordInput,
  valuesOf,
  type OpenSandbox,
  type SandboxInit,
} from './sandbox-fixture.ts';
export { describeSandboxes, type SandboxSuite } from './sandbox-suite.ts';
