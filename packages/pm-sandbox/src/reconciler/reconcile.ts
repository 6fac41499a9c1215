import { isSameValue } from '@ubii/proto';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { InstanceSpec } from '../runtime/module-runtime.ts';
import { identityChanges, moduleIdentity } from './module-identity.ts';

/** An instance as its session wants it. */
export interface WantedInstance {
  readonly spec: InstanceSpec;
  /** True: it is to be there, but not to process. [SE-14] */
  readonly isPaused: boolean;
  /** Of the session's specification: with another one, an instance that failed is tried again. [SE-15] */
  readonly revision: number;
  /** Why it cannot be made, if that is known beforehand. */
  readonly fault?: ModuleFault | undefined;
}

/** Existing instance on a node. */
export interface PresentInstance {
  /** Specification that it was created from, with changes applied since. */
  readonly as: WantedInstance;
  /** `failed`: it could not be made, or was given up. `ready`: it is there and does not process. */
  readonly state: 'ready' | 'processing' | 'failed';
}

/** An instance to be compared with what is wanted. */
export interface RunningInstance extends PresentInstance {
  /** It was not wanted at some moment since it was made: it ends, although it may be wanted again. [SE-13] */
  readonly wasStopped: boolean;
}

/** One call of a `ModuleRuntime`. */
export type InstanceStep =
  | { readonly kind: 'destroy'; readonly id: string }
  | {
      readonly kind: 'create' | 'remap' | 'setMode' | 'halt' | 'start';
      readonly id: string;
      readonly wanted: WantedInstance;
    };

/**
 * Compares the instances of a node with those that are wanted, and returns the steps from one to the other. First all
 * that end, in the order they run in, which frees what others need; then, in the order they are wanted in, `create`,
 * `remap`, `setMode` and last `halt` or `start` of each. A restart is `destroy` and `create`. An instance that failed
 * stays failed until its identity or the revision of its session changes.
 *
 * @param wanted each id once
 * @param running each id once
 */
export function reconcile(
  wanted: readonly WantedInstance[],
  running: readonly RunningInstance[],
): InstanceStep[] {
  const wantedById = new Map(wanted.map((one) => [instanceId(one), one]));
  const staying = new Map<string, RunningInstance>();
  const steps: InstanceStep[] = [];
  for (const one of running) {
    const id = instanceId(one.as);
    const next = wantedById.get(id);
    if (next !== undefined && canStay(one, next)) staying.set(id, one);
    else steps.push({ kind: 'destroy', id });
  }
  for (const one of wanted) {
    const id = instanceId(one);
    for (const kind of stepsTo(one, staying.get(id))) steps.push({ kind, id, wanted: one });
  }
  return steps;
}

/** Returns the id of the instance. */
export function instanceId({ spec }: WantedInstance): string {
  return spec.module.id;
}

function canStay({ as, state, wasStopped }: RunningInstance, next: WantedInstance): boolean {
  if (wasStopped || (state === 'failed' && as.revision !== next.revision)) return false;
  if (as === next) return true;
  const changes = identityChanges(moduleIdentity(as.spec), moduleIdentity(next.spec));
  return changes.length === 0 && isSameValue(as.fault, next.fault);
}

function* stepsTo(
  { spec, isPaused }: WantedInstance,
  present: RunningInstance | undefined,
): Iterable<Exclude<InstanceStep['kind'], 'destroy'>> {
  if (present?.state === 'failed') return;
  if (present === undefined) {
    yield 'create';
  } else {
    const { mapping, module } = present.as.spec;
    if (!isSameValue(mapping, spec.mapping)) yield 'remap';
    if (!isSameValue(module.processingMode, spec.module.processingMode)) yield 'setMode';
  }
  const isProcessing = present?.state === 'processing';
  if (isProcessing && isPaused) yield 'halt';
  if (!isProcessing && !isPaused) yield 'start';
}
