import type { ServiceName } from '@ubii/proto';
import type { LessonFacts } from './facts.ts';

/** What a check found. */
export interface Measurement {
  readonly passed: boolean;
  /** What was measured, with its unit; empty while there is nothing to measure. */
  readonly value: string;
}

/** Looks at what runs. */
export interface Check {
  /** Unique within its step. */
  readonly id: string;
  /** What has to be true, as a sentence without a full stop. */
  readonly text: string;
  /** What to do, shown until something is measured. */
  readonly todo: string;
  measure(facts: LessonFacts): Measurement;
}

/** What "Show answer" does in the workspace. */
export type Answer =
  | { readonly kind: 'phones'; readonly count: number }
  /** A finger that draws a circle on each phone of this page, or comes down in its centre. */
  | { readonly kind: 'touch'; readonly gesture: 'circle' | 'tap' }
  | { readonly kind: 'move-pointer' }
  /** Wires and values in the graph, which is then started or applied. */
  | { readonly kind: 'graph'; readonly edit: GraphAnswer }
  | { readonly kind: 'code'; readonly code: string }
  | { readonly kind: 'try-run' }
  | { readonly kind: 'try-topic' }
  | { readonly kind: 'module-session' }
  | { readonly kind: 'call'; readonly service: ServiceName; readonly request?: object }
  | { readonly kind: 'program'; readonly action: 'run' | 'publish' | 'stop' };

export type GraphAnswer = 'wire-in' | 'wire-out' | 'mirror' | 'start';

export interface Step {
  readonly title: string;
  /** One idea, at most 60 words. Identifiers between back-quotes. */
  readonly text: string;
  /** Shown below the text. */
  readonly code?: string;
  /** One to three. */
  readonly checks: readonly Check[];
  readonly answer: Answer;
}

/** What stands beside the lesson. */
export type Workspace =
  | { readonly kind: 'topic' }
  | { readonly kind: 'graph'; readonly graph: 'mirror' | 'many-phones'; readonly phones: boolean }
  | {
      readonly kind: 'module';
      /** The code each step begins with. */
      readonly codes: readonly string[];
    }
  | { readonly kind: 'service'; readonly services: readonly ServiceName[] }
  | { readonly kind: 'program' };

export interface Lesson {
  /** In the address. */
  readonly id: string;
  /** In the contents. */
  readonly title: string;
  readonly heading: string;
  /** At most two sentences. */
  readonly intro: string;
  readonly minutes: number;
  readonly workspace: Workspace;
  /** At most five. */
  readonly steps: readonly Step[];
}
