import type { ModuleEvent, ProcessingModuleStatus } from '@ubii/proto';
import type { Clock, EndOfTurn } from '@ubii/timing';
import type { RuntimeLimits } from '../limits.ts';
import type { AssetStore } from '../assets/asset-store.ts';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { SandboxFactory } from '../ports/sandbox.ts';
import type { TopicPort } from '../ports/topic-port.ts';
import type { RecordCompletion } from './binding/record-completion.ts';
import type { SessionPatterns } from './binding/session-patterns.ts';

/** Dependencies that the instances of a runtime share. */
export interface RuntimeContext {
  readonly nodeId: string;
  readonly clock: Clock;
  readonly topics: TopicPort;
  readonly patterns: SessionPatterns;
  readonly sandboxes: SandboxFactory;
  readonly limits: RuntimeLimits;
  readonly libraries: readonly string[];
  readonly assets: AssetStore | undefined;
  readonly lockstepInputs: 'own' | 'given';
  readonly endOfTurn: EndOfTurn;
  readonly completion: RecordCompletion;
  onEvent(event: ModuleEvent): void;
  onStatus(instanceId: string, status: ProcessingModuleStatus, fault?: ModuleFault): void;
}
