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
