import type { MeteredPatterns } from '@ubii/patterns';
import {
  DEFAULT_RUNTIME_LIMITS,
  InputBinding,
  parseModule,
  SessionPatterns,
  type EncodedRecord,
} from '@ubii/pm-sandbox';
import type { SessionModule } from '../session-module.ts';
import type { LockstepContext } from './lockstep-context.ts';

interface Bound {
  readonly binding: InputBinding;
  /** Inputs of the binding; other inputs need another binding. */
  readonly inputs: SessionModule['spec']['inputs'];
  mapping: SessionModule['mapping'];
}

/** The inputs of lockstep modules that run elsewhere: the master takes the snapshot for them [SE-40]. */
export class SnapshotInputs {
  readonly #context: LockstepContext;
  readonly #patterns: MeteredPatterns;
  readonly #bound = new Map<string, Bound>();

  /** @param sessionId whose modules they are: their patterns have one budget [PM-71] */
  constructor(context: LockstepContext, sessionId: string) {
    this.#context = context;
    const { patterns, clock } = context;
    this.#patterns = new SessionPatterns(patterns, clock, DEFAULT_RUNTIME_LIMITS).of(sessionId);
  }

  /** The newest records of all inputs of these modules, each topic once. */
  take(modules: readonly SessionModule[]): EncodedRecord[] {
    const records = new Map<string, EncodedRecord>();
    for (const module of modules) {
      for (const record of this.#bind(module).records()) records.set(record.topic, record);
    }
    return [...records.values()];
  }

  /** Lets go of modules that are not among these. */
  keep(modules: readonly SessionModule[]): void {
    const ids = new Set(modules.map(({ id }) => id));
    for (const [id, { binding }] of this.#bound) {
      if (ids.has(id)) continue;
      binding.close();
      this.#bound.delete(id);
    }
  }

  close(): void {
    this.keep([]);
  }

  #bind(module: SessionModule): InputBinding {
    const { spec, mapping } = module;
    const bound = this.#bound.get(module.id);
    if (bound !== undefined && bound.inputs === spec.inputs) {
      if (bound.mapping !== mapping) {
        bound.mapping = mapping;
        bound.binding.rebind(mapping);
      }
      return bound.binding;
    }
    bound?.binding.close();
    const { topics } = this.#context;
    const binding = new InputBinding(parseModule(spec).inputs, mapping, {
      topics,
      patterns: this.#patterns,
      maxMuxElements: DEFAULT_RUNTIME_LIMITS.maxMuxElements,
      maxWaitingEvents: () => 0,
      onMark: () => undefined,
      // The node that runs the module finds the same, and tells it.
      onProblem: () => undefined,
    });
    this.#bound.set(module.id, { binding, inputs: spec.inputs, mapping });
    return binding;
  }
}
