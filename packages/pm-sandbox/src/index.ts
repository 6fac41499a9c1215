export {
  defineProcessingModule,
  type AnyModuleDefinition,
  type ModeInit,
  type ModuleDefinition,
  type ModuleState,
  type NodeState,
  type ProcessingResult,
} from './definition/define-processing-module.ts';
export type {
  IoInit,
  IoInits,
  ModuleElement,
  ModuleElementValue,
  ModuleInput,
  ModuleInputs,
  ModuleOutput,
  ModuleOutputs,
  ModuleRecord,
  ModuleValue,
} from './definition/io-types.ts';
export { undeclaredName } from './worker/nearest-name.ts';
export { exampleOf } from './worker/value-words.ts';
export { MIN_MODULE_BYTES } from './worker/quickjs/engine-pages.ts';
export {
  MAX_CHOICE_CHARACTERS,
  MAX_CHOICES,
  MAX_IO_DESCRIPTION_CHARACTERS,
} from './definition/io-limits.ts';
export { moduleProblems, type ModuleProblem } from './definition/module-problems.ts';
export { moduleToWire } from './definition/module-to-wire.ts';
export {
  parseMode,
  parseModule,
  type ParsedIo,
  type ParsedMode,
  type ParsedModule,
} from './definition/parse-module.ts';
export { DEFAULT_RUNTIME_LIMITS, type RuntimeLimits } from './limits.ts';
export { AssetError, type AssetErrorCode } from './assets/asset-error.ts';
export type { AssetFile, AssetManifest } from './assets/asset-manifest.ts';
export type { AssetSource } from './assets/asset-source.ts';
export {
  createAssetStore,
  type AssetProgress,
  type AssetStore,
  type LoadedAssets,
} from './assets/asset-store.ts';
export { ASSETS_PATH, createHttpAssets } from './assets/http-assets.ts';
export type { ModuleFault, ModuleFaultKind, ModulePhase } from './ports/module-fault.ts';
export type {
  ModuleSource,
  Sandbox,
  SandboxCall,
  SandboxEvents,
  SandboxFactory,
  SandboxInput,
  SandboxLimits,
  SandboxMemory,
  SandboxOutput,
  SandboxRecord,
  SandboxRequest,
  SandboxResult,
  SandboxValue,
} from './ports/sandbox.ts';
export type { EncodedRecord, TopicListener, TopicPort, TopicSelector } from './ports/topic-port.ts';
export { constantRecord, type ConstantRecord } from './runtime/binding/constant-record.ts';
export {
  demuxTopic,
  hasPlaceholder,
  parseDemuxFormat,
  type DemuxFormat,
  type DemuxTopic,
} from './runtime/binding/demux-topic.ts';
export { formatsFit } from './runtime/binding/formats-fit.ts';

export { InputBinding } from './runtime/binding/input-binding.ts';
export type { SlotContext, Snapshot } from './runtime/binding/input-slot.ts';
export { identityOf, identityRule, type IdentityRule } from './runtime/binding/mux-identity.ts';
export { muxSelector, selectorMatch } from './runtime/binding/mux-selector.ts';
export {
  mappingNeedsPatterns,
  muxNeedsPatterns,
  SessionPatterns,
  type PatternTimes,
} from './runtime/binding/session-patterns.ts';
export { InstanceKeeper } from './reconciler/instance-keeper.ts';
export {
  hasSameCode,
  identityChanges,
  moduleIdentity,
  type IdentityField,
} from './reconciler/module-identity.ts';
export type { WantedInstance } from './reconciler/reconcile.ts';
export { eventKey } from './runtime/reports/event-key.ts';
export { createModuleRuntime, type ModuleRuntimeOptions } from './runtime/create-module-runtime.ts';
export type {
  InstanceSpec,
  ModuleRuntime,
  PassReply,
  PassRequest,
} from './runtime/module-runtime.ts';
export { SANDBOX_WORKER_FILES, type SandboxWorkerFile } from './sandbox-worker-files.ts';
