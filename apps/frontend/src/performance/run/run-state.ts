import type { TestKind } from '../measure/findings.ts';
import type { Progress } from '../measure/test-run.ts';

/** What the page's one test does: two at once would measure each other. */
export type RunState =
  | { readonly status: 'idle' }
  | {
      readonly status: 'running';
      readonly kind: TestKind;
      readonly progress: Progress;
      /** Stopped by the user; cleans up. */
      readonly isEnding: boolean;
    }
  | { readonly status: 'done'; readonly kind: TestKind; readonly resultId: string }
  | { readonly status: 'failed'; readonly kind: TestKind; readonly reason: string };
