import type { PatternSource } from '@ubii/patterns';
import type { IOMapping } from '@ubii/proto';
import { mappingNeedsPatterns } from '../runtime/binding/session-patterns.ts';
import type { InstanceSpec, ModuleRuntime } from '../runtime/module-runtime.ts';
import type { InstanceStep, PresentInstance } from './reconcile.ts';

/**
 * Takes one step on a runtime.
 *
 * @param present what is there before
 * @param patterns loaded before an instance whose muxers need it [TD-64]
 * @returns what is there after it; a step that is left out later changes nothing of that
 * @throws ModuleFault, or what else a runtime or the loading of patterns rejects with
 */
export async function takeStep(
  step: InstanceStep,
  present: PresentInstance | undefined,
  runtime: ModuleRuntime,
  patterns: PatternSource | undefined,
): Promise<PresentInstance | undefined> {
  const { id } = step;
  if (step.kind === 'destroy') return void (await destroy(runtime, id));
  const { fault, spec } = step.wanted;
  if (step.kind === 'create' || present === undefined) {
    if (fault !== undefined) throw fault;
    await loadPatterns(patterns, spec.mapping);
    await runtime.create(spec);
    return { as: step.wanted, state: 'ready' };
  }
  switch (step.kind) {
    case 'remap':
      await loadPatterns(patterns, spec.mapping);
      runtime.remap(id, spec.mapping);
      return changed(present, { mapping: spec.mapping });
    case 'setMode':
      runtime.setMode(id, spec.module.processingMode);
      return changed(present, { module: spec.module });
    case 'halt':
      await runtime.halt(id);
      return { ...present, state: 'ready' };
    case 'start':
      runtime.start(id);
      return { ...present, state: 'processing' };
  }
}

async function destroy(runtime: ModuleRuntime, id: string): Promise<void> {
  try {
    await runtime.destroy(id);
  } catch {
    // Faults of onHalted and onDestroyed are reported by the runtime; it is gone anyway.
  }
}

async function loadPatterns(
  patterns: PatternSource | undefined,
  mapping: IOMapping,
): Promise<void> {
  if (patterns === undefined || patterns.compiler !== undefined) return;
  if (mappingNeedsPatterns(mapping)) await patterns.load();
}

function changed({ as, state }: PresentInstance, change: Partial<InstanceSpec>): PresentInstance {
  return { as: { ...as, spec: { ...as.spec, ...change } }, state };
}
