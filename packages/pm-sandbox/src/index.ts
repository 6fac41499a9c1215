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
export { moduleProblems, type ModuleProblem } from './definition/module-problems.ts';
export { moduleToWire } from './definition/module-to-wire.ts';
export {
  parseMode,
  parseModule,
  type ParsedIo,
  type ParsedMode,
  type ParsedModule,
} from './definition/parse-module.ts';
export type { Cancel, Clock } from './ports/clock.ts';
export type { ModuleFault, ModuleFaultKind, ModulePhase } from './ports/module-fault.ts';
export type {
  ModuleSource,
  Sandbox,
  SandboxCall,
  SandboxEvents,
  SandboxFactory,
  SandboxInput,
  SandboxLimits,
  SandboxOutput,
  SandboxRecord,
  SandboxRequest,
  SandboxResult,
  SandboxValue,
} from './ports/sandbox.ts';
export type { EncodedRecord, TopicListener, TopicPort, TopicSelector } from './ports/topic-port.ts';
export type {
  InstanceSpec,
  ModuleRuntime,
  PassReply,
  PassRequest,
} from './runtime/module-runtime.ts';
