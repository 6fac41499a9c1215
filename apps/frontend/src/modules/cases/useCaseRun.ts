import { lazyPatterns } from '@ubii/patterns';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import type { ProcessingModule } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
import type { ModuleCase } from './module-case.ts';
import { runCase, type CaseResult } from './run-case.ts';

/** Runs test cases in the sandboxes of this page. */
export interface CaseRun {
  readonly isRunning: Readonly<ShallowRef<boolean>>;
  readonly result: ShallowRef<CaseResult | undefined>;
  /** Why it could not be run. */
  readonly problem: ShallowRef<string | undefined>;
  run(theCase: ModuleCase, module: ProcessingModule): Promise<void>;
}

export function useCaseRun(openSandboxes: () => Promise<SandboxFactory>): CaseRun {
  const patterns = lazyPatterns();
  const isRunning = shallowRef(false);
  const result = shallowRef<CaseResult>();
  const problem = shallowRef<string>();
  return {
    isRunning,
    result,
    problem,
    async run(theCase, module) {
      isRunning.value = true;
      result.value = undefined;
      problem.value = undefined;
      try {
        const [sandboxes, compiler] = await Promise.all([openSandboxes(), patterns.load()]);
        result.value = await runCase(theCase, module, sandboxes, compiler);
      } catch (error) {
        problem.value = error instanceof Error ? error.message : String(error);
      } finally {
        isRunning.value = false;
      }
    },
  };
}
