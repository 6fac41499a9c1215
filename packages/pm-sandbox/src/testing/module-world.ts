import type { PatternCompiler } from '@ubii/patterns';
import { Re2Patterns } from '@ubii/patterns/re2';
import {
  fromJson,
  type IOMapping,
  type ModuleEvent,
  type ProcessingMode,
  type ProcessingModule,
  type ProcessingModuleStatus,
} from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import type { AssetStore } from '../assets/asset-store.ts';
import type { RuntimeLimits } from '../limits.ts';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { SandboxFactory } from '../ports/sandbox.ts';
import { createModuleRuntime } from '../runtime/create-module-runtime.ts';
import type { InstanceSpec, ModuleRuntime } from '../runtime/module-runtime.ts';
import { FakeSandboxes } from './fake-sandboxes.ts';
import { FakeTopics } from './fake-topics.ts';

/** A module in few words. */
export interface ModuleSketch {
  readonly id?: string;
  readonly name?: string;
  readonly mode?: ProcessingMode;
  readonly libraries?: readonly string[];
  readonly assets?: readonly string[];
  readonly optionalAssets?: readonly string[];
  readonly isTrusted?: boolean;
  /** Data formats by name. */
  readonly inputs?: Readonly<Record<string, string>>;
  readonly outputs?: Readonly<Record<string, string>>;
  /** A record member as JSON, by input. */
  readonly defaults?: Readonly<Record<string, string>>;
  /** A topic, a muxer, or `{ constant }`, by input. */
  readonly from?: Readonly<Record<string, string | { constant: unknown } | object>>;
  /** A topic or a demuxer, by output. */
  readonly to?: Readonly<Record<string, string | object>>;
}

/** A runtime with fakes around it, and what it told. */
export interface ModuleWorld {
  readonly clock: FakeClock;
  readonly topics: FakeTopics;
  readonly sandboxes: FakeSandboxes;
  readonly runtime: ModuleRuntime;
  readonly events: ModuleEvent[];
  readonly statuses: { id: string; status: ProcessingModuleStatus; fault?: ModuleFault }[];
  /** Creates and starts an instance, and ends the turn. */
  begin(sketch?: ModuleSketch): Promise<void>;
}

/**
 * Makes one.
 *
 * @param parts what is to be used in place of a fake
 */
export function createModuleWorld(
  limits: Partial<RuntimeLimits> = {},
  libraries: readonly string[] = [],
  parts: {
    readonly clock?: FakeClock;
    readonly sandboxes?: SandboxFactory;
    readonly lockstepInputs?: 'own' | 'given';
    readonly patterns?: PatternCompiler;
    readonly assets?: AssetStore;
  } = {},
): ModuleWorld {
  const { clock = new FakeClock() } = parts;
  const topics = new FakeTopics('node-1');
  const sandboxes = new FakeSandboxes();
  const events: ModuleEvent[] = [];
  const statuses: ModuleWorld['statuses'] = [];
  const runtime = createModuleRuntime({
    nodeId: 'node-1',
    clock,
    topics,
    sandboxes: parts.sandboxes ?? sandboxes,
    limits,
    libraries,
    assets: parts.assets,
    lockstepInputs: parts.lockstepInputs,
    patterns: parts.patterns ?? new Re2Patterns(),
    onEvent: (event) => events.push(event),
    onStatus: (id, status, fault) =>
      statuses.push(fault === undefined ? { id, status } : { id, status, fault }),
  });
  const begin = async (sketch: ModuleSketch = {}): Promise<void> => {
    const spec = instanceSpec(sketch);
    await runtime.create(spec);
    runtime.start(spec.module.id);
    await clock.endTurn();
  };
  return { clock, topics, sandboxes, runtime, events, statuses, begin };
}

/** The complete specification of a sketch. */
export function instanceSpec(sketch: ModuleSketch = {}): InstanceSpec {
  const { id = 'pm-1', name = 'module', inputs = {}, outputs = {} } = sketch;
  const { libraries = [], assets = [], optionalAssets = [], isTrusted = false } = sketch;
  const ios = (
    formats: Readonly<Record<string, string>>,
    defaults: Readonly<Record<string, string>> = {},
  ) =>
    Object.entries(formats).map(([internalName, messageFormat]) => ({
      internalName,
      messageFormat,
      defaultJson: defaults[internalName] ?? '',
    }));
  const module: ProcessingModule = fromJson('ubii.processing.ProcessingModule', {
    id,
    name,
    sessionId: 'session-1',
    inputs: ios(inputs, sketch.defaults),
    outputs: ios(outputs),
    onProcessingStringified: '() => {}',
    extension: { libraries, assets, optionalAssets },
  });
  return {
    module: { ...module, processingMode: sketch.mode },
    mapping: ioMapping(sketch),
    isTrusted,
  };
}

/** The mapping of a sketch. */
export function ioMapping({ id = 'pm-1', from = {}, to = {} }: ModuleSketch): IOMapping {
  return fromJson('ubii.sessions.IOMapping', {
    processingModuleId: id,
    inputMappings: Object.entries(from).map(([inputName, source]) => {
      if (typeof source === 'string') return { inputName, topic: source };
      if ('constant' in source) return { inputName, constantJson: JSON.stringify(source.constant) };
      return { inputName, topicMux: source };
    }),
    outputMappings: Object.entries(to).map(([outputName, destination]) =>
      typeof destination === 'string'
        ? { outputName, topic: destination }
        : { outputName, topicDemux: destination },
    ),
  });
}
