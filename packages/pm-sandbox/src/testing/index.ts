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
export { FakeAssets, loadedAssets, manifestOf, type AssetTexts } from './fake-assets.ts';
export {
  EMPTY_RESULT,
  FakeSandbox,
  FakeSandboxes,
  inputValues,
  sandboxOutput,
  sandboxValue,
} from './fake-sandboxes.ts';
export { FakeTopics, type FakeComponent } from './fake-topics.ts';
export {
  createModuleWorld,
  instanceSpec,
  ioMapping,
  type ModuleSketch,
  type ModuleWorld,
} from './module-world.ts';
export { describeTopicPort, type TopicPortWorld } from './topic-port-suite.ts';
