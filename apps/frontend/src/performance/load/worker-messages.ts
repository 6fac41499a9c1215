import type { Findings } from '../measure/findings.ts';
import type { Progress } from '../measure/test-run.ts';
import type { LoadParameters } from './load-parameters.ts';

export type ToLoadWorker =
  | { readonly kind: 'start'; readonly url: string; readonly parameters: LoadParameters }
  | { readonly kind: 'stop' };

export type FromLoadWorker =
  /** A client was registered or removed. */
  | { readonly kind: 'joined' | 'left'; readonly clientId: string }
  | { readonly kind: 'progress'; readonly progress: Progress }
  | { readonly kind: 'done'; readonly findings: Findings }
  | { readonly kind: 'failed'; readonly reason: string };
