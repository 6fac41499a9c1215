import type { TestKind } from '../measure/findings.ts';
import type { Progress } from '../measure/test-run.ts';

/** State of the only running test: two at once would affect each other. */
export type RunState =
  | { readonly status: 'idle' }
  | {
      readonly status: 'running';
      readonly kind: TestKind;
      readonly progress: Progress;
      /** Stopped by the user; cleaning up. */
      readonly isEnding: boolean;
    }
  | { readonly status: 'done'; readonly kind: TestKind; readonly resultId: string }
  | { readonly status: 'failed'; readonly kind: TestKind; readonly reason: string };
